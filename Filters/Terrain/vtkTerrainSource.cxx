// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainSource.h"

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkImagery.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRaster.h"
#include "vtkRelevoCompatibility.h"
#include "vtkSMPTools.h"
#include "vtkTerrainFrame.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
// Shares of the progress.
constexpr double HeightsShare = 0.6;
constexpr double MeshShare = 0.1;

// A regular division of (u, v) in [0, 1]^2.
struct Grid
{
  int Cells[2];

  vtkIdType NumberOfPoints() const { return (this->Cells[0] + 1LL) * (this->Cells[1] + 1LL); }
  vtkIdType NumberOfCells() const
  {
    return static_cast<vtkIdType>(this->Cells[0]) * this->Cells[1];
  }
  vtkIdType Point(int i, int j) const { return j * (this->Cells[0] + 1LL) + i; }
  double Parameter(int axis, int i) const { return static_cast<double>(i) / this->Cells[axis]; }
};

// Squares as nearly as the side lengths allow, never finer than the texels.
Grid divide(const double lengths[2], const int texels[2], int resolution)
{
  Grid grid;
  const double longer = std::max(lengths[0], lengths[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double cells = std::round(resolution * (lengths[axis] / longer));
    grid.Cells[axis] = static_cast<int>(std::clamp(cells, 1.0, static_cast<double>(texels[axis])));
  }
  return grid;
}

// The texels that heights between two parameters draw upon, along one axis.
void texelRange(double begin, double end, int texels, int range[2])
{
  range[0] = std::clamp(static_cast<int>(std::floor(begin * texels - 0.5)), 0, texels - 1);
  range[1] = std::clamp(static_cast<int>(std::ceil(end * texels - 0.5)), 0, texels - 1);
}

// For each square whether any height in it draws upon a sample with data.
std::vector<unsigned char> findSquaresWithData(
  const Grid& grid, const int texels[2], const unsigned char* validity)
{
  std::vector<unsigned char> hasData(grid.NumberOfCells());
  vtkSMPTools::For(0, grid.Cells[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int j = static_cast<int>(begin); j < end; ++j)
      {
        int rows[2];
        texelRange(grid.Parameter(1, j), grid.Parameter(1, j + 1), texels[1], rows);
        for (int i = 0; i < grid.Cells[0]; ++i)
        {
          int columns[2];
          texelRange(grid.Parameter(0, i), grid.Parameter(0, i + 1), texels[0], columns);
          bool found = false;
          for (int row = rows[0]; row <= rows[1] && !found; ++row)
          {
            const unsigned char* first = validity + static_cast<std::size_t>(row) * texels[0];
            found = std::find_if(first + columns[0], first + columns[1] + 1,
                      [](unsigned char valid) { return valid != 0; }) != first + columns[1] + 1;
          }
          hasData[static_cast<std::size_t>(j) * grid.Cells[0] + i] = found;
        }
      }
    });
  return hasData;
}

double distance(const relevo::TerrainFrame& frame, double u0, double v0, double u1, double v1)
{
  std::array<double, 2> a;
  std::array<double, 2> b;
  frame.Place(u0, v0, a);
  frame.Place(u1, v1, b);
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}
}

vtkStandardNewMacro(vtkTerrainSource);

vtkTerrainSource::vtkTerrainSource()
  : ImageryFileName(nullptr)
  , ImageryBands{ 0, 0, 0 }
  , MaximumImagerySize(4096)
  , Resolution(128)
  , Exaggeration(1.0)
  , Origin{ 0.0, 0.0, 0.0 }
  , VerticalUnit(1.0)
{
  this->SetNumberOfInputPorts(0);
  this->HeightMap->AddObserver(vtkCommand::ErrorEvent, this, &vtkTerrainSource::ForwardError);
  this->HeightMap->AddObserver(vtkCommand::ProgressEvent, this, &vtkTerrainSource::ForwardProgress);
  this->Displacement->SetHeightMap(this->HeightMap);
  this->Displacement->SetDirection(0.0, 0.0, 1.0);
}

vtkTerrainSource::~vtkTerrainSource()
{
  this->SetImageryFileName(nullptr);
}

void vtkTerrainSource::SetFileName(const char* fileName)
{
  this->HeightMap->SetFileName(fileName); // which is part of our modification time
}

char* vtkTerrainSource::GetFileName()
{
  return this->HeightMap->GetFileName();
}

void vtkTerrainSource::SetExaggeration(double exaggeration)
{
  if (!std::isfinite(exaggeration))
  {
    vtkErrorMacro(<< "Exaggeration must be finite, not " << exaggeration << ".");
    return;
  }
  if (this->Exaggeration != exaggeration)
  {
    this->Exaggeration = exaggeration;
    this->Displacement->SetScale(exaggeration * this->VerticalUnit);
    this->Modified();
  }
}

void vtkTerrainSource::SetNoDataValue(double value)
{
  this->HeightMap->SetNoDataValue(value);
}

double vtkTerrainSource::GetNoDataValue()
{
  return this->HeightMap->GetNoDataValue();
}

