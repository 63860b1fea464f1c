// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/VolumeCells.h"

#include "Core/FiniteBox.h"
#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Of the volume of a cube as long as the longest edge: less is no volume.
constexpr double LeastVolume = 1e-12;
// Of the mesh's diagonal; boxes are floats.
constexpr double BoxMargin = 1e-6;
constexpr double PlaneMargin = 1e-12;

bool IsFinite(const Scalars& scalars)
{
  return std::all_of(
    scalars.begin(), scalars.end(), [](double value) { return std::isfinite(value); });
}

bool IsFinite(const dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

void AddScalars(vtkDataArray* array, double scale, std::vector<Scalars>& all)
{
  const int components = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    Scalars scalars = {};
    for (int c = 0; c < components; ++c)
    {
      scalars[c] = scale * array->GetComponent(i, c);
    }
    all.push_back(scalars);
  }
}

// Which cells another piece draws, or nobody.
class LeftOutCells
{
public:
  explicit LeftOutCells(vtkDataSet* mesh)
    : Cells(mesh->GetCellGhostArray())
    , Points(mesh->GetPointGhostArray())
  {
  }
  bool Has(vtkIdType cell, vtkIdList* points) const
  {
    constexpr int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
      vtkDataSetAttributes::REFINEDCELL;
    if (this->Cells && (this->Cells->GetValue(cell) & left))
    {
      return true;
    }
    for (vtkIdType i = 0; this->Points && i < points->GetNumberOfIds(); ++i)
    {
      if (this->Points->GetValue(points->GetId(i)) & vtkDataSetAttributes::HIDDENPOINT)
      {
        return true;
      }
    }
    return false;
  }

private:
  vtkUnsignedCharArray* Cells;
  vtkUnsignedCharArray* Points;
};
}

void VolumeCells::Add(vtkDataSet* mesh, vtkDataArray* array, bool isOfCells, double scale)
{
  const vtkIdType firstPoint = static_cast<vtkIdType>(this->Points.size());
  const vtkIdType firstCell = static_cast<vtkIdType>(this->CellScalars.size());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    dvec3 point;
    mesh->GetPoint(i, &point.x);
    this->Points.push_back(point);
  }
  AddScalars(array, scale, isOfCells ? this->CellScalars : this->PointScalars);
  // The other kind keeps pace, for further data sets.
  (isOfCells ? this->PointScalars : this->CellScalars)
    .resize(isOfCells ? this->Points.size() : firstCell);

  const LeftOutCells leftOut(mesh);
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCell(i, cell);
    if (cell->GetCellDimension() != 3 || leftOut.Has(i, cell->GetPointIds()))
    {
      continue;
    }
    vtkIdList* corners = cell->GetPointIds();
    if (cell->GetCellType() != VTK_TETRA)
    {
      cell->Triangulate(0, ids, points);
      corners = ids;
    }
    bool isGood = false;
    for (vtkIdType j = 0; j + 3 < corners->GetNumberOfIds(); j += 4)
    {
      const vtkIdType* id = corners->GetPointer(j);
      isGood |= this->AddTetrahedron(
        { { { firstPoint + id[0], firstPoint + id[1], firstPoint + id[2], firstPoint + id[3] } },
          isOfCells ? firstCell + i : -1 });
    }
    this->NumberOfSolidCells++;
    this->NumberOfBadCells += isGood ? 0 : 1;
  }
}

TetrahedronCorners VolumeCells::GetCorners(const Tetrahedron& cell) const
{
  TetrahedronCorners corners;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = this->Points[cell.Corners[i]];
  }
  return corners;
}

