// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MicroMeshes.h"

#include "Options/ViewerOptions.h"
#include "Scene/VolumeArray.h"
#include "Text/ViewerMessages.h"

#include "vtkAppendFilter.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMicroMeshContourFilter.h"
#include "vtkMicroMeshFilter.h"
#include "vtkMicroMeshWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <system_error>

namespace
{
constexpr double DefaultShare = 0.001; // of the diagonal

double GetTolerance(const ViewerOptions& options, double diagonal)
{
  return options.Tolerance.value_or(options.ToleranceShare.value_or(DefaultShare) * diagonal);
}

// The diagonal of the input that a micro-mesh stores, or its own.
double GetDiagonal(vtkPolyData* micro)
{
  vtkDataArray* bounds = micro->GetFieldData()->GetArray("MicroMeshInputBounds");
  if (!bounds || bounds->GetNumberOfTuples() != 6)
  {
    return micro->GetLength();
  }
  double squared = 0.0;
  for (vtkIdType axis = 0; axis < 3; ++axis)
  {
    const double side = bounds->GetComponent(2 * axis + 1, 0) - bounds->GetComponent(2 * axis, 0);
    squared += side * side;
  }
  return std::sqrt(squared);
}

// The triangles in memory, with indices of 4 bytes and points of 3 floats. Files of the input can
// have other data and time steps.
double GetSize(double triangles)
{
  constexpr double sizeOfTriangle = 12.0;
  constexpr double pointsPerTriangle = 0.5;
  constexpr double sizeOfPoint = 12.0;
  return triangles * (sizeOfTriangle + pointsPerTriangle * sizeOfPoint);
}

std::string DescribeFile(const std::string& file, double triangles)
{
  std::error_code error;
  const auto size = static_cast<double>(std::filesystem::file_size(file, error));
  std::ostringstream text;
  text << file << ": " << std::fixed << std::setprecision(1) << size / 1e3 << " kB, "
       << std::setprecision(4) << size / GetSize(triangles) << " of the " << std::setprecision(1)
       << GetSize(triangles) / 1e3 << " kB of these triangles";
  return text.str();
}

bool HasSolidCells(vtkDataSet* data)
{
  bool hasAny = false;
  for (vtkIdType cell = 0; !hasAny && cell < data->GetNumberOfCells(); ++cell)
  {
    hasAny = IsVolumeCell(data, cell);
  }
  return hasAny;
}

// The data set, or its cells as an unstructured grid if vtkMicroMeshContourFilter needs that.
vtkSmartPointer<vtkDataSet> MakeContourInput(vtkDataSet* data)
{
  if (vtkImageData::SafeDownCast(data) || vtkUnstructuredGrid::SafeDownCast(data))
  {
    return data;
  }
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(data);
  append->Update();
  return append->GetOutput();
}

// The point array of isosurfaces: the chosen one, the scalars, or the first with one component.
std::string FindContourArray(vtkDataSet* data, const std::string& chosen)
{
  vtkPointData* arrays = data->GetPointData();
  if (!chosen.empty())
  {
    return chosen;
  }
  vtkDataArray* scalars = arrays->GetScalars();
  if (scalars && scalars->GetName() && scalars->GetNumberOfComponents() == 1)
  {
    return scalars->GetName();
  }
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1)
    {
      return array->GetName();
    }
  }
  return "";
}

struct Encoded
{
  vtkSmartPointer<vtkPolyData> Mesh;
  double Triangles; // of the input
};

Encoded EncodeIsosurfaces(
  const ViewerOptions& options, const DenseSurface& surface, ViewerMessages& messages)
{
  if (!HasSolidCells(surface.Cells))
  {
    throw ViewerError("--isosurfaces: " + options.Input + " has no solid cells");
  }
  const vtkSmartPointer<vtkDataSet> data = MakeContourInput(surface.Cells);
  const std::string array = FindContourArray(data, surface.Array);
  if (array.empty())
  {
    throw ViewerError("--isosurfaces: " + options.Input + " has no point array with one component");
  }
  vtkNew<vtkMicroMeshContourFilter> filter;
  messages.Observe(filter, "encoding");
  filter->SetInputData(data);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  filter->SetTolerance(GetTolerance(options, data->GetLength()));
  for (std::size_t i = 0; i < options.IsoSurfaces.size(); ++i)
  {
    filter->SetValue(static_cast<int>(i), options.IsoSurfaces[i]);
  }
  filter->Update();
  messages.Check();
  if (filter->GetOutput()->GetNumberOfCells() == 0)
  {
    double range[2];
    data->GetPointData()->GetArray(array.c_str())->GetRange(range);
    std::ostringstream text;
    text << "--isosurfaces: " << options.Input << " has no isosurface at these values. '" << array
         << "' is from " << range[0] << " to " << range[1];
    throw ViewerError(text.str());
  }
  return { filter->GetOutput(), static_cast<double>(filter->GetNumberOfTriangles()) };
}

Encoded EncodeSurface(
  const ViewerOptions& options, const DenseSurface& surface, ViewerMessages& messages)
{
  vtkNew<vtkMicroMeshFilter> filter;
  messages.Observe(filter, "encoding");
  filter->SetInputData(surface.Mesh);
  filter->SetTolerance(GetTolerance(options, surface.Mesh->GetLength()));
  filter->SetFeatureAngle(options.FeatureAngle.value_or(filter->GetFeatureAngle()));
  filter->Update();
  messages.Check();
  if (filter->GetOutput()->GetNumberOfCells() == 0)
  {
    throw ViewerError(options.Input + " has no triangles to encode");
  }
  return { filter->GetOutput(), static_cast<double>(surface.Mesh->GetNumberOfCells()) };
}
}

//------------------------------------------------------------------------------
bool IsMicroMesh(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetArray("MicroMeshDisplacements") != nullptr;
}

//------------------------------------------------------------------------------
std::string DescribeMicroMesh(vtkPolyData* micro)
{
  vtkDataArray* error = micro->GetFieldData()->GetArray("MicroMeshError");
  std::ostringstream text;
  text << "micro-mesh: " << micro->GetNumberOfCells() << " faces";
  if (error && error->GetNumberOfTuples() == 2)
  {
    const double toResult = error->GetComponent(0, 0);
    const double toInput = error->GetComponent(1, 0);
    text << std::setprecision(3) << ", error at most " << toResult << " from the mesh and "
         << toInput << " back, " << 100.0 * std::max(toResult, toInput) / GetDiagonal(micro)
         << " % of the diagonal of the input";
  }
  return text.str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> EncodeMicroMesh(const ViewerOptions& options,
  const DenseSurface& surface, const std::string& file, ViewerMessages& messages,
  std::string& report)
{
  const bool hasIsosurfaces = !options.IsoSurfaces.empty();
  const Encoded encoded = hasIsosurfaces ? EncodeIsosurfaces(options, surface, messages)
                                         : EncodeSurface(options, surface, messages);
  vtkNew<vtkMicroMeshWriter> writer;
  messages.Observe(writer);
  writer->SetInputData(encoded.Mesh);
  writer->SetFileName(file.c_str());
  writer->Write();
  messages.Check();
  std::ostringstream text;
  text << DescribeMicroMesh(encoded.Mesh) << "; the mesh has "
       << static_cast<vtkIdType>(encoded.Triangles) << " faces\n"
       << DescribeFile(file, encoded.Triangles);
  if (!hasIsosurfaces && HasSolidCells(surface.Cells))
  {
    text << "\nThis is the outer surface of solid cells. For isosurfaces of a point array, use "
            "--isosurfaces VALUES";
  }
  report = text.str();
  return encoded.Mesh;
}