void vtkTerrainSource::SetNoDataPolicy(int policy)
{
  if (policy != vtkDisplacement::HOLE && policy != vtkDisplacement::FILL)
  {
    vtkErrorMacro(<< "There is no no-data policy " << policy << ".");
    return;
  }
  if (this->GetNoDataPolicy() != policy)
  {
    this->Displacement->SetNoDataPolicy(policy);
    this->Modified();
  }
}

int vtkTerrainSource::GetNoDataPolicy()
{
  return this->Displacement->GetNoDataPolicy();
}

void vtkTerrainSource::SetNoDataPolicyToHole()
{
  this->SetNoDataPolicy(vtkDisplacement::HOLE);
}

void vtkTerrainSource::SetNoDataPolicyToFill()
{
  this->SetNoDataPolicy(vtkDisplacement::FILL);
}

vtkDisplacement* vtkTerrainSource::GetDisplacement()
{
  return this->Displacement;
}

vtkHeightMap* vtkTerrainSource::GetHeightMap()
{
  return this->HeightMap;
}

vtkImageData* vtkTerrainSource::GetImagery()
{
  return this->ImageryFileName ? this->Imagery.Get() : nullptr;
}

const char* vtkTerrainSource::GetCoordinateSystem()
{
  return this->CoordinateSystem.c_str();
}

vtkMTimeType vtkTerrainSource::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->HeightMap->GetMTime());
}

void vtkTerrainSource::ForwardError(vtkObject*, unsigned long, void* message)
{
  // The part that says what is wrong, without the inner object's class, address and source line.
  std::string text(static_cast<const char*>(message));
  const std::size_t start = text.find("): ");
  text.erase(0, start == std::string::npos ? 0 : start + 3);
  text.erase(text.find_last_not_of("\n") + 1);
  vtkErrorMacro(<< text);
}

void vtkTerrainSource::ForwardProgress(vtkObject*, unsigned long, void* progress)
{
  this->UpdateProgress(HeightsShare * *static_cast<double*>(progress));
  if (relevo::IsAborted(this))
  {
    this->HeightMap->AbortExecuteOn();
  }
}

int vtkTerrainSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->CoordinateSystem.clear();
  std::fill_n(this->Origin, 3, 0.0);
  if (!this->HeightMap->Update()) // has told why
  {
    this->Imagery->Initialize();
    return relevo::IsAborted(this) ? 1 : 0;
  }

  relevo::Georeference location;
  std::string error;
  if (this->Locate(location, this->VerticalUnit, error))
  {
    const relevo::TerrainFrame frame(location);
    if (this->BuildMesh(frame, output, error) && this->UpdateImagery(location, error))
    {
      this->CoordinateSystem = location.WKT;
      std::copy_n(frame.GetCenter().data(), 2, this->Origin);
      this->Displacement->SetScale(this->Exaggeration * this->VerticalUnit);
      this->UpdateProgress(1.0);
      return 1;
    }
  }
  output->Initialize();
  this->Imagery->Initialize();
  this->ImageryState.clear();
  if (error.empty()) // aborted
  {
    return 1;
  }
  vtkErrorMacro(<< error);
  return 0;
}

bool vtkTerrainSource::Locate(
  relevo::Georeference& location, double& verticalUnit, std::string& error)
{
  verticalUnit = 1.0;
  if (this->HeightMap->GetImageData())
  {
    const int* texels = this->HeightMap->GetDimensions();
    location.SetSize(texels[0], texels[1]);
    return true;
  }
  const std::string name = this->GetFileName();
  const auto raster = relevo::Raster::Open(name, error);
  if (!raster)
  {
    error = "Cannot read " + name + ": " + error + ".";
    return false;
  }
#if !RELEVO_HAS_GDAL
  vtkWarningMacro(<< "This build of Relevo is without GDAL: the georeference of " << name
                  << ", if it has one, is not read, and one texel is one unit.");
#endif
  location = raster->Describe().Location;
  verticalUnit = raster->Describe().VerticalUnit;
  if (location.System == relevo::Georeference::Kind::Unsupported)
  {
    error = name + " is neither in longitude and latitude nor in a projection; project it first.";
    return false;
  }
  return true;
}

