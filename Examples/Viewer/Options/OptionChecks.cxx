// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionChecks.h"

#include "Files/MeshReader.h"
#include "Options/UsageError.h"
#include "Options/ViewerArguments.h"
#include "Options/ViewerOptions.h"

#include "vtkLICSettings.h"
#include "vtkReliefMapper.h"
#include "vtkVolumeMapper.h"

#include <set>
#include <vector>

namespace
{
// Options for the view and the picture, valid for all inputs.
const std::set<std::string> OfAll = { "--center", "--no-legend", "--output", "--size", "--stats",
  "--up", "--view", "--zoom" };

bool IsOneOf(const std::string& option, const std::set<std::string>& options)
{
  return options.count(option) > 0;
}

class Checks
{
public:
  Checks(ViewerOptions& options, const std::map<std::string, std::string>& given)
    : Options(options)
    , Given(given)
  {
  }

  void Check()
  {
    this->CheckVolume();
    this->CheckContact();
    this->CheckRelief();
    this->CheckSurface();
    this->CheckPatches();
    this->CheckFlow();
    this->CheckLevels();
    this->ReadPlaces();
  }

private:
  void RequirePartner(
    const std::vector<std::string>& names, bool isUseful, const std::string& partner)
  {
    for (const std::string& option : names)
    {
      if (this->Given.count(option) && !isUseful)
      {
        throw UsageError(option + " goes with " + partner);
      }
    }
  }

  // Files with other extensions are height maps.
  void RequireMesh(const std::vector<std::string>& names)
  {
    this->RequirePartner(names, this->Options.IsMesh,
      this->Options.IsDatabase ? "meshes"
                               : "meshes, and '" + this->Options.Input +
          "' is read as a height map; meshes are read from " + GetMeshFormats());
  }

  // A volume has no surface to refine.
  void CheckVolume()
  {
    const ViewerOptions& options = this->Options;
    this->RequireMesh({ "--volume" });
    const std::set<std::string> ofVolumes = { "--blend", "--clip", "--integration", "--isosurfaces",
      "--transfer", "--unit-distance", "--volume", "--volume-method" };
    for (const auto& given : this->Given)
    {
      const std::string& option = given.first;
      if (options.IsVolume && !IsOneOf(option, ofVolumes) && !IsOneOf(option, OfAll) &&
        option != "--light")
      {
        throw UsageError(option + " does not go with --volume");
      }
      if (!options.IsVolume && IsOneOf(option, ofVolumes))
      {
        throw UsageError(option + " goes with --volume");
      }
    }
    const int blend = options.BlendMode;
    this->RequirePartner({ "--isosurfaces" },
      blend == vtkVolumeMapper::COMPOSITE_BLEND || blend == vtkVolumeMapper::ISOSURFACE_BLEND,
      "--blend composite or isosurface");
    this->RequirePartner({ "--unit-distance" },
      blend == vtkVolumeMapper::COMPOSITE_BLEND || blend == vtkVolumeMapper::ADDITIVE_BLEND,
      "--blend composite or additive");
    if (this->Given.count("--transfer") && options.Transfer.empty())
    {
      throw UsageError("--transfer needs the name of a file");
    }
  }

  // Two meshes are drawn unrefined.
  void CheckContact()
  {
    const bool hasOther = !this->Options.Against.empty();
    this->RequireMesh({ "--against" });
    this->RequirePartner({ "--contact-distance" }, hasOther, "--against");
    const std::set<std::string> others = { "--against", "--center", "--contact-distance", "--light",
      "--output", "--size", "--up", "--view", "--zoom" };
    for (const auto& given : this->Given)
    {
      if (hasOther && !IsOneOf(given.first, others))
      {
        throw UsageError(given.first + " does not go with --against");
      }
    }
  }

  // Reliefs have no surface to refine, and their light was captured.
  void CheckRelief()
  {
    const ViewerOptions& options = this->Options;
    if (options.IsDatabase)
    {
      for (const auto& given : this->Given)
      {
        if (!IsOneOf(given.first, OfAll) &&
          !IsOneOf(given.first, { "--relief-method", "--relief-search" }))
        {
          throw UsageError(given.first + " does not go with a folder of reliefs");
        }
      }
    }
    this->RequirePartner({ "--relief-method", "--relief-search" },
      options.Relief.has_value() || options.IsDatabase, "--relief or a folder of reliefs");
    this->RequirePartner({ "--relief-search" },
      options.ReliefMethod == vtkReliefMapper::METHOD_RAY_MARCH, "--relief-method march");
  }

