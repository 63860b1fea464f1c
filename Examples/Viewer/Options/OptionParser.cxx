// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionParser.h"

#include "Files/ResultFormats.h"
#include "Files/ViewerExport.h"
#include "Options/OptionChecks.h"
#include "Options/Palettes.h"
#include "Options/SessionFile.h"
#include "Options/UsageError.h"
#include "Options/ViewerArguments.h"

#include "vtkAdaptiveRefinementMapper.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkLICSettings.h"
#include "vtkReliefMapper.h"
#include "vtkVolumeMapper.h"

#include <vtksys/SystemTools.hxx>

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace
{
// A folder, or the table in it.
bool IsReliefDatabase(const std::string& name)
{
  return vtksys::SystemTools::FileIsDirectory(name) ||
    vtksys::SystemTools::GetFilenameName(name) == "data.csv";
}

const int HighestLevel = 7;
const int LargestResolution = 4096;
const int SmallestMemory = 16;         // MiB
const int LargestMemory = 1024 * 1024; // MiB
const int MaximumSteps = 1000;
const int MaximumHairs = 10000000;
const int MaximumIsolines = 1000;
const int MaximumSeeds = 100000;
const int LargestPort = 65535;
const double LowestError = 0.001; // the smallest ScreenSpaceError
const double HighestError = 1e6;
const double LowestTolerance = 1e-6; // of curved cells
const double LowestZoom = 0.001;
const double HighestZoom = 1e6;

// The options that say what to do, not what to show. Sessions do not have them.
const std::set<std::string> Actions = { "--capture", "--export", "--height-at", "--help", "-h",
  "--micromesh", "--output", "--save-script", "--save-session", "--save-source", "--serve",
  "--session", "--stats", "--version" };

using Flags = std::map<std::string, std::function<void()>>;
using Setter = std::function<void(const std::string& option, const std::string& value)>;
using Settings = std::map<std::string, Setter>;

// CheckOptions() reads positions later, when the kind of FILE is known.
void ReadLater(const std::string&, const std::string&)
{
}

// Reads the options one by one, then checks their combinations.
class Parser
{
public:
  Parser()
  {
    this->AddFlags();
    this->AddSurface();
    this->AddTerrain();
    this->AddMesh();
    this->AddPatches();
    this->AddFlow();
    this->AddVolume();
    this->AddInside();
    this->AddContact();
    this->AddRelief();
    this->AddLevels();
    this->AddPicture();
  }

  ViewerOptions Parse(int argc, char* argv[])
  {
    this->ReadSessionOf(argc, argv);
    bool isOption = true;
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      if (isOption && argument == "--")
      {
        isOption = false;
      }
      else if (isOption && argument.size() > 1 && argument[0] == '-')
      {
        i += this->ReadOption(argument, i + 1 < argc ? argv[i + 1] : nullptr);
      }
      else
      {
        this->ReadInput(argument);
      }
    }
    if (this->Options.Help || this->Options.Version)
    {
      return this->Options;
    }
    this->FinishSession();
    if (this->Options.Input.empty())
    {
      throw UsageError("no file is given");
    }
    this->Options.IsDatabase = IsReliefDatabase(this->Options.Input);
    this->Options.IsMesh = IsMeshFile(this->Options.Input);
    CheckOptions(this->Options, this->GivenOptions);
    this->CheckServing();
    return this->Options;
  }

  bool IsOption(const std::string& argument) const
  {
    return argument == "--" || this->AllFlags.count(argument) > 0 ||
      this->AllSettings.count(argument.substr(0, argument.find('='))) > 0;
  }

private:
  void AddFlags()
  {
    ViewerOptions& options = this->Options;
    this->AllFlags = {
      { "--axes", [&] { options.HasAxes = true; } },
      { "--contour-labels", [&] { options.ContourLabels = true; } },
      { "--extremes", [&] { options.HasExtremes = true; } },
      { "--globe", [&] { options.Globe = true; } },
      { "--help", [&] { options.Help = true; } },
      { "-h", [&] { options.Help = true; } },
      { "--log", [&] { options.HasLogColors = true; } },
      { "--no-geomorphing", [&] { options.Geomorphing = false; } },
      { "--no-legend", [&] { options.Legend = false; } },
      { "--patch-edges", [&] { options.PatchEdges = true; } },
      { "--per-edge", [&] { options.PerEdge = true; } },
      { "--scale-bar", [&] { options.HasScaleBar = true; } },
      { "--serve", [&] { options.Serve = 0; } },
      { "--stats", [&] { options.Statistics = true; } },
      { "--stretch", [&] { options.Stretch = true; } },
      { "--version", [&] { options.Version = true; } },
      { "--volume", [&] { options.IsVolume = true; } },
      { "--wireframe", [&] { options.Wireframe = true; } },
    };
  }

  void AddSurface()
  {
    ViewerOptions& options = this->Options;
    const Setter imagery = [&](const auto&, const auto& value) { options.Imagery = value; };
    this->AllSettings.insert({
      { "--alpha",
        [&](const auto& option, const auto& value)
        { options.Alpha = ToNumber(option, value, 0.0, 1.0); } },
      { "--amplitude",
        [&](const auto& option, const auto& value)
        { options.Amplitude = ToNumber(option, value); } },
      { "--frequency",
        [&](const auto& option, const auto& value)
        { options.Frequency = ToNumber(option, value); } },
      { "--image", imagery },
      { "--imagery", imagery },
      { "--no-data",
        [&](const auto& option, const auto& value) {
          options.FillNoData =
            ToChoice<bool>(option, value, { { "hole", false }, { "fill", true } });
        } },
      { "--no-data-value",
        [&](const auto& option, const auto& value)
        { options.NoDataValue = ToSample(option, value); } },
      { "--surface",
        [&](const auto& option, const auto& value)
        {
          using Type = ViewerOptions::SurfaceType;
          options.Surface = ToChoice<Type>(option, value,
            { { "linear", Type::Linear }, { "pn", Type::PNTriangle }, { "phong", Type::Phong },
              { "st", Type::ScalarTagged }, { "procedural", Type::Procedural }, { "g1", Type::G1 },
              { "patch", Type::Patch } });
        } },
    });
  }

  void AddTerrain()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--base",
        [&](const auto& option, const auto& value) { options.Base = ToNumber(option, value); } },
      { "--contours",
        [&](const auto& option, const auto& value)
        { options.Contours = ToPositiveNumber(option, value); } },
      { "--exaggeration",
        [&](const auto& option, const auto& value)
        { options.Exaggeration = ToNumber(option, value); } },
      { "--flight",
        [&](const auto& option, const auto& value)
        { options.Flight = ToFileName(option, value, { ".csv" }); } },
      { "--imagery-bands",
        [&](const auto& option, const auto& value)
        { ToBands(option, value, options.ImageryBands); } },
      { "--memory",
        [&](const auto& option, const auto& value)
        { options.Memory = ToInteger(option, value, SmallestMemory, LargestMemory); } },
      { "--palette",
        [&](const auto& option, const auto& value)
        {
          std::vector<std::pair<std::string, std::string>> choices;
          for (const std::string& name : GetPaletteNames())
          {
            choices.emplace_back(name, name);
          }
          options.Palette = ToChoice<std::string>(option, value, choices);
        } },
      { "--range",
        [&](const auto& option, const auto& value)
        {
          options.Range.reset();
          options.HasRangeOfAllSteps = value == "all";
          if (!options.HasRangeOfAllSteps)
          {
            options.Range = ToRange(option, value);
          }
        } },
      { "--resolution",
        [&](const auto& option, const auto& value)
        { options.Resolution = ToInteger(option, value, 1, LargestResolution); } },
      { "--sea-level",
        [&](const auto& option, const auto& value)
        { options.SeaLevel = ToNumber(option, value); } },
    });
  }

  void AddMesh()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--above",
        [&](const auto& option, const auto& value)
        { options.AboveColor = ToColor(option, value); } },
      { "--array",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of an array");
          }
          options.Array = value;
        } },
      { "--below",
        [&](const auto& option, const auto& value)
        { options.BelowColor = ToColor(option, value); } },
      { "--feature-angle",
        [&](const auto& option, const auto& value)
        { options.FeatureAngle = ToNumber(option, value, 0.0, 180.0); } },
      { "--height", [&](const auto&, const auto& value) { options.Heights = value; } },
      { "--mapping",
        [&](const auto& option, const auto& value)
        {
          using Type = ViewerOptions::MappingType;
          options.Mapping =
            ToChoice<Type>(option, value, { { "sphere", Type::Sphere }, { "plane", Type::Plane } });
        } },
      { "--offset",
        [&](const auto& option, const auto& value) { options.Offset = ToNumber(option, value); } },
      { "--scale",
        [&](const auto& option, const auto& value) { options.Scale = ToNumber(option, value); } },
      { "--time",
        [&](const auto& option, const auto& value) { options.Time = ToNumber(option, value); } },
      { "--up",
        [&](const auto& option, const auto& value) {
          options.UpAxis = ToChoice<int>(option, value, { { "x", 0 }, { "y", 1 }, { "z", 2 } });
        } },
      { "--warp",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of an array of vectors");
          }
          options.Warp = value;
        } },
    });
  }

  void AddPatches()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--hair",
        [&](const auto& option, const auto& value)
        { options.Hairs = ToInteger(option, value, 1, MaximumHairs); } },
      { "--isolines",
        [&](const auto& option, const auto& value)
        { options.Isolines = ToInteger(option, value, 1, MaximumIsolines); } },
    });
  }

  void AddFlow()
  {
    ViewerOptions& options = this->Options;
    using LIC = vtkLICSettings;
    this->AllSettings.insert({
      { "--lic",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of an array of vectors");
          }
          options.Vectors = value;
        } },
      { "--lic-contrast",
        [&](const auto& option, const auto& value)
        {
          options.LICContrast = ToChoice<int>(option, value,
            { { "off", LIC::ENHANCE_CONTRAST_OFF }, { "lic", LIC::ENHANCE_CONTRAST_LIC },
              { "color", LIC::ENHANCE_CONTRAST_COLOR }, { "both", LIC::ENHANCE_CONTRAST_BOTH } });
        } },
      { "--lic-intensity",
        [&](const auto& option, const auto& value)
        { options.LICIntensity = ToNumber(option, value, 0.0, 1.0); } },
      { "--lic-mode",
        [&](const auto& option, const auto& value)
        {
          options.LICMode = ToChoice<int>(option, value,
            { { "blend", LIC::COLOR_MODE_BLEND }, { "multiply", LIC::COLOR_MODE_MAP } });
        } },
      { "--lic-phase",
        [&](const auto& option, const auto& value)
        { options.LICPhase = ToNumber(option, value); } },
      { "--lic-step-size",
        [&](const auto& option, const auto& value)
        { options.LICStepSize = ToPositiveNumber(option, value); } },
      { "--lic-steps",
        [&](const auto& option, const auto& value)
        { options.LICSteps = ToInteger(option, value, 1, MaximumSteps); } },
    });
  }

  void AddVolume()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--blend",
        [&](const auto& option, const auto& value)
        {
          using Mapper = vtkVolumeMapper;
          options.BlendMode = ToChoice<int>(option, value,
            { { "composite", Mapper::COMPOSITE_BLEND },
              { "maximum", Mapper::MAXIMUM_INTENSITY_BLEND },
              { "minimum", Mapper::MINIMUM_INTENSITY_BLEND },
              { "average", Mapper::AVERAGE_INTENSITY_BLEND },
              { "additive", Mapper::ADDITIVE_BLEND }, { "isosurface", Mapper::ISOSURFACE_BLEND } });
        } },
      { "--clip",
        [&](const auto& option, const auto& value) { options.Clip = ToPlane(option, value); } },
      { "--field-tolerance",
        [&](const auto& option, const auto& value)
        { options.FieldTolerance = ToNumber(option, value, LowestTolerance, 1.0); } },
      { "--integration",
        [&](const auto& option, const auto& value)
        {
          using Mapper = vtkGPUUnstructuredGridVolumeMapper;
          options.Integration = ToChoice<int>(option, value,
            { { "exact", Mapper::EXACT }, { "pre", Mapper::PRE_INTEGRATED },
              { "pre2d", Mapper::PRE_INTEGRATED_2D } });
        } },
      { "--isosurfaces",
        [&](const auto& option, const auto& value)
        { options.IsoSurfaces = ToList(option, value); } },
      { "--shape-tolerance",
        [&](const auto& option, const auto& value)
        { options.ShapeTolerance = ToNumber(option, value, LowestTolerance, 1.0); } },
      { "--transfer", [&](const auto&, const auto& value) { options.Transfer = value; } },
      { "--unit-distance",
        [&](const auto& option, const auto& value)
        { options.UnitDistance = ToPositiveNumber(option, value); } },
      { "--volume-method",
        [&](const auto& option, const auto& value)
        {
          using Mapper = vtkGPUUnstructuredGridVolumeMapper;
          options.VolumeMethod = ToChoice<int>(option, value,
            { { "ray", Mapper::RAY_CASTING }, { "projection", Mapper::CELL_PROJECTION } });
        } },
    });
  }

  // Objects inside of cells.
  void AddInside()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--integration-points",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of an array of values at these points");
          }
          options.IntegrationPoints = value;
        } },
      { "--seed-line",
        [&](const auto& option, const auto& value)
        { options.SeedLine = ToNumbers(option, value, "X,Y,Z,X,Y,Z"); } },
      { "--seeds",
        [&](const auto& option, const auto& value)
        { options.Seeds = ToInteger(option, value, 1, MaximumSeeds); } },
      { "--streamlines",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of an array of vectors");
          }
          options.Streamlines = value;
        } },
    });
  }

  void AddContact()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--against",
        [&](const auto& option, const auto& value)
        {
          if (!IsMeshFile(value))
          {
            throw UsageError(option + " needs a mesh, not '" + value + "'");
          }
          options.Against = value;
        } },
      { "--contact-distance",
        [&](const auto& option, const auto& value) {
          options.ContactDistance =
            ToNumber(option, value, 0.0, std::numeric_limits<double>::max());
        } },
    });
  }

  void AddRelief()
  {
    ViewerOptions& options = this->Options;
    using Mapper = vtkReliefMapper;
    this->AllSettings.insert({
      { "--capture",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of a folder");
          }
          options.Capture = value;
        } },
      { "--relief",
        [&](const auto& option, const auto& value)
        {
          using Type = ViewerOptions::ReliefType;
          options.Relief = ToChoice<Type>(option, value,
            { { "box", Type::Box }, { "sphere", Type::Sphere }, { "view", Type::View } });
        } },
      { "--relief-method",
        [&](const auto& option, const auto& value)
        {
          options.ReliefMethod = ToChoice<int>(option, value,
            { { "automatic", Mapper::METHOD_AUTOMATIC }, { "march", Mapper::METHOD_RAY_MARCH },
              { "refinement", Mapper::METHOD_REFINEMENT }, { "warp", Mapper::METHOD_WARP } });
        } },
      { "--relief-search",
        [&](const auto& option, const auto& value)
        {
          options.ReliefSearch = ToChoice<int>(option, value,
            { { "mipmap", Mapper::SEARCH_MAXIMUM_MIPMAP },
              { "linear-binary", Mapper::SEARCH_LINEAR_BINARY },
              { "linear-secant", Mapper::SEARCH_LINEAR_SECANT },
              { "cones", Mapper::SEARCH_RELAXED_CONES } });
        } },
    });
  }

  void AddLevels()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--budget",
        [&](const auto& option, const auto& value)
        { options.Budget = ToInteger(option, value, 1, std::numeric_limits<int>::max()); } },
      { "--error",
        [&](const auto& option, const auto& value)
        { options.Error = ToNumber(option, value, LowestError, HighestError); } },
      { "--level",
        [&](const auto& option, const auto& value)
        { options.UniformLevel = ToInteger(option, value, 0, HighestLevel); } },
      { "--max-level",
        [&](const auto& option, const auto& value)
        { options.MaximumLevel = ToInteger(option, value, 0, HighestLevel); } },
      { "--method",
        [&](const auto& option, const auto& value)
        {
          using Mapper = vtkAdaptiveRefinementMapper;
          options.Method = ToChoice<int>(option, value,
            { { "arkfpi", Mapper::METHOD_ARKFPI }, { "ark", Mapper::METHOD_ARK },
              { "dmr", Mapper::METHOD_DMR }, { "suapt", Mapper::METHOD_SUAPT },
              { "tessellation", Mapper::METHOD_HARDWARE_TESSELLATION },
              { "uniform", Mapper::METHOD_UNIFORM } });
        } },
      { "--metric",
        [&](const auto& option, const auto& value)
        {
          using Type = ViewerOptions::MetricType;
          options.Metric = ToChoice<Type>(option, value,
            { { "distance", Type::Distance }, { "screen-edge", Type::ScreenEdge },
              { "curvature", Type::Curvature }, { "silhouette", Type::Silhouette },
              { "contour", Type::Contour }, { "view-dependent", Type::ViewDependent },
              { "field", Type::Field }, { "region", Type::Region }, { "error", Type::Error },
              { "control-net", Type::ControlNet }, { "height", Type::Height } });
        } },
      { "--pixels",
        [&](const auto& option, const auto& value)
        { options.Pixels = ToPositiveNumber(option, value); } },
      { "--reach",
        [&](const auto& option, const auto& value)
        { options.Reach = ToPositiveNumber(option, value); } },
      { "--region", ReadLater },
      { "--segments",
        [&](const auto& option, const auto& value)
        {
          options.WholeSegments =
            ToChoice<bool>(option, value, { { "powers", false }, { "whole", true } });
        } },
      { "--tolerance",
        [&](const auto& option, const auto& value)
        {
          const bool isShare = !value.empty() && value.back() == '%';
          const double number =
            ToPositiveNumber(option, isShare ? value.substr(0, value.size() - 1) : value);
          options.Tolerance.reset();
          options.ToleranceShare.reset();
          (isShare ? options.ToleranceShare : options.Tolerance) = isShare ? number / 100 : number;
        } },
    });
  }

  void AddPicture()
  {
    ViewerOptions& options = this->Options;
    this->AllSettings.insert({
      { "--center", ReadLater },
      { "--color-by",
        [&](const auto& option, const auto& value)
        {
          using Type = ViewerOptions::ColorType;
          options.Color = ToChoice<Type>(option, value,
            { { "level", Type::Level }, { "pattern", Type::Pattern }, { "metric", Type::Metric },
              { "height", Type::Height }, { "slope", Type::Slope }, { "aspect", Type::Aspect },
              { "hillshade", Type::Hillshade } });
        } },
      { "--export",
        [&](const auto& option, const auto& value)
        { options.Export = ToFileName(option, value, GetExportExtensions()); } },
      { "--height-at",
        [&](const auto& option, const auto& value)
        { options.HeightAt = ToLongitudeLatitude(option, value); } },
      { "--light",
        [&](const auto& option, const auto& value)
        { options.Light = ToDirection(option, value, 90.0); } },
      { "--micromesh",
        [&](const auto& option, const auto& value)
        { options.MicroMesh = ToFileName(option, value, { ".rmm" }); } },
      { "--output",
        [&](const auto& option, const auto& value)
        { options.Output = ToFileName(option, value, { ".png" }); } },
      { "--ruler",
        [&](const auto& option, const auto& value)
        { options.Ruler = ToNumbers(option, value, "X,Y,Z,X,Y,Z"); } },
      { "--save-script",
        [&](const auto& option, const auto& value)
        { options.SaveScript = ToFileName(option, value, { ".py" }); } },
      { "--save-source",
        [&](const auto& option, const auto& value)
        {
          if (value.empty())
          {
            throw UsageError(option + " needs the name of a folder");
          }
          options.SaveSource = value;
        } },
      { "--save-session",
        [&](const auto& option, const auto& value)
        { options.SaveSession = ToFileName(option, value, { ".json" }); } },
      { "--serve",
        [&](const auto& option, const auto& value)
        { options.Serve = ToInteger(option, value, 0, LargestPort); } },
      { "--session", ReadLater },
      { "--size",
        [&](const auto& option, const auto& value) { ToSize(option, value, options.Size); } },
      { "--view",
        [&](const auto& option, const auto& value)
        {
          const auto view = FindPlanView(value);
          options.View = view ? view : ToDirection(option, value, 90.0);
        } },
      { "--zoom",
        [&](const auto& option, const auto& value)
        { options.Zoom = ToNumber(option, value, LowestZoom, HighestZoom); } },
    });
  }

  void ReadInput(const std::string& argument)
  {
    if (!this->Options.Input.empty())
    {
      throw UsageError(
        "more than one file is given: '" + this->Options.Input + "' and '" + argument + "'");
    }
    this->Options.Input = argument;
  }

  // Returns the number of following arguments that it has used.
  int ReadOption(const std::string& argument, const char* next)
  {
    const auto flag = this->AllFlags.find(argument);
    if (flag != this->AllFlags.end())
    {
      this->GivenOptions[argument];
      flag->second();
      return argument == "--volume" ? this->ReadVolumeArray(next)
        : argument == "--serve"     ? this->ReadPort(next)
                                    : 0;
    }
    // --option VALUE or --option=VALUE
    const std::size_t equals = argument.find('=');
    const std::string option = argument.substr(0, equals);
    if (option == "--volume")
    {
      this->GivenOptions[option] = argument.substr(equals + 1);
      this->Options.IsVolume = true;
      this->Options.VolumeArray = argument.substr(equals + 1);
      return 0;
    }
    const auto setting = this->AllSettings.find(option);
    if (setting == this->AllSettings.end())
    {
      throw UsageError("unknown option '" + option + "'");
    }
    if (equals == std::string::npos && !next)
    {
      throw UsageError(option + " needs a value");
    }
    if (equals == std::string::npos && this->IsOption(next))
    {
      throw UsageError(option + " needs a value, but the option '" + next + "' follows; write " +
        option + "=" + next + " if that is the value");
    }
    const std::string value = equals == std::string::npos ? next : argument.substr(equals + 1);
    this->GivenOptions[option] = value;
    setting->second(option, value);
    return equals == std::string::npos ? 1 : 0;
  }

  // If FILE came before, an array may follow --volume.
  int ReadVolumeArray(const char* next)
  {
    if (this->Options.Input.empty() || !next || next[0] == '-')
    {
      return 0;
    }
    this->Options.VolumeArray = next;
    this->GivenOptions["--volume"] = next;
    return 1;
  }

  // A number may follow --serve.
  int ReadPort(const char* next)
  {
    const std::string text = next ? next : "";
    if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
    {
      return 0;
    }
    this->Options.Serve = ToInteger("--serve", text, 0, LargestPort);
    return 1;
  }

  // The options of a session come first, so that those of the command line override them.
  void ReadSessionOf(int argc, char* argv[])
  {
    const std::string option = "--session";
    for (int i = 1; i < argc && std::string(argv[i]) != "--"; ++i)
    {
      const std::string argument = argv[i];
      if (argument == option && i + 1 < argc)
      {
        this->SessionName = argv[i + 1];
      }
      else if (argument.compare(0, option.size() + 1, option + "=") == 0)
      {
        this->SessionName = argument.substr(option.size() + 1);
      }
    }
    if (this->SessionName.empty())
    {
      return;
    }
    this->Session = ReadSession(this->SessionName);
    for (const auto& own : this->Session.Options)
    {
      this->ReadSessionOption(own.first, own.second);
    }
    this->OptionsOfSession = std::exchange(this->GivenOptions, {});
  }

  void ReadSessionOption(const std::string& option, const std::optional<std::string>& value)
  {
    const std::string place = "--session " + this->SessionName + ": ";
    const bool isFlag = this->AllFlags.count(option) > 0 && option != "--volume";
    if (Actions.count(option) > 0 || (!isFlag && !this->IsOption(option)))
    {
      throw UsageError(place + "unknown option '" + option + "'");
    }
    if (isFlag == value.has_value() && option != "--volume")
    {
      throw UsageError(place + option + (isFlag ? " must be true" : " needs a value"));
    }
    try
    {
      this->ReadOption(value ? option + "=" + *value : option, nullptr);
    }
    catch (const UsageError& error)
    {
      throw UsageError(place + error.what());
    }
  }

  void FinishSession()
  {
    // A session stores the exact camera. Options of the view on the command line replace it.
    const bool hasView = this->GivenOptions.count("--view") || this->GivenOptions.count("--zoom") ||
      this->GivenOptions.count("--center");
    if (!hasView)
    {
      this->Options.Camera = this->Session.Camera;
    }
    this->GivenOptions.insert(this->OptionsOfSession.begin(), this->OptionsOfSession.end());
    if (this->Options.Input.empty())
    {
      this->Options.Input = this->Session.Input;
    }
    for (const auto& given : this->GivenOptions)
    {
      if (Actions.count(given.first) == 0)
      {
        const bool isFlag = this->AllFlags.count(given.first) > 0 && given.second.empty();
        this->Options.Given[given.first] =
          isFlag ? std::nullopt : std::optional<std::string>(given.second);
      }
    }
    for (const char* option :
      { "--session", "--save-script", "--save-session", "--save-source", "--serve" })
    {
      this->GivenOptions.erase(option); // valid for all inputs
    }
  }

  void CheckServing() const
  {
    for (const char* option : { "--against", "--capture", "--export", "--flight", "--height-at",
           "--micromesh", "--output" })
    {
      if (this->Options.Serve && this->GivenOptions.count(option))
      {
        throw UsageError("--serve cannot be combined with " + std::string(option));
      }
    }
    for (const char* option : { "--save-script", "--save-source" })
    {
      if (!(std::string(option) == "--save-script" ? this->Options.SaveScript
                                                   : this->Options.SaveSource)
             .empty() &&
        (this->Options.Output.empty() || this->Options.IsSeries()))
      {
        throw UsageError(std::string(option) + " requires --output with one picture");
      }
    }
    const bool isSaved = !this->Options.SaveSession.empty();
    if (isSaved && (this->Options.HeightAt || this->Options.IsSeries()))
    {
      throw UsageError(std::string("--save-session cannot be combined with ") +
        (this->Options.HeightAt ? "--height-at" : "several pictures"));
    }
  }

  ViewerOptions Options;
  Flags AllFlags;
  Settings AllSettings;
  std::map<std::string, std::string> GivenOptions; // with their values
  std::map<std::string, std::string> OptionsOfSession;
  std::string SessionName;
  ViewerSession Session;
};
}

//------------------------------------------------------------------------------
ViewerOptions ParseOptions(int argc, char* argv[])
{
  return Parser().Parse(argc, argv);
}

//------------------------------------------------------------------------------
bool HasOption(const std::string& name)
{
  return Parser().IsOption(name);
}
