// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainMeshSource.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/FaceMesh.h"
#include "Bisection/GlobeRegion.h"
#include "Bisection/LatticeDecimation.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Geodesy/LocationArrays.h"
#include "Heights/TerrainMeshBuilder.h"
#include "Raster/ImageryTexture.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainPyramid.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace
{
// Larger regions are decimated from a coarser level.
constexpr std::size_t MaximumVertices = std::size_t(1) << 26;

// The part of the tolerance that a coarser level may use.
constexpr double CoarserShare = 0.5;

// Fractions of the progress.
constexpr double ReadingShare = 0.1;
constexpr double RefiningShare = 0.8;
constexpr double BuiltShare = 0.9;
constexpr double ProgressStep = 0.01;

constexpr int LargestImagery = 65536; // pixels per side

// The rectangle of a height lattice that covers columns and rows of samples.
struct LatticeWindow
{
  int Level;
  int Column;
  int Row;
  int Width;
  int Height;

  LatticeWindow(const double columns[2], const double rows[2], int level = 0)
    : Level(level)
  {
    const double size = std::ldexp(1.0, level);
    this->Column = static_cast<int>(std::floor(columns[0] / size));
    this->Row = static_cast<int>(std::floor(rows[0] / size));
    this->Width = static_cast<int>(std::ceil(columns[1] / size)) - this->Column + 1;
    this->Height = static_cast<int>(std::ceil(rows[1] / size)) - this->Row + 1;
  }

  std::size_t GetNumberOfVertices() const
  {
    return static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Height);
  }
};

// Outputs the triangles of a window up to the last column and row, in samples.
void OutputTriangles(const relevo::LatticeDecimation& decimation, const LatticeWindow& window,
  const relevo::RasterDescription& contents, const relevo::TerrainPlacement& placement,
  const double columns[2], const double rows[2], vtkPolyData* output)
{
  const int subdivisions = decimation.GetSubdivisions();
  const double unit = std::ldexp(1.0, -subdivisions);
  relevo::TerrainMeshBuilder mesh(contents, placement, subdivisions);
  for (const relevo::LatticeDecimation::Triangle& triangle : decimation.GetTriangles())
  {
    std::array<relevo::TerrainMeshBuilder::Vertex, 3> vertices;
    std::array<double, 3> world[3];
    for (int i = 0; i < 3; ++i)
    {
      const relevo::LatticeDecimation::Vertex& vertex = triangle[i];
      const auto toRaster = [&window, subdivisions](std::int64_t position, int first)
      { return (position + (std::int64_t(first) << subdivisions)) << window.Level; };
      vertices[i].Column = toRaster(vertex[0], window.Column);
      vertices[i].Row = toRaster(vertex[1], window.Row);
      vertices[i].Height = decimation.GetHeight(vertex);
      if (placement.Globe)
      {
        world[i] = placement.ToWorld(static_cast<double>(vertices[i].Column) * unit,
          static_cast<double>(vertices[i].Row) * unit, vertices[i].Height);
        vertices[i].World = &world[i];
        // There is no surface outside of the projection.
        vertices[i].Height = std::isnan(world[i][0]) ? world[i][0] : vertices[i].Height;
      }
    }
    mesh.AddTriangle(vertices);
  }
  mesh.Finish({ { columns[0], columns[1] } }, { { rows[0], rows[1] } }, output);
}
}

vtkStandardNewMacro(vtkTerrainMeshSource);

