// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/TerrainMeshBuilder.h"

#include "Raster/GridKey.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace relevo
{
TerrainMeshBuilder::TerrainMeshBuilder(
  const RasterDescription& contents, const TerrainPlacement& placement, int subdivisions)
  : Contents(contents)
  , Placement(placement)
  , Unit(std::ldexp(1.0, -subdivisions))
  , IsMirrored(
      placement.Column[0] * placement.Row[1] - placement.Column[1] * placement.Row[0] < 0.0)
{
  this->Points->SetDataTypeToDouble();
  this->Heights->SetName("Height");
  this->Positions->SetName("Positions");
  this->Positions->SetNumberOfComponents(2);
}

vtkIdType TerrainMeshBuilder::AddVertex(const Vertex& vertex)
{
  if (vertex.Point && *vertex.Point >= 0)
  {
    return *vertex.Point;
  }
  const auto [found, isNew] =
    this->Ids.emplace(MakeGridKey(vertex.Column, vertex.Row), this->Points->GetNumberOfPoints());
  if (isNew)
  {
    const double column = static_cast<double>(vertex.Column) * this->Unit;
    const double row = static_cast<double>(vertex.Row) * this->Unit;
    this->AddPoint(
      vertex.World ? *vertex.World : this->Placement.ToWorld(column, row, vertex.Height),
      vertex.Height, column, row);
  }
  if (vertex.Point)
  {
    *vertex.Point = found->second;
  }
  return found->second;
}

vtkIdType TerrainMeshBuilder::AddPoint(
  const std::array<double, 3>& position, double height, double column, double row)
{
  this->Heights->InsertNextValue(height);
  this->Positions->InsertNextTuple2(column, row);
  return this->Points->InsertNextPoint(position.data());
}

void TerrainMeshBuilder::AddTriangle(const std::array<Vertex, 3>& triangle)
{
  const auto isAtSamePoint = [&triangle](int a, int b)
  { return triangle[a].World && triangle[b].World && *triangle[a].World == *triangle[b].World; };
  if (std::any_of(triangle.begin(), triangle.end(),
        [](const Vertex& vertex) { return std::isnan(vertex.Height); }) ||
    isAtSamePoint(0, 1) || isAtSamePoint(1, 2) || isAtSamePoint(2, 0))
  {
    return;
  }
  vtkIdType ids[3];
  for (int i = 0; i < 3; ++i)
  {
    ids[i] = this->AddVertex(triangle[i]);
  }
  const std::int64_t area =
    (triangle[1].Column - triangle[0].Column) * (triangle[2].Row - triangle[0].Row) -
    (triangle[1].Row - triangle[0].Row) * (triangle[2].Column - triangle[0].Column);
  if ((area < 0) != this->IsMirrored)
  {
    std::swap(ids[1], ids[2]);
  }
  this->Triangles->InsertNextCell(3, ids);
}

// Keeps the part where the distance to a limit, which is exact, is not negative.
void TerrainMeshBuilder::Clip(int axis, double limit, double sign)
{
  const auto getDistance = [&](vtkIdType id)
  { return sign * (limit - this->Positions->GetTypedComponent(id, axis)); };
  bool isInside = true;
  for (vtkIdType id = 0; id < this->Points->GetNumberOfPoints() && isInside; ++id)
  {
    isInside = getDistance(id) >= 0.0;
  }
  if (isInside)
  {
    return;
  }
  this->Ids.clear(); // now the points on edges
  vtkNew<vtkCellArray> kept;
  vtkNew<vtkIdList> triangle;
  for (vtkIdType cell = 0; cell < this->Triangles->GetNumberOfCells(); ++cell)
  {
    this->Triangles->GetCellAtId(cell, triangle);
    vtkIdType polygon[4];
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType here = triangle->GetId(i);
      const vtkIdType next = triangle->GetId((i + 1) % 3);
      const double distances[2] = { getDistance(here), getDistance(next) };
      if (distances[0] >= 0.0)
      {
        polygon[count++] = here;
      }
      if (distances[0] * distances[1] < 0.0)
      {
        polygon[count++] = this->AddEdgePoint(here, next, axis, limit);
      }
    }
    for (int i = 2; i < count; ++i)
    {
      kept->InsertNextCell({ polygon[0], polygon[i - 1], polygon[i] });
    }
  }
  this->Triangles->ShallowCopy(kept);
}

