// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ArrayExtremes.h"

#include "Scene/CellNumbers.h"
#include "Scene/PictureMarks.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
double GetSize(vtkDataArray* array, vtkIdType index)
{
  if (array->GetNumberOfComponents() == 1)
  {
    return array->GetComponent(index, 0);
  }
  double squares = 0.0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    squares += array->GetComponent(index, c) * array->GetComponent(index, c);
  }
  return std::sqrt(squares);
}

std::array<double, 3> GetPlace(vtkDataSet* mesh, vtkIdType index, bool isOfPoints)
{
  std::array<double, 3> place{};
  if (isOfPoints)
  {
    mesh->GetPoint(index, place.data());
    return place;
  }
  vtkNew<vtkIdList> points;
  mesh->GetCellPoints(index, points);
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    double point[3];
    mesh->GetPoint(points->GetId(i), point);
    vtkMath::Add(place.data(), point, place.data());
  }
  vtkMath::MultiplyScalar(place.data(), 1.0 / std::max<vtkIdType>(points->GetNumberOfIds(), 1));
  return place;
}

// Returns which points are those of cells.
std::vector<bool> FindUsedPoints(vtkDataSet* mesh)
{
  std::vector<bool> used(static_cast<std::size_t>(mesh->GetNumberOfPoints()), false);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      used[static_cast<std::size_t>(points->GetId(i))] = true;
    }
  }
  return used;
}

// Returns a cell of the mesh at an extreme, or -1.
vtkIdType FindCell(const ArrayExtreme& extreme, bool isOfPoints, vtkDataSet* mesh)
{
  if (mesh == extreme.Mesh && !isOfPoints)
  {
    return extreme.Index;
  }
  if (!isOfPoints)
  {
    vtkDataArray* ids = extreme.Mesh->GetCellData()->GetArray("vtkOriginalCellIds");
    return ids ? static_cast<vtkIdType>(ids->GetComponent(extreme.Index, 0)) : -1;
  }
  double place[3] = { extreme.Place[0], extreme.Place[1], extreme.Place[2] };
  const vtkIdType point = mesh == extreme.Mesh ? extreme.Index : mesh->FindPoint(place);
  vtkNew<vtkIdList> cells;
  if (point >= 0)
  {
    mesh->GetPointCells(point, cells);
  }
  return cells->GetNumberOfIds() > 0 ? cells->GetId(0) : -1;
}
}

//------------------------------------------------------------------------------
std::optional<std::pair<ArrayExtreme, ArrayExtreme>> FindExtremes(
  vtkDataObject* data, const std::string& array, bool isOfPoints, vtkPlane* plane)
{
  ArrayExtreme least;
  ArrayExtreme most;
  for (vtkDataSet* mesh : vtkCompositeDataSet::GetDataSets(data))
  {
    vtkDataArray* values = isOfPoints ? mesh->GetPointData()->GetArray(array.c_str())
                                      : mesh->GetCellData()->GetArray(array.c_str());
    if (!values)
    {
      continue;
    }
    const std::vector<bool> used = isOfPoints ? FindUsedPoints(mesh) : std::vector<bool>();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double value = GetSize(values, i);
      if (!std::isfinite(value) || (isOfPoints && !used[static_cast<std::size_t>(i)]))
      {
        continue;
      }
      const bool isLeast = least.Index < 0 || value < least.Value;
      const bool isMost = most.Index < 0 || value > most.Value;
      if (!isLeast && !isMost)
      {
        continue;
      }
      const ArrayExtreme found = { value, GetPlace(mesh, i, isOfPoints), mesh, i };
      double place[3] = { found.Place[0], found.Place[1], found.Place[2] };
      if (plane && plane->EvaluateFunction(place) < 0.0)
      {
        continue;
      }
      least = isLeast ? found : least;
      most = isMost ? found : most;
    }
  }
  if (least.Index < 0)
  {
    return std::nullopt;
  }
  return std::make_pair(least, most);
}

//------------------------------------------------------------------------------
void MarkExtremes(const std::pair<ArrayExtreme, ArrayExtreme>& extremes, bool isOfPoints,
  vtkDataSet* cells, PictureMarks& marks)
{
  const auto mark = [&](const char* name, const ArrayExtreme& extreme)
  {
    vtkDataSet* mesh = cells ? cells : extreme.Mesh.Get();
    const vtkIdType cell = FindCell(extreme, isOfPoints, mesh);
    std::ostringstream text;
    text.precision(4);
    text << name << " " << extreme.Value;
    if (cell >= 0)
    {
      text << "\n" << DescribeCell(mesh, cell, extreme.Place.data());
    }
    marks.AddPoint(extreme.Place, text.str());
  };
  mark("min", extremes.first);
  mark("max", extremes.second);
}