  void CheckSurface()
  {
    const ViewerOptions& options = this->Options;
    using Surface = ViewerOptions::SurfaceType;
    this->RequirePartner({ "--exaggeration", "--imagery-bands", "--resolution", "--stretch" },
      options.IsTerrain(), "height maps");
    this->RequireMesh({ "--array", "--feature-angle", "--height", "--mapping" });
    this->RequirePartner({ "--up" }, !options.IsTerrain(), "meshes");
    const bool hasHeights = !options.IsMesh || !options.Heights.empty();
    this->RequirePartner({ "--scale", "--offset" }, options.IsMesh && hasHeights, "--height");
    this->RequirePartner({ "--no-data", "--no-data-value" }, hasHeights, "--height");
    this->RequirePartner(
      { "--mapping" }, hasHeights || !options.Imagery.empty(), "--height or --image");
    this->RequirePartner({ "--alpha" }, options.GetSurface() == Surface::Phong, "--surface phong");
    this->RequirePartner({ "--amplitude", "--frequency" },
      options.GetSurface() == Surface::Procedural, "--surface procedural");
  }

  // The file has not been read, so it may or may not have curved cells.
  void CheckPatches()
  {
    const ViewerOptions& options = this->Options;
    using Metric = ViewerOptions::MetricType;
    const bool canBePatch = options.IsMesh && (!options.Surface || options.IsPatch());
    this->RequirePartner({ "--isolines", "--patch-edges" }, canBePatch, "--surface patch");
    this->RequirePartner(
      { "--isolines", "--patch-edges" }, options.Vectors.empty(), "surfaces without --lic");
    this->RequirePartner({ "--feature-angle" }, !options.IsPatch(), "other surfaces than patch");
    this->RequireMesh({ "--hair" });
    if (options.Hairs == 0)
    {
      this->CheckError(canBePatch, options.Metric.value_or(Metric::Error) == Metric::Error);
    }
  }

  void CheckError(bool canBePatch, bool isOfMetric)
  {
    if (this->Given.count("--error") && !this->Options.IsMesh)
    {
      throw UsageError("--error works with meshes that have curved cells, and '" +
        this->Options.Input + "' is not read as a mesh; use --level or --max-level");
    }
    if (this->Given.count("--error") && this->Options.UniformLevel)
    {
      throw UsageError("--error cannot be combined with --level");
    }
    this->RequirePartner({ "--error" }, canBePatch, "--surface patch");
    this->RequirePartner({ "--error" }, isOfMetric, "--metric error");
  }

  void CheckFlow()
  {
    const ViewerOptions& options = this->Options;
    const bool hasFlow = !options.Vectors.empty();
    this->RequireMesh({ "--lic" });
    this->RequirePartner({ "--lic-contrast", "--lic-intensity", "--lic-mode", "--lic-phase",
                           "--lic-step-size", "--lic-steps" },
      hasFlow, "--lic");
    this->RequirePartner({ "--lic-intensity" },
      options.LICMode.value_or(vtkLICSettings::COLOR_MODE_BLEND) ==
        vtkLICSettings::COLOR_MODE_BLEND,
      "--lic-mode blend");
  }

  void CheckLevels()
  {
    const ViewerOptions& options = this->Options;
    using Metric = ViewerOptions::MetricType;
    for (const char* option : { "--metric", "--max-level", "--per-edge" })
    {
      if (options.UniformLevel && this->Given.count(option))
      {
        throw UsageError(std::string(option) + " cannot be combined with --level");
      }
    }
    this->RequirePartner({ "--pixels" },
      options.GetMetric() == Metric::ScreenEdge && !options.UniformLevel, "--metric screen-edge");
    this->RequirePartner({ "--reach" },
      options.GetMetric() == Metric::Distance && !options.UniformLevel, "--metric distance");
    this->RequirePartner({ "--region" }, options.GetMetric() == Metric::Region, "--metric region");
    if (options.Budget > 0 && !options.Export.empty())
    {
      throw UsageError("--budget does not go with --export: it limits what is drawn");
    }
  }

  // For a height map, two coordinates are enough.
  void ReadPlaces()
  {
    ViewerOptions& options = this->Options;
    if (this->Given.count("--region"))
    {
      options.Region = ToNumbers(
        "--region", this->Given.at("--region"), options.IsMesh ? "X,Y,Z,RADIUS" : "X,Y,RADIUS");
      if (options.Region->back() <= 0.0)
      {
        throw UsageError(
          "--region needs a radius above 0, not '" + this->Given.at("--region") + "'");
      }
    }
    if (this->Given.count("--center"))
    {
      const std::string& value = this->Given.at("--center");
      options.CenterDegrees = ToDegrees("--center", value);
      if (!options.CenterDegrees)
      {
        options.Center = ToPlace("--center", value, !options.IsTerrain());
      }
      else if (!options.IsTerrain())
      {
        throw UsageError("--center in degrees goes with height maps; give X,Y,Z");
      }
    }
  }

  ViewerOptions& Options;
  const std::map<std::string, std::string>& Given;
};
}

//------------------------------------------------------------------------------
void CheckOptions(ViewerOptions& options, const std::map<std::string, std::string>& given)
{
  Checks(options, given).Check();
}