// Whether it has a volume. What has no scalars there is transparent, and need not be kept.
bool VolumeCells::AddTetrahedron(const Tetrahedron& cell)
{
  const TetrahedronCorners corners = this->GetCorners(cell);
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    if (!IsFinite(corners[i]))
    {
      return false;
    }
    for (int j = 0; j < i; ++j)
    {
      longest = std::max(longest, distance(corners[i], corners[j]));
    }
  }
  if (!(ComputeSixfoldVolume(corners) > LeastVolume * longest * longest * longest))
  {
    return false;
  }
  const bool hasScalars = cell.Cell >= 0
    ? IsFinite(this->CellScalars[cell.Cell])
    : std::all_of(cell.Corners.begin(), cell.Corners.end(),
        [this](vtkIdType point) { return IsFinite(this->PointScalars[point]); });
  if (hasScalars)
  {
    this->Tetrahedra.push_back(cell);
  }
  return true;
}

void VolumeCells::Build()
{
  FiniteBox box;
  for (const Tetrahedron& cell : this->Tetrahedra)
  {
    for (vtkIdType point : cell.Corners)
    {
      box.Add(&this->Points[point].x);
    }
  }
  this->Center = dvec3(box.GetMiddle(0), box.GetMiddle(1), box.GetMiddle(2));
  this->Margin = length(dvec3(box.GetSide(0), box.GetSide(1), box.GetSide(2)));
  for (dvec3& point : this->Points)
  {
    point -= this->Center;
  }
  std::vector<FaceBox> boxes;
  boxes.reserve(this->Tetrahedra.size());
  for (const Tetrahedron& cell : this->Tetrahedra)
  {
    const TetrahedronCorners corners = this->GetCorners(cell);
    const dvec3 low = min(min(corners[0], corners[1]), min(corners[2], corners[3]));
    const dvec3 high = max(max(corners[0], corners[1]), max(corners[2], corners[3]));
    FaceBox rounded;
    for (int c = 0; c < 3; ++c)
    {
      rounded.Low[c] = static_cast<float>(low[c]);
      rounded.High[c] = static_cast<float>(high[c]);
    }
    boxes.push_back(rounded);
  }
  this->Tree.Build(std::move(boxes));
}

void VolumeCells::CrossTetrahedron(
  const Tetrahedron& cell, const Ray& ray, std::vector<RayPart>& parts) const
{
  TetrahedronCrossing crossing;
  if (!crossing.Find(this->GetCorners(cell), ray, PlaneMargin * this->Margin))
  {
    return;
  }
  RayPart part = { crossing.Begin, crossing.End, {}, {} };
  if (cell.Cell >= 0)
  {
    part.Front = part.Back = this->CellScalars[cell.Cell];
  }
  for (int i = 0; i < 4 && cell.Cell < 0; ++i)
  {
    const Scalars& scalars = this->PointScalars[cell.Corners[i]];
    for (size_t c = 0; c < scalars.size(); ++c)
    {
      part.Front[c] += crossing.FrontWeights[i] * scalars[c];
      part.Back[c] += crossing.BackWeights[i] * scalars[c];
    }
  }
  parts.push_back(part);
}

std::vector<RayPart> VolumeCells::Cross(const Ray& ray) const
{
  const Ray moved = { ray.Origin - this->Center, ray.Direction, ray.Length };
  const dvec3 end = moved.Origin + moved.Length * moved.Direction;
  const BoxSegment segment(&moved.Origin.x, &end.x, BoxMargin * this->Margin);
  std::vector<RayPart> parts;
  double last = 1.0;
  this->Tree.Visit(
    last, [&](const FaceBox& box, double nearest) { return segment.GetEntry(box, nearest); },
    [&](int cell) { this->CrossTetrahedron(this->Tetrahedra[cell], moved, parts); });
  std::sort(parts.begin(), parts.end(),
    [](const RayPart& a, const RayPart& b)
    { return a.Begin < b.Begin || (a.Begin == b.Begin && a.End < b.End); });

  // A ray in a face is in both its cells: no place counts twice.
  double reached = 0.0;
  std::vector<RayPart> once;
  for (RayPart part : parts)
  {
    if (part.End <= reached)
    {
      continue;
    }
    if (part.Begin < reached)
    {
      part.Front =
        Interpolate(part.Front, part.Back, (reached - part.Begin) / (part.End - part.Begin));
      part.Begin = reached;
    }
    reached = part.End;
    once.push_back(part);
  }
  return once;
}
}