bool vtkTerrainSource::BuildMesh(
  const relevo::TerrainFrame& frame, vtkPolyData* output, std::string& error)
{
  const int* texels = this->HeightMap->GetDimensions();
  const double lengths[2] = { distance(frame, 0.0, 0.5, 1.0, 0.5),
    distance(frame, 0.5, 0.0, 0.5, 1.0) };
  const Grid grid = divide(lengths, texels, this->Resolution);

  std::vector<unsigned char> kept(grid.NumberOfCells(), 1);
  if (this->GetNoDataPolicy() == vtkDisplacement::HOLE && this->HeightMap->HasNoData())
  {
    kept = findSquaresWithData(grid, texels, this->HeightMap->GetValidity());
  }

  // Right triangles with alternating diagonals: no direction is preferred.
  std::vector<vtkIdType> outputPoint(grid.NumberOfPoints(), -1);
  std::vector<int> gridPoint; // i, j of the points in use
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(2 * grid.NumberOfCells(), 6 * grid.NumberOfCells());
  const auto point = [&](int i, int j)
  {
    vtkIdType& id = outputPoint[grid.Point(i, j)];
    if (id < 0)
    {
      id = static_cast<vtkIdType>(gridPoint.size() / 2);
      gridPoint.insert(gridPoint.end(), { i, j });
    }
    return id;
  };
  for (int j = 0; j < grid.Cells[1]; ++j)
  {
    for (int i = 0; i < grid.Cells[0]; ++i)
    {
      if (!kept[static_cast<std::size_t>(j) * grid.Cells[0] + i])
      {
        continue;
      }
      const vtkIdType corners[4] = { point(i, j), point(i + 1, j), point(i + 1, j + 1),
        point(i, j + 1) };
      const int start = (i + j) % 2;
      for (int half : { 0, 2 })
      {
        triangles->InsertNextCell({ corners[(start + half) % 4], corners[(start + half + 1) % 4],
          corners[(start + half + 2) % 4] });
      }
    }
  }

  const vtkIdType numberOfPoints = static_cast<vtkIdType>(gridPoint.size() / 2);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkFloatArray> textureCoordinates;
  textureCoordinates->SetName("TextureCoordinates");
  textureCoordinates->SetNumberOfComponents(2);
  textureCoordinates->SetNumberOfTuples(numberOfPoints);
  std::atomic<bool> beyondHorizon(false);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const double u = grid.Parameter(0, gridPoint[2 * id]);
        const double v = grid.Parameter(1, gridPoint[2 * id + 1]);
        std::array<double, 2> place;
        if (!frame.Place(u, v, place))
        {
          beyondHorizon = true;
        }
        const float xyz[3] = { static_cast<float>(place[0]), static_cast<float>(place[1]), 0.0f };
        const float up[3] = { 0.0f, 0.0f, 1.0f };
        const float uv[2] = { static_cast<float>(u), static_cast<float>(v) };
        coordinates->SetTypedTuple(id, xyz);
        normals->SetTypedTuple(id, up);
        textureCoordinates->SetTypedTuple(id, uv);
      }
    });
  if (beyondHorizon)
  {
    error = std::string(this->GetFileName()) +
      " reaches beyond the horizon of its centre, where its tangent plane is no map of the earth; "
      "project it first, or cut it to less than 80 degrees around the centre.";
    return false;
  }

  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->SetTCoords(textureCoordinates);
  this->UpdateProgress(HeightsShare + MeshShare);
  return !this->GetAbortExecute();
}

bool vtkTerrainSource::UpdateImagery(const relevo::Georeference& location, std::string& error)
{
  if (!this->ImageryFileName || !*this->ImageryFileName)
  {
    this->Imagery->Initialize();
    this->ImageryState.clear();
    return true;
  }
  std::ostringstream state;
  state << this->ImageryFileName << '\n' << this->MaximumImagerySize;
  for (int band : this->ImageryBands)
  {
    state << ' ' << band;
  }
  if (this->ImageryState == state.str() && this->ImageryTime > this->HeightMap->GetSamplesMTime())
  {
    return true;
  }

  relevo::ImagerySource source;
  source.FileName = this->ImageryFileName;
  std::copy_n(this->ImageryBands, 3, source.Bands.begin());
  source.MaximumSize = this->MaximumImagerySize;
  relevo::Imagery imagery;
  const auto progress = [this](double share)
  {
    this->UpdateProgress(HeightsShare + MeshShare + (1.0 - HeightsShare - MeshShare) * share);
    return !this->GetAbortExecute();
  };
  if (!relevo::DrapeImagery(source, location, imagery, progress, error))
  {
    error = error.empty() ? error : "Cannot drape " + source.FileName + ": " + error + ".";
    return false;
  }
  this->Imagery->SetDimensions(imagery.Width, imagery.Height, 1);
  this->Imagery->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(imagery.Pixels.begin(), imagery.Pixels.end(),
    static_cast<unsigned char*>(this->Imagery->GetScalarPointer()));
  this->Imagery->GetPointData()->GetScalars()->SetName("Imagery");
  this->Imagery->Modified();
  this->ImageryTime.Modified();
  this->ImageryState = state.str();
  return true;
}

void vtkTerrainSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->GetFileName() ? this->GetFileName() : "(none)") << "\n";
  os << indent << "ImageryFileName: " << (this->ImageryFileName ? this->ImageryFileName : "(none)")
     << "\n";
  os << indent << "ImageryBands: " << this->ImageryBands[0] << ", " << this->ImageryBands[1] << ", "
     << this->ImageryBands[2] << "\n";
  os << indent << "MaximumImagerySize: " << this->MaximumImagerySize << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "Origin: " << this->Origin[0] << ", " << this->Origin[1] << ", "
     << this->Origin[2] << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "HeightMap:\n";
  this->HeightMap->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Displacement:\n";
  this->Displacement->PrintSelf(os, indent.GetNextIndent());
}