// Both triangles of an edge get the same point.
vtkIdType TerrainMeshBuilder::AddEdgePoint(
  vtkIdType first, vtkIdType second, int axis, double limit)
{
  const vtkIdType ends[2] = { std::min(first, second), std::max(first, second) };
  const auto [found, isNew] =
    this->Ids.emplace(MakeGridKey(ends[0], ends[1]), this->Points->GetNumberOfPoints());
  if (isNew)
  {
    const double from = this->Positions->GetTypedComponent(ends[0], axis);
    const double to = this->Positions->GetTypedComponent(ends[1], axis);
    const double t = (limit - from) / (to - from);
    const auto mix = [t](double a, double b) { return a + t * (b - a); };
    std::array<double, 3> points[2];
    this->Points->GetPoint(ends[0], points[0].data());
    this->Points->GetPoint(ends[1], points[1].data());
    double sample[2];
    for (int i = 0; i < 2; ++i)
    {
      sample[i] = i == axis ? limit
                            : mix(this->Positions->GetTypedComponent(ends[0], i),
                                this->Positions->GetTypedComponent(ends[1], i));
    }
    this->AddPoint({ { mix(points[0][0], points[1][0]), mix(points[0][1], points[1][1]),
                     mix(points[0][2], points[1][2]) } },
      mix(this->Heights->GetValue(ends[0]), this->Heights->GetValue(ends[1])), sample[0],
      sample[1]);
  }
  return found->second;
}

void TerrainMeshBuilder::RemoveUnusedPoints()
{
  std::vector<vtkIdType> renamed(static_cast<std::size_t>(this->Points->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> used;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> triangle;
  for (vtkIdType cell = 0; cell < this->Triangles->GetNumberOfCells(); ++cell)
  {
    this->Triangles->GetCellAtId(cell, triangle);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      vtkIdType& id = renamed[static_cast<std::size_t>(triangle->GetId(i))];
      id = id < 0 ? used->InsertNextId(triangle->GetId(i)) : id;
      triangle->SetId(i, id);
    }
    triangles->InsertNextCell(triangle);
  }
  this->Triangles->ShallowCopy(triangles);
  const auto reduce = [&used](vtkDataArray* values)
  {
    vtkNew<vtkDoubleArray> kept;
    kept->SetName(values->GetName());
    kept->SetNumberOfComponents(values->GetNumberOfComponents());
    kept->SetNumberOfTuples(used->GetNumberOfIds());
    values->GetTuples(used, kept);
    values->ShallowCopy(kept);
  };
  reduce(this->Points->GetData());
  reduce(this->Heights);
  reduce(this->Positions);
}

void TerrainMeshBuilder::Finish(
  const std::array<double, 2>& columns, const std::array<double, 2>& rows, vtkPolyData* output)
{
  const vtkIdType count = this->Points->GetNumberOfPoints();
  const vtkIdType triangles = this->Triangles->GetNumberOfCells();
  for (int end = 0; end < 2; ++end)
  {
    const double sign = end == 0 ? -1.0 : 1.0;
    this->Clip(0, columns[end], sign);
    this->Clip(1, rows[end], sign);
  }
  if (this->Points->GetNumberOfPoints() != count ||
    this->Triangles->GetNumberOfCells() != triangles)
  {
    this->RemoveUnusedPoints();
  }
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(this->Points->GetNumberOfPoints());
  const Georeference& location = this->Contents.Location;
  for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
  {
    const double u = (this->Positions->GetTypedComponent(i, 0) + 0.5) / this->Contents.Width;
    const double v = (this->Positions->GetTypedComponent(i, 1) + 0.5) / this->Contents.Height;
    coordinates->SetTuple2(i, location.FlipColumns ? 1.0 - u : u, location.FlipRows ? 1.0 - v : v);
  }
  output->SetPoints(this->Points);
  output->SetPolys(this->Triangles);
  output->GetPointData()->AddArray(this->Heights);
  output->GetPointData()->SetTCoords(coordinates);
}
}
