// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainMapper.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/FaceMesh.h"
#include "Bisection/GlobeFaces.h"
#include "Buffers/ColorTable.h"
#include "Buffers/GlobeVertices.h"
#include "Changes/Dependencies.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Checks/ShouldReport.h"
#include "Colors/TerrainTables.h"
#include "Composite/LeafSelection.h"
#include "Drawing/TerrainPainter.h"
#include "Imagery/OpenImagery.h"
#include "Lattice/HeightLattice.h"
#include "Mathematics/SameNumber.h"
#include "OpenGL/ContextWatch.h"
#include "Parallel/ProcessReduction.h"
#include "Picking/PickedInputPipeline.h"
#include "Picking/PickerDetector.h"
#include "View/FrameWatch.h"
#include "View/TerrainViewpoint.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTerrainPyramid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace
{
using TerrainMapper = vtkTerrainMapper;
using relevo::TerrainColoring;

static_assert(relevo::HaveSameNumber(TerrainMapper::COLOR_SOLID, TerrainColoring::SOLID) &&
    relevo::HaveSameNumber(TerrainMapper::COLOR_BY_ELEVATION, TerrainColoring::ELEVATION) &&
    relevo::HaveSameNumber(TerrainMapper::COLOR_BY_SLOPE, TerrainColoring::SLOPE) &&
    relevo::HaveSameNumber(TerrainMapper::COLOR_BY_ASPECT, TerrainColoring::ASPECT) &&
    relevo::HaveSameNumber(TerrainMapper::COLOR_BY_HILLSHADE, TerrainColoring::HILLSHADE) &&
    relevo::HaveSameNumber(TerrainMapper::COLOR_BY_IMAGERY, TerrainColoring::IMAGERY) &&
    relevo::HaveSameNumber(TerrainMapper::COLOR_BY_RASTER, TerrainColoring::RASTER),
  "colour modes");

// A globe has at least this many faces, whatever the limit of memory.
constexpr vtkTypeInt64 SmallestNumberOfFaces = 64;

constexpr int TrianglesPerFace = relevo::TerrainFace::Segments * relevo::TerrainFace::Segments;

// The bytes of textures among those of tiles. A height tile has a texture of heights and one of
// gradients; an imagery tile has one.
vtkTypeInt64 GetTextureLimit(vtkTypeInt64 tileLimit)
{
  return tileLimit / 3 * 2;
}

// The bytes that remain for tiles and their textures. On a globe, a quarter of the limit is for the
// positions of vertices.
vtkTypeInt64 WithoutVertices(vtkTypeInt64 limit, bool isGlobe)
{
  return isGlobe
    ? std::max<vtkTypeInt64>(limit - limit / 4, relevo::AdaptiveTerrain::SmallestMemoryLimit)
    : limit;
}

// The number of faces whose vertices fit into the rest.
std::size_t CountGlobeFaces(vtkTypeInt64 limit)
{
  using relevo::GlobeFaces;
  constexpr vtkTypeInt64 spare = GlobeFaces::SpareFaces * GlobeFaces::BytesPerFace;
  constexpr vtkTypeInt64 face = GlobeFaces::BytesPerFace + relevo::GlobeVertices::BytesPerFace;
  return static_cast<std::size_t>(
    std::max<vtkTypeInt64>(SmallestNumberOfFaces, (limit / 4 - spare) / face));
}

// The error grows by this factor until the tiles fit into memory. In a new view, it first shrinks
// by this factor as long as they fit.
const double ReductionStep = std::sqrt(2.0);
constexpr double LargestReduction = 1e6;

void CopyTerrainOffsets(vtkMapper* from, vtkMapper* to)
{
  double factor = 0.0;
  double units = 0.0;
  from->GetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  to->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  from->GetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
  to->SetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
  from->GetRelativeCoincidentTopologyPointOffsetParameter(units);
  to->SetRelativeCoincidentTopologyPointOffsetParameter(units);
}
}

struct vtkTerrainMapper::vtkInternals
{
  // Whether another frame would show more.
  bool NeedsFrame() const
  {
    return this->Terrain &&
      ((this->IsViewValid && this->Terrain->NeedsFrame()) ||
        (this->HasProcesses && this->All.NeedsFrame));
  }

  std::unique_ptr<relevo::AdaptiveTerrain> Terrain;
  relevo::Dependencies Opened; // pyramid
  bool IsOpen = false;         // without an error
  std::shared_ptr<const relevo::ImageryLattice> Imagery;
  relevo::Dependencies OpenedImagery; // heights and the name of the image
  vtkTypeInt64 TileLimit = 0;         // bytes of tiles and their textures
  vtkNew<relevo::TerrainPainter> Painter;
  vtkNew<relevo::ContextWatch> Context;
  relevo::FrameWatch Frames;
  relevo::Dependencies View; // of the faces
  bool IsViewValid = true;   // its numbers are finite; otherwise nothing is selected or loaded
  bool HasProcesses = false; // that divide the frames
  std::optional<relevo::TerrainShare> Share;
  double Reduction = 1.0; // of the error, which processes have agreed on
  relevo::Dependencies AgreedView;
  bool HasGrown = false; // the reduction, for this view
  struct
  {
    double Error = 0.0;
    bool IsComplete = false;
    bool NeedsFrame = false;
  } All;              // processes
  vtkTimeStamp Drawn; // the last change of the faces
  relevo::PickerDetector Picker;
  vtkNew<vtkPolyData> NoInput; // pickers request an input
  vtkNew<vtkPolyData> PickedMesh;
  relevo::Dependencies PickedSource;
  vtkSmartPointer<vtkLookupTable> DefaultTable;
  relevo::Dependencies DefaultColors; // of the default table
  vtkNew<vtkLookupTable> WaterTable;  // the default one
  vtkNew<vtkLookupTable> ColorTable;  // with water and land
  relevo::Dependencies ColorTableSource;
  vtkNew<vtkLookupTable> GreyTable;
  std::string Error; // errors are those reported last
  std::string BaseError;
  std::string DrawError;
  std::string ColorError;
  std::string ShaderError;
  std::string GeoidWarning;
};

