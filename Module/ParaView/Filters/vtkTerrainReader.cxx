// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainReader.h"

#include "Checks/ErrorCollector.h"
#include "Checks/SettingChecks.h"
#include "ProcessError.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 2>;

// The heights of a mesh, and its place on the map.
struct Grid
{
  std::array<std::vector<double>, 2> Samples; // that the points along columns and rows are at
  std::vector<double> Heights;
  Vector Origin; // of the first sample
  Vector Column; // to the next sample of a row
  Vector Row;

  int GetSize(int axis) const { return static_cast<int>(this->Samples[axis].size()); }

  double GetHeight(int i, int j) const
  {
    const int column = std::clamp(i, 0, this->GetSize(0) - 1);
    const int row = std::clamp(j, 0, this->GetSize(1) - 1);
    return this->Heights[column + std::size_t(row) * this->Samples[0].size()];
  }

  // The distance of the neighbours of a point, in samples.
  double GetSpan(int axis, int i) const
  {
    return this->Samples[axis][std::min(i + 1, this->GetSize(axis) - 1)] -
      this->Samples[axis][std::max(i - 1, 0)];
  }
};

// Return every n-th sample, and the last one, where the raster ends.
std::vector<double> MakeSamples(int count, double spacing, int number, int resolution)
{
  std::vector<double> samples;
  for (int i = 0; i < count; ++i)
  {
    samples.push_back(i * spacing);
  }
  if (samples.back() < number - 1)
  {
    if (count == resolution)
    {
      samples.pop_back();
    }
    samples.push_back(number - 1);
  }
  return samples;
}

bool MakeGrid(vtkTerrainPyramid* pyramid, int resolution, Grid& grid)
{
  const auto image = vtkSmartPointer<vtkImageData>::Take(pyramid->GetReducedElevations(resolution));
  if (!image)
  {
    return false;
  }
  const int* counts = image->GetDimensions();
  const double spacing = image->GetSpacing()[0];
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Samples[axis] =
      MakeSamples(counts[axis], spacing, pyramid->GetDimensions()[axis], resolution);
  }
  const auto locate = [pyramid](double column, double row)
  {
    const double sample[2] = { column, row };
    Vector raster;
    pyramid->SampleToRaster(sample, raster.data());
    return raster;
  };
  for (double row : grid.Samples[1])
  {
    for (double column : grid.Samples[0])
    {
      const int i = static_cast<int>(column / spacing);
      const int j = static_cast<int>(row / spacing);
      const Vector raster = locate(column, row);
      grid.Heights.push_back(i * spacing == column && j * spacing == row
          ? image->GetScalarComponentAsDouble(i, j, 0, 0)
          : pyramid->GetNearestElevation(raster[0], raster[1]));
    }
  }
  const auto place = [&](double column, double row)
  {
    const Vector position = locate(column, row);
    const double raster[3] = { position[0], position[1], 0.0 };
    double map[3] = { 0.0, 0.0, 0.0 };
    pyramid->RasterToMap(raster, map);
    return Vector{ { map[0], map[1] } };
  };
  // The image's spacing gives longer, and so more exact, differences than one sample.
  grid.Origin = place(0.0, 0.0);
  const Vector right = place(spacing, 0.0);
  const Vector below = place(0.0, spacing);
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Column[axis] = (right[axis] - grid.Origin[axis]) / spacing;
    grid.Row[axis] = (below[axis] - grid.Origin[axis]) / spacing;
  }
  return true;
}

// The derivatives along x and y. Neighbours without data are replaced by the point itself.
Vector GetGradient(const Grid& grid, int i, int j)
{
  const double center = grid.GetHeight(i, j);
  const auto get = [&](int dx, int dy)
  {
    const double height = grid.GetHeight(i + dx, j + dy);
    return std::isnan(height) ? center : height;
  };
  // At a border, the difference is one-sided.
  const double columns = 4.0 * grid.GetSpan(0, i);
  const double rows = 4.0 * grid.GetSpan(1, j);
  const double alongColumn =
    (get(1, -1) + 2.0 * get(1, 0) + get(1, 1) - get(-1, -1) - 2.0 * get(-1, 0) - get(-1, 1)) /
    columns;
  const double alongRow =
    (get(-1, 1) + 2.0 * get(0, 1) + get(1, 1) - get(-1, -1) - 2.0 * get(0, -1) - get(1, -1)) / rows;
  const double determinant = grid.Column[0] * grid.Row[1] - grid.Column[1] * grid.Row[0];
  return { { (alongColumn * grid.Row[1] - alongRow * grid.Column[1]) / determinant,
    (alongRow * grid.Column[0] - alongColumn * grid.Row[0]) / determinant } };
}

