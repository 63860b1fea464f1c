// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection/CoarseCell.h"

#include "Intersection/RefinedSurface.h"
#include "Mesh/RefinementMesh.h"
#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
// Finds a cell by its id. Ids run through vertices, lines, polygons and strips.
struct CellPosition
{
  CellPosition(vtkPolyData* input, vtkIdType cellId)
    : Id(cellId)
  {
    vtkCellArray* const all[] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
      input->GetStrips() };
    while (this->Kind < STRIPS && this->Id >= all[this->Kind]->GetNumberOfCells())
    {
      this->Id -= all[this->Kind++]->GetNumberOfCells();
    }
    this->Cells = all[this->Kind];
  }

  enum Kinds
  {
    VERTICES,
    LINES,
    POLYGONS,
    STRIPS
  };
  int Kind = VERTICES;
  vtkCellArray* Cells;
  vtkIdType Id; // within this array
};

// Extracts the triangle of a strip that a face was created from, with its points in VTK's order.
void ExtractTriangle(const RefinementFace& face, vtkGenericCell* cell, int& subId)
{
  vtkIdType ids[3];
  double points[3][3];
  const int last = static_cast<int>(cell->GetNumberOfPoints()) - 3;
  subId = -1;
  bool same = false;
  while (!same && subId < last)
  {
    ++subId;
    const int first = subId % 2;
    const int order[3] = { subId + first, subId + 1 - first, subId + 2 };
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = cell->PointIds->GetId(order[i]);
      cell->Points->GetPoint(order[i], points[i]);
    }
    same = std::is_permutation(ids, ids + 3, face.Corners);
  }
  cell->SetCellTypeToTriangle();
  for (int i = 0; i < 3; ++i)
  {
    cell->PointIds->SetId(i, ids[i]);
    cell->Points->SetPoint(i, points[i]);
  }
}

void Reflect(double v[3], const double axis[3])
{
  const double along = 2.0 * vtkMath::Dot(v, axis);
  for (int c = 0; c < 3; ++c)
  {
    v[c] -= along * axis[c];
  }
}
}

int GetCellType(vtkPolyData* input, vtkIdType cellId)
{
  const CellPosition place(input, cellId);
  const vtkIdType size = place.Cells->GetCellSize(place.Id);
  const vtkIdType least[] = { 1, 2, 3, 3 };
  if (size < least[place.Kind])
  {
    return VTK_EMPTY_CELL;
  }
  switch (place.Kind)
  {
    case CellPosition::VERTICES:
      return size == 1 ? VTK_VERTEX : VTK_POLY_VERTEX;
    case CellPosition::LINES:
      return size == 2 ? VTK_LINE : VTK_POLY_LINE;
    case CellPosition::STRIPS:
      return VTK_TRIANGLE_STRIP;
    default:
      return size == 3 ? VTK_TRIANGLE : size == 4 ? VTK_QUAD : VTK_POLYGON;
  }
}

void GetCellPoints(vtkPolyData* input, vtkIdType cellId, vtkIdList* points)
{
  const CellPosition place(input, cellId);
  place.Cells->GetCellAtId(place.Id, points);
}

void GetCell(vtkPolyData* input, vtkIdType cellId, vtkGenericCell* cell)
{
  cell->SetCellType(GetCellType(input, cellId));
  if (cell->GetCellType() == VTK_EMPTY_CELL)
  {
    return;
  }
  GetCellPoints(input, cellId, cell->PointIds);
  cell->Points->SetNumberOfPoints(cell->PointIds->GetNumberOfIds());
  for (vtkIdType i = 0; i < cell->PointIds->GetNumberOfIds(); ++i)
  {
    double point[3];
    input->GetPoint(cell->PointIds->GetId(i), point);
    cell->Points->SetPoint(i, point);
  }
}

CoarseCell::CoarseCell(
  vtkPolyData* input, const RefinementMesh& mesh, const SurfaceHit& hit, vtkGenericCell* cell)
{
  const RefinementFace& face = mesh.Faces[hit.Face];
  this->CellId = face.Cell;
  GetCell(input, this->CellId, cell);
  if (cell->GetCellType() == VTK_TRIANGLE_STRIP)
  {
    ExtractTriangle(face, cell, this->SubId);
  }
  if (cell->GetCellType() == VTK_TRIANGLE)
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto corner = std::find(face.Corners, face.Corners + 3, cell->PointIds->GetId(i));
      const double weight = hit.Weights[corner - face.Corners];
      if (i > 0)
      {
        this->PCoords[i - 1] = weight;
      }
    }
    return;
  }
  double place[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    double point[3];
    input->GetPoint(face.Corners[i], point);
    for (int c = 0; c < 3; ++c)
    {
      place[c] += hit.Weights[i] * point[c];
    }
  }
  double closest[3];
  double distance2;
  std::vector<double> weights(static_cast<size_t>(cell->GetNumberOfPoints()));
  cell->EvaluatePosition(place, closest, this->SubId, this->PCoords, distance2, weights.data());
}

void TurnCell(vtkGenericCell* cell, const double normal[3])
{
  double facing[3];
  vtkPolygon::ComputeNormal(cell->Points, facing);
  if (vtkMath::Normalize(facing) == 0.0)
  {
    return;
  }
  // Two reflections rotate the cell: the first reverses it, the second aligns it with the normal.
  double between[3];
  vtkMath::Add(facing, normal, between);
  if (vtkMath::Normalize(between) < 1e-6)
  {
    vtkMath::Perpendiculars(facing, between, nullptr, 0.0);
  }
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    double point[3];
    cell->Points->GetPoint(i, point);
    Reflect(point, facing);
    Reflect(point, between);
    cell->Points->SetPoint(i, point);
  }
}
}