vtkStandardNewMacro(vtkTerrainMapper);

vtkTerrainMapper::vtkTerrainMapper()
  : Internals(new vtkInternals)
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
  vtkNew<relevo::PickedInputPipeline> pipeline;
  pipeline->Replace = [this](vtkDataObject* input) { return this->ReplaceInput(input); };
  this->SetExecutive(pipeline);
  this->SetInputDataInternal(0, this->Internals->NoInput);
  relevo::SetColorsOfWater(this->Internals->WaterTable);
  relevo::SetGreys(this->Internals->GreyTable);
}

vtkTerrainMapper::~vtkTerrainMapper()
{
  // The resources are released here, while virtual calls still reach this class, in the context of
  // the window.
  this->ReleaseGraphicsResources(nullptr);
}

int vtkTerrainMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // there is no input
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
// Settings

vtkCxxSetSmartPointerMacro(vtkTerrainMapper, Pyramid, vtkTerrainPyramid);

vtkTerrainPyramid* vtkTerrainMapper::GetPyramid()
{
  return this->Pyramid;
}

void vtkTerrainMapper::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(this, "ScreenSpaceError", this->ScreenSpaceError, pixels,
    relevo::AdaptiveTerrain::SmallestTolerance, relevo::LargestDouble);
}

void vtkTerrainMapper::SetMemoryLimit(vtkTypeInt64 bytes)
{
  relevo::SetInRange<vtkTypeInt64>(this, "MemoryLimit", this->MemoryLimit, bytes,
    relevo::AdaptiveTerrain::SmallestMemoryLimit, VTK_TYPE_INT64_MAX);
}

void vtkTerrainMapper::SetExaggeration(double factor)
{
  relevo::SetInRange(
    this, "Exaggeration", this->Exaggeration, factor, 0.001, relevo::LargestDouble);
}

