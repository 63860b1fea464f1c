// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionChecks.h"

#include "Files/FramePattern.h"
#include "Files/ResultFormats.h"
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
const std::set<std::string> OfAll = { "--center", "--no-legend", "--output", "--scale-bar",
  "--size", "--stats", "--up", "--view", "--zoom" };

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
    this->CheckMicroMesh();
    this->CheckFlow();
    this->CheckLevels();
    this->CheckTiles();
    this->ReadPlaces();
  }

private:
  // Options that have no effect without another.
  void RequirePartner(
    const std::vector<std::string>& names, bool isUseful, const std::string& partner)
  {
    for (const std::string& option : names)
    {
      if (this->Given.count(option) && !isUseful)
      {
        throw UsageError(option + " requires " + partner);
      }
    }
  }

  void Exclude(const std::vector<std::string>& names, bool isOtherGiven, const std::string& other)
  {
    for (const std::string& option : names)
    {
      if (this->Given.count(option) && isOtherGiven)
      {
        throw UsageError(option + " cannot be combined with " + other);
      }
    }
  }

  // Files with other extensions than those of meshes are height maps.
  void RequireMesh(const std::vector<std::string>& names, const std::string& formats)
  {
    this->RequirePartner(names, this->Options.IsMesh,
      "a mesh, and '" + this->Options.Input +
        (this->Options.IsDatabase
            ? "' is a folder of reliefs"
            : "' is read as a height map" + AdviseFormat(this->Options.Input, formats)));
  }

  void RequireMesh(const std::vector<std::string>& names)
  {
    this->RequireMesh(names, GetMeshFormats());
  }

  // A volume has no surface to refine.
  void CheckVolume()
  {
    const ViewerOptions& options = this->Options;
    this->RequireMesh({ "--volume" }, GetVolumeFormats());
    const std::set<std::string> ofVolumes = { "--blend", "--field-tolerance", "--integration",
      "--isosurfaces", "--shape-tolerance", "--transfer", "--unit-distance", "--volume",
      "--volume-method" };
    for (const auto& given : this->Given)
    {
      const std::string& option = given.first;
      if (options.IsVolume && !IsOneOf(option, ofVolumes) && !IsOneOf(option, OfAll) &&
        !IsOneOf(option,
          { "--above", "--axes", "--below", "--clip", "--extremes", "--light", "--log", "--palette",
            "--range", "--ruler", "--scale", "--time", "--warp" }))
      {
        throw UsageError(option + " cannot be combined with --volume");
      }
      const bool isOfMicroMesh = option == "--isosurfaces" && !options.MicroMesh.empty();
      if (!options.IsVolume && IsOneOf(option, ofVolumes) && !isOfMicroMesh)
      {
        throw UsageError(
          option + " requires --volume" + (option == "--isosurfaces" ? " or --micromesh" : ""));
      }
    }
    const int blend = options.BlendMode;
    this->RequirePartner({ "--isosurfaces" },
      blend == vtkVolumeMapper::COMPOSITE_BLEND || blend == vtkVolumeMapper::ISOSURFACE_BLEND,
      "--blend composite or isosurface");
    this->RequirePartner({ "--unit-distance" },
      blend == vtkVolumeMapper::COMPOSITE_BLEND || blend == vtkVolumeMapper::ADDITIVE_BLEND,
      "--blend composite or additive");
    this->Exclude({ "--above", "--below", "--log", "--palette", "--range" },
      !options.Transfer.empty(), "--transfer");
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
        throw UsageError(given.first + " cannot be combined with --against");
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
          throw UsageError(given.first + " cannot be combined with a folder of reliefs");
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
      options.IsTerrain(), "a height map, and '" + options.Input + "' is a mesh");
    this->RequireMesh({ "--streamlines" }, GetVolumeFormats());
    this->RequirePartner(
      { "--seed-line", "--seeds" }, !options.Streamlines.empty(), "--streamlines");
    this->Exclude({ "--export", "--height", "--imagery", "--image", "--lic", "--micromesh",
                    "--relief", "--capture" },
      !options.Streamlines.empty(), "--streamlines");
    this->RequireMesh({ "--integration-points" }, GetVolumeFormats());
    this->Exclude({ "--array", "--export", "--height", "--imagery", "--image", "--lic",
                    "--micromesh", "--relief", "--capture", "--streamlines" },
      !options.IntegrationPoints.empty(), "--integration-points");
    this->RequireMesh(
      { "--above", "--array", "--axes", "--below", "--clip", "--extremes", "--feature-angle",
        "--height", "--log", "--mapping", "--offset", "--ruler", "--scale", "--time", "--warp" });
    if (options.HasRangeOfAllSteps)
    {
      this->RequireMesh({ "--range" });
    }
    if (options.HasLogColors && options.Range && !((*options.Range)[0] > 0.0))
    {
      throw UsageError("--log needs a --range above 0, not '" + this->Given.at("--range") + "'");
    }
    this->RequirePartner({ "--up" }, !options.IsTerrain(),
      "a mesh, and '" + options.Input + "' is read as a height map");
    const bool hasHeights = !options.IsMesh || !options.Heights.empty();
    const bool isWarped = !options.Warp.empty();
    if (options.IsSeries() && options.Flight.empty() &&
      (!options.IsMesh || !options.Against.empty()))
    {
      throw UsageError(
        "--output " + options.Output + " requires --flight or a mesh with time steps");
    }
    this->Exclude({ "--time" }, options.IsSeries(), "--output " + options.Output);
    this->Exclude({ "--clip", "--warp" }, !options.Heights.empty(), "--height");
    this->Exclude({ "--clip" }, !options.Export.empty(), "--export");
    this->Exclude({ "--clip" }, options.Relief.has_value(), "--relief");
    this->Exclude({ "--clip" }, !options.Capture.empty(), "--capture");
    this->RequirePartner({ "--offset" }, options.IsMesh && hasHeights, "--height");
    this->RequirePartner(
      { "--scale" }, isWarped || (options.IsMesh && hasHeights), "--height or --warp");
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
    this->RequireMesh({ "--hair", "--isolines", "--patch-edges" });
    this->RequirePartner({ "--isolines", "--patch-edges" }, canBePatch, "--surface patch");
    this->Exclude({ "--isolines", "--patch-edges" }, !options.Vectors.empty(), "--lic");
    this->Exclude({ "--isolines" }, options.HasLogColors, "--log");
    this->Exclude({ "--feature-angle" }, options.IsPatch(), "--surface patch");
    if (options.Hairs == 0 && options.GetMetric() != Metric::Height)
    {
      this->RequirePartner({ "--error" }, options.IsMesh, "--metric height");
      this->RequirePartner({ "--error" }, canBePatch, "--surface patch");
      this->RequirePartner(
        { "--error" }, options.Metric.value_or(Metric::Error) == Metric::Error, "--metric error");
    }
  }

  void CheckMicroMesh()
  {
    this->RequireMesh({ "--micromesh" });
    this->Exclude({ "--feature-angle" },
      !this->Options.MicroMesh.empty() && !this->Options.IsoSurfaces.empty(), "--isosurfaces");
    this->Exclude({ "--time" }, IsFramePattern(this->Options.MicroMesh),
      "--micromesh " + this->Options.MicroMesh);
    this->Exclude({ "--clip", "--hair", "--height", "--isolines", "--level", "--lic",
                    "--patch-edges", "--surface", "--volume" },
      !this->Options.MicroMesh.empty(), "--micromesh");
    this->Exclude({ "--micromesh" }, this->Options.IsSeries(), "--output " + this->Options.Output);
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
    this->Exclude(
      { "--error", "--metric", "--max-level", "--per-edge", "--pixels", "--reach", "--tolerance" },
      options.UniformLevel.has_value(), "--level");
    this->RequirePartner(
      { "--pixels" }, options.GetMetric() == Metric::ScreenEdge, "--metric screen-edge");
    this->RequirePartner(
      { "--reach" }, options.GetMetric() == Metric::Distance, "--metric distance");
    this->RequirePartner({ "--region" }, options.GetMetric() == Metric::Region, "--metric region");
    const bool hasHeights = options.IsTerrain() || !options.Heights.empty();
    if (options.Metric == Metric::Height && !hasHeights)
    {
      throw UsageError("--metric height requires a height map: use --height");
    }
    if (options.MicroMesh.empty())
    {
      this->RequirePartner(
        { "--tolerance" }, !options.Export.empty(), options.IsMesh ? "--micromesh" : "--export");
      this->RequirePartner(
        { "--tolerance" }, options.GetMetric() == Metric::Height, "--metric height");
      if (options.ToleranceShare)
      {
        throw UsageError("--tolerance needs a length in metres for a height map, not a percentage");
      }
    }
    this->Exclude({ "--tolerance" }, options.Error.has_value(), "--error");
    if (options.Budget > 0 && !options.Export.empty())
    {
      throw UsageError("--budget cannot be combined with --export: it limits what is drawn");
    }
  }

  // Height maps are drawn in tiles unless an option needs a coarse mesh that is refined by levels,
  // or other samples than those of the file.
  void CheckTiles()
  {
    ViewerOptions& options = this->Options;
    using Color = ViewerOptions::ColorType;
    const Color color = options.Color;
    const bool isOfTerrain = color != Color::Own && !options.IsColoredByLevel();
    this->RequirePartner({ "--base", "--contour-labels", "--contours", "--flight", "--globe",
                           "--memory", "--sea-level" },
      options.IsTerrain(), "a height map, and '" + options.Input + "' is none");
    if (!options.IsTerrain())
    {
      if (isOfTerrain)
      {
        throw UsageError("--color-by " + this->Given.at("--color-by") +
          " requires a height map, and '" + options.Input + "' is none");
      }
      return;
    }
    const std::vector<std::string> ofTable = { "--palette", "--range" };
    this->RequirePartner({ "--contour-labels" }, options.Contours.has_value(), "--contours");
    this->RequirePartner(
      { "--sea-level" }, color == Color::Own || color == Color::Height, "--color-by height");
    this->Exclude({ "--sea-level" }, !options.Imagery.empty(), "a picture (--image)");
    this->Exclude(ofTable, color == Color::Hillshade, "--color-by hillshade");
    this->Exclude({ "--light" }, color == Color::Hillshade, "--color-by hillshade");
    this->Exclude(ofTable, options.IsColoredByLevel(), "--color-by level, pattern or metric");
    this->Exclude(ofTable, !options.Imagery.empty(), "a picture (--image)");
    if (isOfTerrain && !options.Imagery.empty())
    {
      throw UsageError(
        "--color-by " + this->Given.at("--color-by") + " cannot be combined with --image");
    }
    this->CheckFlight();
    const std::string levels = this->FindOptionOfLevels();
    options.IsTiled = levels.empty();
    options.TiledBy = this->FindOptionOfTiles();
    if (!levels.empty() && !options.TiledBy.empty())
    {
      throw UsageError(options.TiledBy + " cannot be combined with " + levels);
    }
  }

  void CheckFlight()
  {
    const ViewerOptions& options = this->Options;
    const bool isFlight = !options.Flight.empty();
    this->RequirePartner({ "--flight" }, options.IsSeries(),
      "--output with a number such as --output 'frames/%04d.png'");
    this->Exclude({ "--center", "--export", "--stats", "--view", "--zoom" }, isFlight, "--flight");
  }

  /// An option that tiles do not support, with its value if that matters, or "".
  std::string FindOptionOfLevels() const
  {
    const ViewerOptions& options = this->Options;
    const double smallestError = 0.01;         // pixels, of vtkTerrainMapper
    const double smallestExaggeration = 0.001; // of vtkTerrainMapper
    for (const char* option :
      { "--alpha", "--amplitude", "--budget", "--capture", "--frequency", "--imagery-bands",
        "--level", "--max-level", "--method", "--metric", "--no-data-value", "--no-geomorphing",
        "--per-edge", "--pixels", "--reach", "--region", "--relief", "--relief-method",
        "--relief-search", "--resolution", "--segments", "--stretch", "--surface" })
    {
      if (this->Given.count(option))
      {
        return option;
      }
    }
    return options.FillNoData                       ? "--no-data fill"
      : options.IsColoredByLevel()                  ? "--color-by " + this->Given.at("--color-by")
      : options.Error.value_or(1.0) < smallestError ? "--error below 0.01"
      : options.Exaggeration.value_or(1.0) < smallestExaggeration ? "--exaggeration below 0.001"
                                                                  : "";
  }

  /// An option that only tiles support, or "".
  std::string FindOptionOfTiles() const
  {
    using Color = ViewerOptions::ColorType;
    for (const char* option :
      { "--base", "--contours", "--flight", "--globe", "--memory", "--sea-level", "--tolerance" })
    {
      if (this->Given.count(option))
      {
        return option;
      }
    }
    const Color color = this->Options.Color;
    return color == Color::Slope || color == Color::Aspect || color == Color::Hillshade
      ? "--color-by " + this->Given.at("--color-by")
      : "";
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
    if (options.HeightAt && !options.IsTerrain())
    {
      throw UsageError("--height-at requires a height map");
    }
    for (const auto& given : this->Given)
    {
      if (options.HeightAt && given.first != "--height-at")
      {
        throw UsageError("--height-at cannot be combined with " + given.first);
      }
    }
    if (this->Given.count("--center"))
    {
      const std::string& value = this->Given.at("--center");
      options.CenterDegrees = ToDegrees("--center", value);
      if (!options.CenterDegrees)
      {
        options.Center = ToPlace("--center", value, !options.IsTerrain());
        if (options.Globe)
        {
          throw UsageError("--globe requires --center in degrees such as 86.925E,27.988N");
        }
      }
      else if (!options.IsTerrain())
      {
        throw UsageError("--center in degrees requires a height map; give X,Y,Z");
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