// Points without data have this height, so that they do not enlarge the bounds.
double FindLowestHeight(const Grid& grid)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (double height : grid.Heights)
  {
    lowest = std::fmin(lowest, height);
  }
  return std::isfinite(lowest) ? lowest : 0.0;
}

void AddPoints(const Grid& grid, double unit, const double offset[3], vtkPolyData* output)
{
  const auto number = static_cast<vtkIdType>(grid.Heights.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(number);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  vtkNew<vtkFloatArray> slopes;
  slopes->SetName("Slope");
  vtkNew<vtkFloatArray> aspects;
  aspects->SetName("Aspect");
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(heights),
         static_cast<vtkDataArray*>(slopes), static_cast<vtkDataArray*>(aspects) })
  {
    array->SetNumberOfTuples(number);
    output->GetPointData()->AddArray(array);
  }
  output->GetPointData()->SetActiveScalars("Height");
  const double lowest = FindLowestHeight(grid);
  for (int j = 0; j < grid.GetSize(1); ++j)
  {
    for (int i = 0; i < grid.GetSize(0); ++i)
    {
      const vtkIdType id = i + vtkIdType(j) * grid.GetSize(0);
      const double column = grid.Samples[0][i];
      const double row = grid.Samples[1][j];
      const double height = grid.GetHeight(i, j);
      const Vector gradient = GetGradient(grid, i, j);
      points->SetPoint(id, grid.Origin[0] + column * grid.Column[0] + row * grid.Row[0] + offset[0],
        grid.Origin[1] + column * grid.Column[1] + row * grid.Row[1] + offset[1],
        (std::isnan(height) ? lowest : height) * unit + offset[2]);
      heights->SetValue(id, height);
      const double steepness = unit * std::hypot(gradient[0], gradient[1]);
      slopes->SetValue(id, static_cast<float>(vtkMath::DegreesFromRadians(std::atan(steepness))));
      const double aspect =
        vtkMath::DegreesFromRadians(std::atan2(-unit * gradient[0], -unit * gradient[1]));
      aspects->SetValue(id,
        steepness > 0.0 ? static_cast<float>(aspect < 0.0 ? aspect + 360.0 : aspect)
                        : std::numeric_limits<float>::quiet_NaN());
    }
  }
  output->SetPoints(points);
}

void AddTriangles(const Grid& grid, vtkPolyData* output)
{
  // The rows of most rasters go south.
  const bool isMirrored = grid.Column[0] * grid.Row[1] - grid.Column[1] * grid.Row[0] < 0.0;
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j + 1 < grid.GetSize(1); ++j)
  {
    for (int i = 0; i + 1 < grid.GetSize(0); ++i)
    {
      const vtkIdType first = i + vtkIdType(j) * grid.GetSize(0);
      const vtkIdType corners[4] = { first, first + 1, first + 1 + grid.GetSize(0),
        first + grid.GetSize(0) };
      const bool isMissing = std::isnan(grid.GetHeight(i, j)) ||
        std::isnan(grid.GetHeight(i + 1, j)) || std::isnan(grid.GetHeight(i + 1, j + 1)) ||
        std::isnan(grid.GetHeight(i, j + 1));
      for (int half = 0; half < 2 && !isMissing; ++half)
      {
        const vtkIdType ids[3] = { corners[0], corners[isMirrored ? half + 2 : half + 1],
          corners[isMirrored ? half + 1 : half + 2] };
        cells->InsertNextCell(3, ids);
      }
    }
  }
  output->SetPolys(cells);
}

void AddText(vtkPolyData* output, const char* name, const char* value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

void AddPoint(vtkPolyData* output, const char* name, const double point[3])
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(point);
  output->GetFieldData()->AddArray(array);
}
}