void vtkTerrainMapper::SetBaseHeight(double height)
{
  relevo::SetInRange(
    this, "BaseHeight", this->BaseHeight, height, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkTerrainMapper::SetLoadingMode(int mode)
{
  relevo::SetChoice(this, "LoadingMode", this->LoadingMode, mode, { "BACKGROUND", "COMPLETE" });
}

void vtkTerrainMapper::SetTerrainColorMode(int mode)
{
  relevo::SetChoice(this, "TerrainColorMode", this->TerrainColorMode, mode,
    { "COLOR_SOLID", "COLOR_BY_ELEVATION", "COLOR_BY_SLOPE", "COLOR_BY_ASPECT",
      "COLOR_BY_HILLSHADE", "COLOR_BY_IMAGERY", "COLOR_BY_RASTER" });
  this->UpdateDefaultTable();
}

void vtkTerrainMapper::SetColorFile(std::string& current, const char* name, int mode)
{
  const std::string text = name ? name : "";
  if (text != current)
  {
    current = text;
    this->Modified();
  }
  if (!text.empty())
  {
    this->SetTerrainColorMode(mode);
  }
}

void vtkTerrainMapper::SetImageryFileName(const char* name)
{
  this->SetColorFile(this->ImageryFileName, name, COLOR_BY_IMAGERY);
}

void vtkTerrainMapper::SetColorRasterFileName(const char* name)
{
  this->SetColorFile(this->ColorRasterFileName, name, COLOR_BY_RASTER);
}

const char* vtkTerrainMapper::GetColorRasterFileName()
{
  return this->ColorRasterFileName.empty() ? nullptr : this->ColorRasterFileName.c_str();
}

void vtkTerrainMapper::SetImageryBands(int red, int green, int blue)
{
  const std::array<int, 3> bands = { { red, green, blue } };
  const bool isDefault = bands == std::array<int, 3>{ { 0, 0, 0 } };
  if (!isDefault && *std::min_element(bands.begin(), bands.end()) < 1)
  {
    vtkErrorMacro(<< "ImageryBands must be three bands, counted from 1, or (0, 0, 0), got (" << red
                  << ", " << green << ", " << blue << ").");
    return;
  }
  if (!std::equal(bands.begin(), bands.end(), this->ImageryBands))
  {
    std::copy(bands.begin(), bands.end(), this->ImageryBands);
    this->Modified();
  }
}

const char* vtkTerrainMapper::GetImageryFileName()
{
  return this->ImageryFileName.empty() ? nullptr : this->ImageryFileName.c_str();
}

void vtkTerrainMapper::SetSeaLevel(double height)
{
  relevo::SetInRange(
    this, "SeaLevel", this->SeaLevel, height, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkTerrainMapper::SetWaterLookupTable(vtkScalarsToColors* table)
{
  if (table != this->WaterLookupTable)
  {
    this->WaterLookupTable = table;
    this->Modified();
  }
}

void vtkTerrainMapper::SetContourInterval(double interval)
{
  relevo::SetInRange(
    this, "ContourInterval", this->ContourInterval, interval, 0.0, relevo::LargestDouble);
}

void vtkTerrainMapper::SetContourWidth(double pixels)
{
  relevo::SetInRange(this, "ContourWidth", this->ContourWidth, pixels, 0.0, 100.0);
}

void vtkTerrainMapper::SetContourColor(double red, double green, double blue)
{
  relevo::SetVector<3>(
    this, "ContourColor", this->ContourColor, { { red, green, blue } }, 0.0, 1.0);
}

void vtkTerrainMapper::SetFrame(int frame)
{
  relevo::SetChoice(this, "Frame", this->Frame, frame, { "MAP", "GEOCENTRIC" });
}

//------------------------------------------------------------------------------
// Raster

// Update() of the pyramid would report the same error in each frame.
std::string vtkTerrainMapper::OpenTerrain()
{
  vtkInternals& data = *this->Internals;
  const relevo::Dependencies source = relevo::Dependencies::On(
    reinterpret_cast<std::size_t>(this->Pyramid.Get()), this->Pyramid->GetMTime());
  if (data.Opened.Update(source))
  {
    data.IsOpen = this->Pyramid->Update();
  }
  const std::shared_ptr<const relevo::HeightLattice> lattice = this->Pyramid->GetLattice();
  if (!lattice)
  {
    data.Terrain.reset();
    return this->Pyramid->GetErrorMessage();
  }
  if (data.IsOpen && !lattice->AreErrorsKnown() && !lattice->AreErrorsPending())
  {
    data.IsOpen = this->Pyramid->Update(); // reports the error of the index; tiles may be readable
  }
  this->OpenImagery();
  const std::shared_ptr<const relevo::ImageryLattice> imagery =
    HasImagery(static_cast<TerrainColoring>(this->TerrainColorMode)) ? data.Imagery : nullptr;
  const bool isGeocentric = this->Frame == GEOCENTRIC;
  if (!data.Terrain || &data.Terrain->GetLattice() != lattice.get() ||
    data.Terrain->GetImagery() != imagery.get() ||
    (data.Terrain->GetGlobe() != nullptr) != isGeocentric)
  {
    data.Terrain.reset(new relevo::AdaptiveTerrain(lattice, imagery, isGeocentric));
    data.Terrain->SetShading(true);
    data.View.Clear();
    data.Drawn.Modified();
    data.Painter->ForgetTiles();
  }
  if (const relevo::GlobeShape* globe = data.Terrain->GetGlobe())
  {
    const std::string& warning = globe->GetGeoid().GetWarning();
    if (relevo::ShouldReport(
          data.GeoidWarning, warning.empty() ? "" : this->Pyramid->GetFileName() + warning))
    {
      vtkWarningMacro(<< data.GeoidWarning);
    }
  }
  const std::string baseError = this->FindBaseError();
  data.Terrain->SetBase(
    this->UseBase && baseError.empty() ? std::optional<double>(this->BaseHeight) : std::nullopt);
  if (relevo::ShouldReport(data.BaseError, baseError))
  {
    vtkErrorMacro(<< baseError);
  }
  const std::string location = data.Terrain->FindLocationError();
  return location.empty() ? "" : this->Pyramid->GetFileName() + location;
}

// Estimated ranges of heights do not count.
std::string vtkTerrainMapper::FindBaseError()
{
  if (!this->UseBase)
  {
    return "";
  }
  const std::string error =
    relevo::FindBaseError(*this->Internals->Terrain, this->Exaggeration, this->BaseHeight);
  if (!error.empty())
  {
    return error + " The terrain is drawn without a base.";
  }
  if (!this->Pyramid->IsErrorKnown())
  {
    return "";
  }
  double range[2];
  this->Pyramid->GetRange(range);
  if (!(range[0] <= range[1]) || this->BaseHeight < range[0])
  {
    return "";
  }
  return "BaseHeight is " + vtkVariant(this->BaseHeight).ToString() +
    ", but it must be below the terrain, whose lowest height is " +
    vtkVariant(range[0]).ToString() + ". The terrain is drawn without a base.";
}

// Without imagery, the terrain is drawn in the colour of the actor.
void vtkTerrainMapper::OpenImagery()
{
  vtkInternals& data = *this->Internals;
  const relevo::HeightLattice* lattice = this->Pyramid->GetLattice().get();
  relevo::ImageryOptions options;
  options.HasNumbers = this->TerrainColorMode == COLOR_BY_RASTER;
  options.FileName = options.HasNumbers ? this->ColorRasterFileName : this->ImageryFileName;
  std::copy_n(this->ImageryBands, 3, options.Bands.begin());
  if (!HasImagery(static_cast<TerrainColoring>(this->TerrainColorMode)) ||
    !data.OpenedImagery.Update(relevo::Dependencies::On(reinterpret_cast<std::size_t>(lattice),
      options.FileName, options.HasNumbers, options.Bands[0], options.Bands[1], options.Bands[2])))
  {
    return;
  }
  data.Imagery.reset();
  if (options.FileName.empty())
  {
    return;
  }
  std::string warning;
  std::string error;
  data.Imagery = relevo::OpenImagery(options, lattice->Describe(), warning, error);
  if (!data.Imagery)
  {
    vtkErrorMacro(<< "Cannot drape " << options.FileName << ": " << error
                  << ". The terrain is drawn without it.");
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< options.FileName << ": " << warning << ".");
  }
}

bool vtkTerrainMapper::UpdateTerrain()
{
  vtkInternals& data = *this->Internals;
  const std::string error = this->Pyramid
    ? this->OpenTerrain()
    : "There is no terrain: call SetPyramid() with a vtkTerrainPyramid.";
  if (!this->Pyramid)
  {
    data.Terrain.reset();
  }
  // The pyramid has reported that it cannot be opened.
  const bool isReported = this->Pyramid && !this->Pyramid->GetLattice();
  if (relevo::ShouldReport(data.Error, error) && !isReported)
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

double* vtkTerrainMapper::GetBounds()
{
  const relevo::OwnBoundsQuestion question(this->Internals->Picker);
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->UpdateTerrain())
  {
    const std::array<double, 6> bounds = this->Internals->Terrain->GetBounds(this->Exaggeration);
    std::copy(bounds.begin(), bounds.end(), this->Bounds);
  }
  return this->Bounds;
}

void vtkTerrainMapper::GetBounds(double bounds[6])
{
  this->Superclass::GetBounds(bounds);
  this->Internals->Picker.AskBounds();
}

bool vtkTerrainMapper::GeographicToWorld(const double geographic[3], double world[3])
{
  if (!this->Pyramid || !this->UpdateTerrain())
  {
    return false;
  }
  if (const relevo::GlobeShape* globe = this->Internals->Terrain->GetGlobe())
  {
    const double height = geographic[2] + globe->GetGeoid().Get(geographic[0], geographic[1]);
    const std::array<double, 3> position =
      globe->GetFrame().ToWorld({ { geographic[0], geographic[1], height * this->Exaggeration } });
    std::copy(position.begin(), position.end(), world);
    return std::abs(geographic[1]) <= 90.0 && vtkMath::IsFinite(world[0]) &&
      vtkMath::IsFinite(world[1]) && vtkMath::IsFinite(world[2]);
  }
  std::array<double, 2> coordinates;
  if (!this->Pyramid->GeographicToRaster(geographic, coordinates.data()))
  {
    return false;
  }
  const std::array<double, 2> map = this->Internals->Terrain->GetFrame().ToMap(coordinates);
  std::copy(map.begin(), map.end(), world);
  world[2] = geographic[2] * this->Exaggeration;
  return true;
}

bool vtkTerrainMapper::WorldToGeographic(const double world[3], double geographic[3])
{
  if (!this->Pyramid || !this->UpdateTerrain())
  {
    return false;
  }
  if (const relevo::GlobeShape* globe = this->Internals->Terrain->GetGlobe())
  {
    const std::array<double, 3> position =
      globe->GetFrame().ToGeographic({ { world[0], world[1], world[2] } });
    std::copy(position.begin(), position.end(), geographic);
    geographic[2] =
      position[2] / this->Exaggeration - globe->GetGeoid().Get(position[0], position[1]);
    return vtkMath::IsFinite(geographic[0]) && vtkMath::IsFinite(geographic[1]) &&
      vtkMath::IsFinite(geographic[2]);
  }
  const std::array<double, 2> coordinates =
    this->Internals->Terrain->GetFrame().ToCoordinates({ { world[0], world[1] } });
  if (!this->Pyramid->RasterToGeographic(coordinates.data(), geographic))
  {
    return false;
  }
  geographic[2] = world[2] / this->Exaggeration;
  return true;
}

bool vtkTerrainMapper::RasterToWorld(const double raster[3], double world[3])
{
  if (!this->Pyramid || !this->UpdateTerrain())
  {
    return false;
  }
  const double height = raster[2] * this->Pyramid->GetVerticalUnit();
  if (this->Internals->Terrain->GetGlobe())
  {
    double geographic[3] = { 0.0, 0.0, height };
    return this->Pyramid->RasterToGeographic(raster, geographic) &&
      this->GeographicToWorld(geographic, world);
  }
  const std::array<double, 2> map =
    this->Internals->Terrain->GetFrame().ToMap({ { raster[0], raster[1] } });
  std::copy(map.begin(), map.end(), world);
  world[2] = height * this->Exaggeration;
  return true;
}

bool vtkTerrainMapper::WorldToRaster(const double world[3], double raster[3])
{
  if (!this->Pyramid || !this->UpdateTerrain())
  {
    return false;
  }
  double height = world[2] / this->Exaggeration;
  if (this->Internals->Terrain->GetGlobe())
  {
    double geographic[3];
    if (!this->WorldToGeographic(world, geographic) ||
      !this->Pyramid->GeographicToRaster(geographic, raster))
    {
      return false;
    }
    height = geographic[2];
  }
  else
  {
    const std::array<double, 2> coordinates =
      this->Internals->Terrain->GetFrame().ToCoordinates({ { world[0], world[1] } });
    std::copy(coordinates.begin(), coordinates.end(), raster);
  }
  raster[2] = height / this->Pyramid->GetVerticalUnit();
  return true;
}

//------------------------------------------------------------------------------
// Colours

void vtkTerrainMapper::CreateDefaultLookupTable()
{
  vtkInternals& data = *this->Internals;
  data.DefaultTable = vtkSmartPointer<vtkLookupTable>::New();
  this->SetLookupTable(data.DefaultTable);
  data.DefaultColors.Clear();
  this->UpdateDefaultTable();
}

void vtkTerrainMapper::UpdateDefaultTable()
{
  vtkInternals& data = *this->Internals;
  if (!data.DefaultTable || this->LookupTable != data.DefaultTable.Get())
  {
    return;
  }
  const bool isCyclic = this->TerrainColorMode == COLOR_BY_ASPECT;
  const bool isLand = this->HasWater();
  if (data.DefaultColors.Update(relevo::Dependencies::On(isCyclic, isLand)))
  {
    if (isLand)
    {
      relevo::SetColorsOfLand(data.DefaultTable);
    }
    else
    {
      relevo::SetHues(data.DefaultTable, isCyclic);
    }
  }
  double range[2] = { 0.0, this->TerrainColorMode == COLOR_BY_SLOPE ? 90.0 : 360.0 };
  if (this->TerrainColorMode != COLOR_BY_SLOPE && this->TerrainColorMode != COLOR_BY_ASPECT &&
    this->Pyramid)
  {
    this->Pyramid->GetRange(range);
  }
  if (this->TerrainColorMode == COLOR_BY_RASTER && data.Imagery && data.Imagery->HasNumbers())
  {
    const std::array<double, 2> numbers = data.Imagery->GetRange();
    std::copy(numbers.begin(), numbers.end(), range);
  }
  if (isLand)
  {
    range[0] = this->SeaLevel;
    range[1] = std::max(range[1], this->SeaLevel);
  }
  data.DefaultTable->SetTableRange(range);
}

vtkScalarsToColors* vtkTerrainMapper::GetWaterLookupTable()
{
  if (this->WaterLookupTable)
  {
    return this->WaterLookupTable;
  }
  double range[2] = { this->SeaLevel, this->SeaLevel };
  if (this->Pyramid)
  {
    this->Pyramid->GetRange(range);
  }
  this->Internals->WaterTable->SetTableRange(std::min(range[0], this->SeaLevel), this->SeaLevel);
  return this->Internals->WaterTable;
}

// Return the table of the current colours, with land and water.
vtkScalarsToColors* vtkTerrainMapper::UpdateColorTable()
{
  vtkInternals& data = *this->Internals;
  vtkScalarsToColors* land = this->GetLookupTable();
  this->UpdateDefaultTable();
  vtkScalarsToColors* water = this->GetWaterLookupTable();
  // The painter reports errors of a table.
  if (!this->HasWater() || !relevo::ColorTable::FindError(land, land->GetRange()).empty())
  {
    return land;
  }
  if (!relevo::ColorTable::FindError(water, water->GetRange()).empty())
  {
    return water;
  }
  relevo::Dependencies source = relevo::Dependencies::On(this->SeaLevel);
  source.AddObject(land);
  source.AddObject(water);
  if (data.ColorTableSource.Update(source))
  {
    relevo::JoinAtSeaLevel(water, land, this->SeaLevel, data.ColorTable);
    data.ColorTableSource = relevo::Dependencies::On(this->SeaLevel);
    data.ColorTableSource.AddObject(land); // after the call, which builds the tables
    data.ColorTableSource.AddObject(water);
  }
  return data.ColorTable;
}

vtkScalarsToColors* vtkTerrainMapper::GetLegendLookupTable()
{
  if (!this->Pyramid || !this->UpdateTerrain())
  {
    return nullptr;
  }
  if (this->TerrainColorMode == COLOR_BY_HILLSHADE)
  {
    return this->Internals->GreyTable;
  }
  return relevo::HasTable(static_cast<TerrainColoring>(this->TerrainColorMode))
    ? this->UpdateColorTable()
    : nullptr;
}

std::string vtkTerrainMapper::GetLegendTitle()
{
  if (!this->Pyramid || !this->UpdateTerrain())
  {
    return "";
  }
  std::string name;
  std::string unit;
  switch (this->TerrainColorMode)
  {
    case COLOR_BY_ELEVATION:
      name = "Height";
      unit = this->Pyramid->GetHeightUnit();
      break;
    case COLOR_BY_SLOPE:
      name = "Slope";
      unit = "degrees";
      break;
    case COLOR_BY_ASPECT:
      name = "Aspect";
      unit = "degrees";
      break;
    case COLOR_BY_HILLSHADE:
      name = "Hillshade";
      break;
    case COLOR_BY_RASTER:
      if (const relevo::ImageryLattice* raster = this->Internals->Imagery.get())
      {
        name = raster->GetName().empty() ? "Value" : raster->GetName();
        unit = raster->GetUnit();
      }
      break;
    default:
      break;
  }
  return unit.empty() ? name : name + " [" + unit + "]";
}

bool vtkTerrainMapper::HasTranslucentPolygonalGeometry()
{
  return relevo::HasTable(static_cast<TerrainColoring>(this->TerrainColorMode)) &&
    !this->UpdateColorTable()->IsOpaque();
}

bool vtkTerrainMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
// Rendering

void vtkTerrainMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (window->CheckAbortStatus())
  {
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (this->UpdateTerrain())
  {
    // This releases resources in the context of another window.
    this->Internals->Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
    relevo::RunWithinMemory(this, "the terrain",
      [&]
      {
        this->SelectFaces(renderer, actor);
        this->DrawFaces(renderer, actor);
        return true;
      });
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  if (this->Internals->NeedsFrame())
  {
    this->InvokeEvent(vtkCommand::UpdateEvent, nullptr);
  }
}

void vtkTerrainMapper::SelectFaces(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  const relevo::TerrainPlacement placement = data.Terrain->GetPlacement(this->Exaggeration);
  const relevo::TerrainViewpoint viewpoint(renderer, actor);
  relevo::Dependencies view =
    relevo::Dependencies::On(reinterpret_cast<std::size_t>(renderer), this->ScreenSpaceError,
      this->MemoryLimit, this->Exaggeration, this->LoadingMode, data.Terrain->GetBase().has_value(),
      data.Terrain->GetBase().value_or(0.0), data.Reduction, data.Share.has_value());
  if (data.Share)
  {
    for (double side :
      { data.Share->Columns[0], data.Share->Columns[1], data.Share->Rows[0], data.Share->Rows[1] })
    {
      view.Add(side);
    }
  }
  viewpoint.AddTo(view);
  // Tiles that arrive between the passes of a frame or of a selection do not change the faces.
  const bool isFurtherPass =
    !data.Frames.IsNewFrame(renderer) || renderer->GetSelector() != nullptr;
  const bool isSame = !data.View.Update(view);
  const bool isFinal = data.Terrain->IsComplete() && !data.Terrain->NeedsFrame();
  data.IsViewValid = viewpoint.IsValid();
  if (!data.IsViewValid || (isSame && (isFurtherPass || isFinal)))
  {
    return;
  }
  data.TileLimit =
    data.Terrain->PlanMemory(WithoutVertices(this->MemoryLimit, this->Frame == GEOCENTRIC));
  const vtkTypeInt64 textures = GetTextureLimit(data.TileLimit);
  data.Terrain->SetMaximumNumberOfGlobeFaces(CountGlobeFaces(this->MemoryLimit));
  const std::size_t tiles =
    data.Painter->GetMaximumNumberOfTiles(textures) * relevo::HeightTileCache::BytesPerTile;
  data.Terrain->SetMemoryLimit(
    std::min(static_cast<std::size_t>(data.TileLimit - textures), tiles));
  const relevo::TerrainView terrainView = viewpoint.MakeView(placement);
  const double error = this->ScreenSpaceError * data.Reduction;
  data.Terrain->SetShare(data.Share);
  if (data.HasProcesses)
  {
    data.Terrain->ForgetReduction(); // the reduction of all processes replaces it
  }
  if (this->LoadingMode == COMPLETE)
  {
    this->Pyramid->WaitForIndex(); // the pyramid reports errors
    vtkRenderWindow* window = renderer->GetRenderWindow();
    const bool isLoaded = data.Terrain->SelectAndWait(
      terrainView, error, [window] { return window->CheckAbortStatus() != 0; });
    if (!isLoaded)
    {
      data.Terrain->Select(terrainView, error); // with the tiles in memory
    }
  }
  else
  {
    data.Terrain->Select(terrainView, error);
  }
  data.Drawn.Modified();
  const std::string tileError = data.Terrain->TakeError(relevo::TerrainTile::Kind::Heights);
  if (!tileError.empty())
  {
    vtkErrorMacro(<< "Cannot read " << this->Pyramid->GetFileName() << ": " << tileError
                  << ". The terrain is drawn coarser there.");
  }
  const std::string imageryError = data.Terrain->TakeError(relevo::TerrainTile::Kind::Imagery);
  if (!imageryError.empty())
  {
    vtkErrorMacro(<< "Cannot read "
                  << (this->TerrainColorMode == COLOR_BY_RASTER ? this->ColorRasterFileName
                                                                : this->ImageryFileName)
                  << ": " << imageryError << ". The imagery is drawn coarser there.");
  }
}

// The first process divides the terrain, because indices may be incomplete.
void vtkTerrainMapper::Divide(
  vtkMultiProcessController* controller, vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  const int number = controller->GetNumberOfProcesses();
  std::vector<double> sides;
  if (controller->GetLocalProcessId() == 0)
  {
    const relevo::TerrainViewpoint viewpoint(renderer, actor);
    const relevo::TerrainView view =
      viewpoint.MakeView(data.Terrain->GetPlacement(this->Exaggeration));
    const double error = this->ScreenSpaceError * data.Reduction;
    const std::vector<relevo::TerrainShare> shares = viewpoint.IsValid()
      ? data.Terrain->Divide(view, error, number)
      : std::vector<relevo::TerrainShare>(static_cast<std::size_t>(number));
    for (const relevo::TerrainShare& share : shares)
    {
      sides.insert(
        sides.end(), { share.Columns[0], share.Columns[1], share.Rows[0], share.Rows[1] });
    }
  }
  sides.resize(4 * static_cast<std::size_t>(number));
  controller->Broadcast(sides.data(), static_cast<vtkIdType>(sides.size()), 0);
  const double* own = &sides[4 * static_cast<std::size_t>(controller->GetLocalProcessId())];
  data.Share = relevo::TerrainShare{ { { own[0], own[1] } }, { { own[2], own[3] } } };
}

void vtkTerrainMapper::AgreeWithProcesses(
  vtkMultiProcessController* controller, vtkRenderer* renderer, vtkActor* actor, bool isDivided)
{
  vtkInternals& data = *this->Internals;
  data.HasProcesses = controller && controller->GetNumberOfProcesses() > 1;
  data.Share.reset();
  if (!data.HasProcesses)
  {
    data.Reduction = 1.0;
    return;
  }
  const relevo::ProcessReduction processes(controller);
  std::vector<double> isClosed = { this->Pyramid && this->UpdateTerrain() ? 0.0 : 1.0 };
  processes.TakeLargest(isClosed);
  if (isClosed[0] > 0.0)
  {
    data.HasProcesses = false; // a process without the raster cannot draw a share
    data.Reduction = 1.0;
    return;
  }
  vtkRenderWindow* window = renderer->GetRenderWindow();
  window->MakeCurrent();
  data.Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  const bool isComplete = this->LoadingMode == COMPLETE;
  if (isComplete)
  {
    this->Pyramid->WaitForIndex(); // the pyramid reports errors
  }
  relevo::Dependencies view = relevo::Dependencies::On(this->ScreenSpaceError, this->MemoryLimit);
  relevo::TerrainViewpoint(renderer, actor).AddTo(view);
  std::vector<double> start = { data.AgreedView.Update(view) ? 1.0 : 0.0, data.Reduction };
  processes.TakeLargest(start);
  data.HasGrown = data.HasGrown && start[0] == 0.0;
  data.Reduction = start[1];
  if (isDivided)
  {
    this->Divide(controller, renderer, actor);
  }
  bool isAgreed = false;
  while (!isAgreed)
  {
    relevo::RunWithinMemory(this, "the terrain",
      [&]
      {
        this->SelectFaces(renderer, actor);
        return true;
      });
    const bool needsFrame = data.IsViewValid && data.Terrain->NeedsFrame();
    std::vector<double> results = { data.Terrain->GetReduction(),
      data.Terrain->LacksMemory() ? ReductionStep : 1.0, needsFrame ? 1.0 : 0.0,
      data.Terrain->GetError(), data.Terrain->IsComplete() ? 0.0 : 1.0 };
    processes.TakeLargest(results);
    // Missing tiles may be on their way.
    const bool isLoaded = isComplete || results[2] == 0.0;
    const double factor = std::max(results[0], isLoaded ? results[1] : 1.0);
    const double before = data.Reduction;
    if (factor > 1.0)
    {
      data.HasGrown = true;
      data.Reduction = std::min(before * factor, LargestReduction);
    }
    else if (isLoaded && !data.HasGrown)
    {
      data.Reduction = std::max(1.0, before / ReductionStep);
    }
    isAgreed = data.Reduction == before;
    data.All.Error = results[3];
    data.All.IsComplete = results[4] == 0.0 && data.Reduction <= 1.0;
    data.All.NeedsFrame = results[2] > 0.0 || !isAgreed;
    isAgreed = isAgreed || !isComplete; // the next frame has the new reduction
  }
}

void vtkTerrainMapper::DrawFaces(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& data = *this->Internals;
  relevo::TerrainPainter::Settings settings;
  settings.Placement = data.Terrain->GetPlacement(this->Exaggeration);
  this->Pyramid->GetDimensions(settings.Dimensions.data());
  settings.Vertices = &data.Terrain->GetVertices();
  settings.NumberOfComputedFaces = data.Terrain->GetNumberOfComputedFaces();
  settings.Exaggeration = this->Exaggeration;
  settings.Base = data.Terrain->GetBase();
  settings.Coloring = static_cast<TerrainColoring>(this->TerrainColorMode);
  if (relevo::HasTable(settings.Coloring))
  {
    settings.Table = this->UpdateColorTable();
  }
  settings.ContourInterval = this->ContourInterval;
  settings.ContourWidth = this->ContourWidth;
  std::copy_n(this->ContourColor, 3, settings.ContourColor.begin());
  settings.MemoryLimit = GetTextureLimit(data.TileLimit);
  data.Painter->SetClippingPlanes(this->ClippingPlanes);
  CopyTerrainOffsets(this, data.Painter);
  const std::string error = data.Painter->Prepare(
    renderer, actor, data.Terrain->GetFaces(), data.Terrain->GetShadingTiles(), settings);
  if (relevo::ShouldReport(data.DrawError, error))
  {
    vtkErrorMacro(<< error);
  }
  if (error.empty())
  {
    relevo::LeafSelection selection(renderer);
    selection.Begin(1);
    if (vtkHardwareSelector* selector = renderer->GetSelector())
    {
      data.Painter->AnnounceIds(selector);
    }
    data.Painter->RenderPiece(renderer, actor);
  }
  const std::string& colorError = data.Painter->GetColorError();
  if (relevo::ShouldReport(data.ColorError,
        colorError.empty() ? "" : "Cannot map the terrain to colours: " + colorError))
  {
    vtkErrorMacro(<< data.ColorError << ".");
  }
  if (relevo::ShouldReport(data.ShaderError, data.Painter->GetShaderError()))
  {
    vtkErrorMacro(<< data.ShaderError);
  }
}

void vtkTerrainMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // a recursive call, in the context that owns the resources
  }
  this->Superclass::ReleaseGraphicsResources(window);
  data.Painter->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
// Results of the last frame

bool vtkTerrainMapper::IsComplete()
{
  const vtkInternals& data = *this->Internals;
  return data.Terrain && (data.HasProcesses ? data.All.IsComplete : data.Terrain->IsComplete());
}

double vtkTerrainMapper::GetScreenSpaceErrorInUse()
{
  const vtkInternals& data = *this->Internals;
  return !data.Terrain ? 0.0 : data.HasProcesses ? data.All.Error : data.Terrain->GetError();
}

vtkTypeInt64 vtkTerrainMapper::GetResidentMemorySize()
{
  const vtkInternals& data = *this->Internals;
  return data.Painter->GetMemorySize() +
    (data.Terrain ? static_cast<vtkTypeInt64>(data.Terrain->GetMemorySize()) : 0);
}

vtkIdType vtkTerrainMapper::GetNumberOfDrawnTriangles()
{
  return this->Internals->Terrain
    ? static_cast<vtkIdType>(this->Internals->Terrain->GetFaces().size()) * TrianglesPerFace
    : 0;
}

vtkMTimeType vtkTerrainMapper::GetDrawnMTime()
{
  return this->Internals->Drawn.GetMTime();
}

const relevo::AdaptiveTerrain* vtkTerrainMapper::GetDrawnTerrain() const
{
  return this->Internals->Terrain.get();
}

// Pickers get the triangles in place of the input.
vtkDataObject* vtkTerrainMapper::ReplaceInput(vtkDataObject* input)
{
  vtkInternals& data = *this->Internals;
  if (data.Picker.AskInput(false) == relevo::PickerDetector::NO_PICKER)
  {
    return input;
  }
  const relevo::Dependencies source = relevo::Dependencies::On(
    reinterpret_cast<std::size_t>(data.Terrain.get()), data.Drawn, this->Exaggeration);
  if (data.PickedSource.Update(source))
  {
    data.PickedMesh->Initialize();
    if (data.Terrain)
    {
      relevo::MakeFaceMesh(*data.Terrain, this->Exaggeration, data.PickedMesh);
      if (const std::optional<double>& base = data.Terrain->GetBase())
      {
        relevo::AddBase(*data.Terrain, this->Exaggeration, *base, data.PickedMesh);
      }
    }
  }
  return data.PickedMesh;
}

//------------------------------------------------------------------------------

vtkMTimeType vtkTerrainMapper::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->WaterLookupTable)
  {
    time = std::max(time, this->WaterLookupTable->GetMTime());
  }
  return this->Pyramid ? std::max(time, this->Pyramid->GetMTime()) : time;
}

void vtkTerrainMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkTerrainMapper* other = vtkTerrainMapper::SafeDownCast(mapper))
  {
    this->SetPyramid(other->Pyramid);
    this->SetScreenSpaceError(other->ScreenSpaceError);
    this->SetMemoryLimit(other->MemoryLimit);
    this->SetExaggeration(other->Exaggeration);
    this->SetUseBase(other->UseBase);
    this->SetBaseHeight(other->BaseHeight);
    this->SetLoadingMode(other->LoadingMode);
    this->SetImageryFileName(other->ImageryFileName.c_str());
    this->SetImageryBands(other->ImageryBands[0], other->ImageryBands[1], other->ImageryBands[2]);
    this->SetColorRasterFileName(other->ColorRasterFileName.c_str());
    this->SetTerrainColorMode(other->TerrainColorMode);
    this->SetUseSeaLevel(other->UseSeaLevel);
    this->SetSeaLevel(other->SeaLevel);
    this->SetWaterLookupTable(other->WaterLookupTable);
    this->SetContourInterval(other->ContourInterval);
    this->SetContourWidth(other->ContourWidth);
    this->SetContourColor(other->ContourColor);
    this->SetFrame(other->Frame);
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkTerrainMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pyramid: " << this->Pyramid << "\n";
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "UseBase: " << (this->UseBase ? "on" : "off") << "\n";
  os << indent << "BaseHeight: " << this->BaseHeight << "\n";
  os << indent << "LoadingMode: " << this->LoadingMode << "\n";
  os << indent << "TerrainColorMode: " << this->TerrainColorMode << "\n";
  os << indent
     << "ImageryFileName: " << (this->ImageryFileName.empty() ? "(none)" : this->ImageryFileName)
     << "\n";
  os << indent << "ImageryBands: " << this->ImageryBands[0] << " " << this->ImageryBands[1] << " "
     << this->ImageryBands[2] << "\n";
  os << indent << "ColorRasterFileName: "
     << (this->ColorRasterFileName.empty() ? "(none)" : this->ColorRasterFileName) << "\n";
  os << indent << "UseSeaLevel: " << (this->UseSeaLevel ? "on" : "off") << "\n";
  os << indent << "SeaLevel: " << this->SeaLevel << "\n";
  os << indent << "WaterLookupTable: " << this->WaterLookupTable.Get() << "\n";
  os << indent << "ContourInterval: " << this->ContourInterval << "\n";
  os << indent << "ContourWidth: " << this->ContourWidth << "\n";
  os << indent << "ContourColor: " << this->ContourColor[0] << " " << this->ContourColor[1] << " "
     << this->ContourColor[2] << "\n";
  os << indent << "Frame: " << this->Frame << "\n";
  os << indent << "NumberOfDrawnTriangles: " << this->GetNumberOfDrawnTriangles() << "\n";
}
