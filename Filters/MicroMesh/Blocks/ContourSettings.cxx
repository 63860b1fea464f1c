// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/ContourSettings.h"

#include "Arrays/NearestTuple.h"
#include "Checks/MisplacedArray.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
bool IsFinite(vtkPolyData* surface, vtkIdType point)
{
  double x[3];
  surface->GetPoint(point, x);
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

void RemoveInfiniteTriangles(vtkPolyData* surface)
{
  bool areFinite = true;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints() && areFinite; ++i)
  {
    areFinite = IsFinite(surface, i);
  }
  if (areFinite)
  {
    return;
  }
  vtkNew<vtkCellArray> kept;
  vtkCellArray* polys = surface->GetPolys();
  for (vtkIdType cell = 0; cell < polys->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    polys->GetCellAtId(cell, size, ids);
    if (std::all_of(ids, ids + size, [&](vtkIdType id) { return IsFinite(surface, id); }))
    {
      kept->InsertNextCell(size, ids);
    }
  }
  surface->SetPolys(kept);
}

void RestoreType(vtkDataArray* original, vtkDataArray* array, vtkPointData* data)
{
  auto restored = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(original->GetDataType()));
  const int components = array->GetNumberOfComponents();
  restored->SetName(array->GetName());
  restored->SetNumberOfComponents(components);
  restored->SetNumberOfTuples(array->GetNumberOfTuples());
  restored->Fill(0.0);
  std::vector<double> tuple(static_cast<std::size_t>(components));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, tuple.data());
    SetNearestTuple(restored, i, tuple.data());
  }
  data->AddArray(restored);
}
}

vtkDataArray* FindScalars(vtkDataSet* volume, const ContourSettings& settings, std::string& error)
{
  vtkDataArray* scalars = volume->GetPointData()->GetArray(settings.Scalars.c_str());
  const std::string name = "\"" + settings.Scalars + "\"";
  if (!scalars)
  {
    const std::string misplaced =
      DescribeMisplacedArray(volume, settings.Scalars, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    error =
      "The input has " + (misplaced.empty() ? "no numeric point array " + name : misplaced) + ".";
    return nullptr;
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    error = "The point array " + name + " has " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, but 1 is needed.";
    return nullptr;
  }
  if (scalars->GetNumberOfTuples() < volume->GetNumberOfPoints())
  {
    error = "The point array " + name + " has " + std::to_string(scalars->GetNumberOfTuples()) +
      " tuples, but there are " + std::to_string(volume->GetNumberOfPoints()) + " points.";
    return nullptr;
  }
  return scalars;
}

void CopyContourArrays(
  vtkDataSet* volume, vtkDataArray* scalars, const ContourSettings& settings, vtkPointData* to)
{
  vtkPointData* from = volume->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays() && settings.Attributes; ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (array && array != scalars && array->GetName() && array->GetDataType() != VTK_ID_TYPE &&
      array->GetDataType() != VTK_BIT && array != from->GetGlobalIds() &&
      array->GetNumberOfTuples() >= volume->GetNumberOfPoints() &&
      std::string(array->GetName()) != "vtkGhostType")
    {
      to->AddArray(array);
    }
  }
  to->SetScalars(scalars);
}

void CleanContour(vtkPointData* volume, vtkPolyData* surface)
{
  RemoveInfiniteTriangles(surface);
  vtkPointData* data = surface->GetPointData();
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    arrays.emplace_back(data->GetArray(i));
  }
  for (vtkDataArray* array : arrays)
  {
    vtkDataArray* original =
      array && array->GetName() ? volume->GetArray(array->GetName()) : nullptr;
    if (original && original != volume->GetScalars() &&
      original->GetDataType() != array->GetDataType() &&
      original->GetNumberOfComponents() == array->GetNumberOfComponents())
    {
      RestoreType(original, array, data);
    }
  }
}
}