//------------------------------------------------------------------------------
vtkTerrainMeshSource::vtkTerrainMeshSource()
  : ViewportSize{ 1280, 800 }
  , ScreenSpaceError(1.0)
  , MaximumError(0.0)
  , Region{ 1.0, -1.0, 1.0, -1.0 }
  , Exaggeration(1.0)
  , UseBase(false)
  , BaseHeight(0.0)
  , MemoryLimit(vtkTypeInt64(1) << 29)
  , Frame(MAP)
  , ImageryFileName(nullptr)
  , ImageryBands{ 0, 0, 0 }
  , MaximumImagerySize(4096)
  , ErrorInUse(0.0)
  , MetersInUse(0.0)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkTerrainMeshSource::~vtkTerrainMeshSource()
{
  delete[] this->ImageryFileName;
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetPyramid(vtkTerrainPyramid* pyramid)
{
  if (pyramid != this->Pyramid)
  {
    this->Pyramid = pyramid;
    this->Terrain.reset();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTerrainPyramid* vtkTerrainMeshSource::GetPyramid()
{
  return this->Pyramid;
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetCamera(vtkCamera* camera)
{
  if (camera != this->Camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkTerrainMeshSource::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(this, "ScreenSpaceError", this->ScreenSpaceError, pixels,
    relevo::AdaptiveTerrain::SmallestTolerance, relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetMaximumError(double meters)
{
  relevo::SetInRange(this, "MaximumError", this->MaximumError, meters, 0.0, relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetBaseHeight(double height)
{
  relevo::SetInRange(
    this, "BaseHeight", this->BaseHeight, height, -relevo::LargestDouble, relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetExaggeration(double factor)
{
  relevo::SetInRange(this, "Exaggeration", this->Exaggeration, factor, -relevo::LargestDouble,
    relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetRegion(double xmin, double xmax, double ymin, double ymax)
{
  relevo::SetVector<4>(this, "Region", this->Region, { { xmin, xmax, ymin, ymax } },
    -relevo::LargestDouble, relevo::LargestDouble);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetFrame(int frame)
{
  relevo::SetChoice(this, "Frame", this->Frame, frame, { "MAP", "GEOCENTRIC" });
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetViewportSize(int width, int height)
{
  relevo::SetPixelSize(this, "ViewportSize", this->ViewportSize, width, height);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetMemoryLimit(vtkTypeInt64 bytes)
{
  relevo::SetInRange<vtkTypeInt64>(this, "MemoryLimit", this->MemoryLimit, bytes,
    relevo::AdaptiveTerrain::SmallestMemoryLimit, VTK_TYPE_INT64_MAX);
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetImageryBands(int red, int green, int blue)
{
  const std::array<int, 3> bands = { { red, green, blue } };
  const bool isDefault = bands == std::array<int, 3>{ { 0, 0, 0 } };
  if (!isDefault && std::any_of(bands.begin(), bands.end(), [](int band) { return band < 1; }))
  {
    vtkErrorMacro(<< "ImageryBands must be three bands, counted from 1, or (0, 0, 0), got (" << red
                  << ", " << green << ", " << blue << ").");
  }
  else if (!std::equal(bands.begin(), bands.end(), this->ImageryBands))
  {
    std::copy(bands.begin(), bands.end(), this->ImageryBands);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::SetMaximumImagerySize(int pixels)
{
  relevo::SetInRange(
    this, "MaximumImagerySize", this->MaximumImagerySize, pixels, 1, LargestImagery);
}

//------------------------------------------------------------------------------
vtkImageData* vtkTerrainMeshSource::GetImagery()
{
  return this->ImageryFileName && *this->ImageryFileName ? this->Imagery.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTerrainMeshSource::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->Pyramid ? std::max(time, this->Pyramid->GetMTime()) : time;
  return this->Camera ? std::max(time, this->Camera->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkTerrainMeshSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->ErrorInUse = 0.0;
  this->MetersInUse = 0.0;
  std::string error;
  if (!relevo::FitsMemory([&] { error = this->Build(output); }))
  {
    error = "Not enough memory for the mesh. Choose a smaller region or a larger error.";
  }
  if (!error.empty())
  {
    output->Initialize();
    this->Imagery->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  if (relevo::IsAborted(this))
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::Build(vtkPolyData* output)
{
  if (!this->Pyramid)
  {
    return "There is no terrain: call SetPyramid().";
  }
  if (this->MaximumError <= 0.0 && !this->Camera)
  {
    return "There is neither a camera nor an error in metres: call SetCamera() or "
           "SetMaximumError().";
  }
  if (!this->Pyramid->Update())
  {
    return std::string("The pyramid has an error: ") + this->Pyramid->GetErrorMessage();
  }
  const std::shared_ptr<const relevo::HeightLattice> lattice = this->Pyramid->GetLattice();
  const bool isGeocentric = this->Frame == GEOCENTRIC;
  if (!this->Terrain || &this->Terrain->GetLattice() != lattice.get() ||
    (this->Terrain->GetGlobe() != nullptr) != isGeocentric)
  {
    this->Terrain = std::make_unique<relevo::AdaptiveTerrain>(lattice, nullptr, isGeocentric);
  }
  const std::string location = this->Terrain->FindLocationError();
  if (!location.empty())
  {
    return this->Pyramid->GetFileName() + location;
  }
  std::string error =
    this->MaximumError > 0.0 ? this->BuildRegion(output) : this->BuildView(output);
  if (error.empty() && this->UseBase && !relevo::IsAborted(this))
  {
    error = this->BuildBase(output);
  }
  error = error.empty() ? this->DrapeImagery() : error;
  if (error.empty() && !isGeocentric)
  {
    const relevo::Georeference& reference = lattice->Describe().Location;
    const std::array<double, 2> center = reference.Coordinates(0.5, 0.5);
    const double origin[3] = { center[0], center[1], 0.0 };
    relevo::AddLocationArrays(origin, reference.WKT, output);
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::DrapeImagery()
{
  if (!this->GetImagery() || relevo::IsAborted(this))
  {
    this->Imagery->Initialize();
    return "";
  }
  relevo::ImagerySource source;
  source.FileName = this->ImageryFileName;
  std::copy_n(this->ImageryBands, 3, source.Bands.begin());
  source.MaximumSize = this->MaximumImagerySize;
  const auto progress = [this](double share)
  {
    this->UpdateProgress(BuiltShare + (1.0 - BuiltShare) * share);
    return !relevo::IsAborted(this);
  };
  std::string warning;
  std::string error;
  relevo::MakeImageryTexture(source, this->Terrain->GetLattice().Describe().Location, this->Imagery,
    progress, warning, error);
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning << " For full detail, raise MaximumImagerySize.");
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::BuildView(vtkPolyData* output)
{
  if (!this->Pyramid->WaitForIndex())
  {
    return std::string("The pyramid has an error: ") + this->Pyramid->GetErrorMessage();
  }
  this->Terrain->SetBase(this->UseBase ? std::optional<double>(this->BaseHeight) : std::nullopt);
  relevo::TerrainView view;
  view.SetPlacement(this->Terrain->GetPlacement(this->Exaggeration));
  view.SetCamera(this->Camera, this->ViewportSize);
  this->Terrain->SetMemoryLimit(static_cast<std::size_t>(this->MemoryLimit));
  const auto isAborted = [this]
  {
    this->UpdateProgress(ReadingShare); // an observer can abort while tiles are loaded
    return relevo::IsAborted(this);
  };
  if (!this->Terrain->SelectAndWait(view, this->ScreenSpaceError, isAborted))
  {
    return "";
  }
  const std::string error = this->Terrain->TakeError();
  if (!error.empty())
  {
    vtkErrorMacro(<< "Cannot read " << this->Pyramid->GetFileName() << ": " << error << ".");
  }
  this->ErrorInUse = this->Terrain->GetError();
  relevo::MakeFaceMesh(*this->Terrain, this->Exaggeration, output);
  return "";
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::BuildBase(vtkPolyData* output)
{
  const double* range = output->GetPointData()->GetArray("Height")->GetRange();
  const double scale = this->Terrain->GetPlacement(this->Exaggeration).HeightScale;
  const double lowest = std::min(scale * range[0], scale * range[1]);
  if (output->GetNumberOfPolys() > 0 && !(scale * this->BaseHeight < lowest))
  {
    return "BaseHeight is " + vtkVariant(this->BaseHeight).ToString() +
      ", but it must be below the mesh, whose lowest height is " + vtkVariant(range[0]).ToString() +
      ".";
  }
  const std::string error =
    relevo::FindBaseError(*this->Terrain, this->Exaggeration, this->BaseHeight);
  if (!error.empty())
  {
    return error;
  }
  relevo::AddBase(*this->Terrain, this->Exaggeration, this->BaseHeight, output);
  return "";
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::FindSamples(double columns[2], double rows[2]) const
{
  const relevo::RasterDescription& contents = this->Terrain->GetLattice().Describe();
  columns[0] = rows[0] = 0.0;
  columns[1] = contents.Width - 1.0;
  rows[1] = contents.Height - 1.0;
  if (this->Region[0] > this->Region[1] || this->Region[2] > this->Region[3])
  {
    return "";
  }
  const relevo::Georeference& location = contents.Location;
  double low[2] = { 0.0, 0.0 };
  double high[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::array<double, 2> uv =
      location.Parameters({ { this->Region[corner % 2], this->Region[2 + corner / 2] } });
    const double samples[2] = { (location.FlipColumns ? 1.0 - uv[0] : uv[0]) * contents.Width - 0.5,
      (location.FlipRows ? 1.0 - uv[1] : uv[1]) * contents.Height - 0.5 };
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = corner == 0 ? samples[axis] : std::min(low[axis], samples[axis]);
      high[axis] = corner == 0 ? samples[axis] : std::max(high[axis], samples[axis]);
    }
  }
  constexpr double rounding = 1e-6;
  double* ranges[2] = { columns, rows };
  for (int axis = 0; axis < 2; ++axis)
  {
    ranges[axis][0] = std::max(ranges[axis][0], std::floor(low[axis] + rounding));
    ranges[axis][1] = std::min(ranges[axis][1], std::ceil(high[axis] - rounding));
    if (!(ranges[axis][0] < ranges[axis][1]))
    {
      return "The region does not overlap the raster. It must have the coordinates of the raster.";
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::FindLevelError(
  int level, const double columns[2], const double rows[2], double& largest) const
{
  largest = 0.0;
  if (level == 0)
  {
    return "";
  }
  if (!this->Pyramid->WaitForIndex())
  {
    return std::string("The pyramid has an error: ") + this->Pyramid->GetErrorMessage();
  }
  const std::shared_ptr<const relevo::BlockErrors> errors = this->Terrain->GetLattice().GetErrors();
  const double size = std::ldexp(static_cast<double>(relevo::BlockErrors::CellsPerBlock), level);
  for (int row = static_cast<int>(rows[0] / size); row * size < rows[1]; ++row)
  {
    for (int column = static_cast<int>(columns[0] / size); column * size < columns[1]; ++column)
    {
      largest = std::max<double>(largest, errors->GetSquareError(level, column, row));
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkTerrainMeshSource::BuildRegion(vtkPolyData* output)
{
  const relevo::HeightLattice& lattice = this->Terrain->GetLattice();
  const relevo::RasterDescription& contents = lattice.Describe();
  double columns[2];
  double rows[2];
  std::string error = this->FindSamples(columns, rows);
  if (!error.empty())
  {
    return error;
  }
  LatticeWindow window(columns, rows);
  while (window.GetNumberOfVertices() > MaximumVertices)
  {
    window = LatticeWindow(columns, rows, window.Level + 1);
  }
  double levelError = 0.0;
  error = this->FindLevelError(window.Level, columns, rows, levelError);
  if (!error.empty())
  {
    return error;
  }
  std::vector<float> heights(window.GetNumberOfVertices());
  if (!lattice.ReadWindow(window.Level, window.Column, window.Row, window.Width, window.Height,
        heights.data(), error))
  {
    return "Cannot read " + std::string(this->Pyramid->GetFileName()) + ": " + error + ".";
  }
  this->UpdateProgress(ReadingShare);
  std::optional<relevo::GlobeRegion> globe;
  if (this->Frame == GEOCENTRIC)
  {
    globe.emplace(*this->Terrain, this->Exaggeration, window.Level, window.Column, window.Row);
    globe->Close(heights, window.Width, window.Height, columns, rows);
  }
  relevo::LatticeDecimation decimation(std::move(heights), window.Width, window.Height);
  if (globe)
  {
    decimation.SetShapeError([&globe](const relevo::LatticeDecimation::Bounds& bounds)
      { return globe->GetShapeError(bounds); },
      globe->GetShapeErrorOfCell());
  }
  double tolerance = this->MaximumError / contents.VerticalUnit;
  if (window.Level > 0)
  {
    // The error of the level is that of triangles.
    levelError += decimation.GetLargestTwist() / 4.0;
    if (levelError > CoarserShare * tolerance)
    {
      return "The region has too many samples for a MaximumError of " +
        vtkVariant(this->MaximumError).ToString() + ". Choose a smaller region or a larger error.";
    }
    tolerance -= levelError;
  }
  using Result = relevo::LatticeDecimation::Result;
  const Result result = decimation.Refine(tolerance,
    [this, &decimation]
    {
      const double progress =
        ReadingShare + (RefiningShare - ReadingShare) * decimation.GetProgress();
      if (progress > this->GetProgress() + ProgressStep)
      {
        this->UpdateProgress(progress);
      }
      return relevo::IsAborted(this);
    });
  if (result == Result::TooManyTriangles)
  {
    return "The region needs too many triangles for a MaximumError of " +
      vtkVariant(this->MaximumError).ToString() + ". Choose a smaller region or a larger error.";
  }
  if (result == Result::Aborted)
  {
    return "";
  }
  this->MetersInUse = (decimation.GetError() + levelError) * contents.VerticalUnit;
  this->UpdateProgress(RefiningShare);
  OutputTriangles(decimation, window, contents, this->Terrain->GetPlacement(this->Exaggeration),
    columns, rows, output);
  this->UpdateProgress(BuiltShare);
  return "";
}

//------------------------------------------------------------------------------
void vtkTerrainMeshSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pyramid: " << this->Pyramid.Get() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "Region: (" << this->Region[0] << ", " << this->Region[1] << ", "
     << this->Region[2] << ", " << this->Region[3] << ")\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "UseBase: " << (this->UseBase ? "on" : "off") << "\n";
  os << indent << "BaseHeight: " << this->BaseHeight << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Frame: " << this->Frame << "\n";
  os << indent << "ImageryFileName: " << (this->ImageryFileName ? this->ImageryFileName : "(none)")
     << "\n";
  os << indent << "ImageryBands: " << this->ImageryBands[0] << ", " << this->ImageryBands[1] << ", "
     << this->ImageryBands[2] << "\n";
  os << indent << "MaximumImagerySize: " << this->MaximumImagerySize << "\n";
}
