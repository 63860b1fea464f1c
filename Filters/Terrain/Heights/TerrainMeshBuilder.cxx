// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/TerrainMeshBuilder.h"

#include "Raster/GridKey.h"
#include "vtkClipPolyData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// Keeps the part where the distance to a limit, which is exact, is not negative.
void ClipPositions(vtkPolyData* mesh, int axis, double limit, double sign)
{
  vtkDataArray* positions = mesh->GetPointData()->GetArray("Positions");
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("Distances");
  distances->SetNumberOfTuples(mesh->GetNumberOfPoints());
  double lowest = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double distance = sign * (limit - positions->GetComponent(i, axis));
    distances->SetValue(i, distance);
    lowest = std::min(lowest, distance);
  }
  if (lowest >= 0.0)
  {
    return;
  }
  mesh->GetPointData()->SetScalars(distances);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(mesh);
  clip->SetValue(0.0);
  clip->Update();
  mesh->ShallowCopy(clip->GetOutput());
  mesh->GetPointData()->RemoveArray("Distances");
}
}

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
  const auto [found, isNew] =
    this->Ids.emplace(MakeGridKey(vertex.Column, vertex.Row), this->Points->GetNumberOfPoints());
  if (isNew)
  {
    const double column = static_cast<double>(vertex.Column) * this->Unit;
    const double row = static_cast<double>(vertex.Row) * this->Unit;
    this->Points->InsertNextPoint(this->Placement.ToWorld(column, row, vertex.Height).data());
    this->Heights->InsertNextValue(vertex.Height);
    this->Positions->InsertNextTuple2(column, row);
  }
  return found->second;
}

void TerrainMeshBuilder::AddTriangle(const std::array<Vertex, 3>& triangle)
{
  if (std::any_of(triangle.begin(), triangle.end(),
        [](const Vertex& vertex) { return std::isnan(vertex.Height); }))
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

void TerrainMeshBuilder::Finish(
  const std::array<double, 2>& columns, const std::array<double, 2>& rows, vtkPolyData* output)
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(this->Points);
  mesh->SetPolys(this->Triangles);
  mesh->GetPointData()->AddArray(this->Heights);
  mesh->GetPointData()->AddArray(this->Positions);
  for (int end = 0; end < 2; ++end)
  {
    const double sign = end == 0 ? -1.0 : 1.0;
    ClipPositions(mesh, 0, columns[end], sign);
    ClipPositions(mesh, 1, rows[end], sign);
  }
  vtkDataArray* positions = mesh->GetPointData()->GetArray("Positions");
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(mesh->GetNumberOfPoints());
  const Georeference& location = this->Contents.Location;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double u = (positions->GetComponent(i, 0) + 0.5) / this->Contents.Width;
    const double v = (positions->GetComponent(i, 1) + 0.5) / this->Contents.Height;
    coordinates->SetTuple2(i, location.FlipColumns ? 1.0 - u : u, location.FlipRows ? 1.0 - v : v);
  }
  mesh->GetPointData()->RemoveArray("Positions");
  mesh->GetPointData()->SetTCoords(coordinates);
  output->ShallowCopy(mesh);
}
}