vtkStandardNewMacro(vtkTerrainReader);

vtkTerrainReader::vtkTerrainReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkTerrainReader::~vtkTerrainReader()
{
  this->SetFileName(nullptr);
}

void vtkTerrainReader::SetResolution(int points)
{
  relevo::SetInRange(this, "Resolution", this->Resolution, points, 2, 4096);
}

void vtkTerrainReader::SetCoordinates(int type)
{
  relevo::SetChoice(this, "Coordinates", this->Coordinates, type, { "CENTERED", "RASTER" });
}

std::string vtkTerrainReader::Open(vtkTerrainPyramid* pyramid)
{
  if (!this->FileName || !*this->FileName)
  {
    return "FileName is not set. Set it to a raster of heights.";
  }
  pyramid->SetFileName(this->FileName);
  if (!pyramid->Update())
  {
    return pyramid->GetErrorMessage();
  }
  const int* size = pyramid->GetDimensions();
  return std::min(size[0], size[1]) < 2 ? std::string(this->FileName) +
      " has only one row or column of samples, between which there is no surface."
                                        : "";
}

void vtkTerrainReader::FindOffset(
  vtkTerrainPyramid* pyramid, const double center[3], double offset[3])
{
  std::fill_n(offset, 3, 0.0);
  if (this->Coordinates != RASTER)
  {
    return;
  }
  // A step of one unit of the raster is one metre.
  const double step[3] = { center[0] + 1.0, center[1] + 1.0, 0.0 };
  double map[3] = { 0.0, 0.0, 0.0 };
  pyramid->RasterToMap(step, map);
  constexpr double rounding = 1e-6;
  if (!pyramid->IsGeographic() && std::abs(map[0] - 1.0) < rounding &&
    std::abs(map[1] - 1.0) < rounding)
  {
    std::copy_n(center, 3, offset);
  }
  else if (relevo::IsReportingProcess(vtkMultiProcessController::GetGlobalController()))
  {
    vtkWarningMacro("Coordinates is Raster, but those of "
      << this->FileName << " are not in metres. The points are centered instead.");
  }
}

// Otherwise only the first process would be updated.
int vtkTerrainReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkTerrainReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const bool isFirst = relevo::IsReportingProcess(controller);
  vtkNew<vtkTerrainPyramid> pyramid;
  std::string messages; // are those of Open() or of MakeGrid()
  pyramid->AddObserver(vtkCommand::ErrorEvent, relevo::NewErrorCollector(messages));
  std::string own = this->Open(pyramid);
  Grid grid;
  if (own.empty() && isFirst && !MakeGrid(pyramid, this->Resolution, grid))
  {
    own = pyramid->GetErrorMessage();
  }
  const std::string error = relevo::FindProcessError(own, controller);
  if (!error.empty())
  {
    if (isFirst)
    {
      vtkErrorMacro(<< error);
    }
    return 1; // the pipeline would report a second error
  }
  const double zero[3] = { 0.0, 0.0, 0.0 };
  double center[3] = { 0.0, 0.0, 0.0 };
  pyramid->MapToRaster(zero, center);
  double offset[3];
  this->FindOffset(pyramid, center, offset);
  AddText(output, "FileName", this->FileName);
  AddText(output, "CoordinateSystem", pyramid->GetCoordinateSystem());
  AddText(output, "HeightUnit", pyramid->GetHeightUnit());
  AddPoint(output, "Origin", center);
  AddPoint(output, "Offset", offset);
  if (isFirst)
  {
    AddPoints(grid, pyramid->GetVerticalUnit(), offset, output);
    AddTriangles(grid, output);
    const std::string doubt = pyramid->GetSampleWarning();
    if (!doubt.empty())
    {
      vtkWarningMacro(<< this->FileName << doubt);
    }
    if (output->GetNumberOfPolys() == 0)
    {
      vtkWarningMacro(<< this->FileName
                      << " has no surface: heights are missing in each square of four samples. "
                         "Check the no-data value.");
    }
  }
  return 1;
}

void vtkTerrainReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Coordinates: " << this->Coordinates << "\n";
}
