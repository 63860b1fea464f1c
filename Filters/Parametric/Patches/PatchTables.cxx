// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/PatchTables.h"

#include "Mesh/PatchArrays.h"
#include "Points/MergedPoints.h"
#include "Splines/WeightScale.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace relevo
{
namespace
{
constexpr int RecordsPerFace = 4;

// The side of a face on a border of its patch.
struct BorderSide
{
  int Low; // merged points at the ends
  int High;
  int Entry; // of the face
  int Edge;
  bool Descends;

  bool IsBeside(const BorderSide& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const BorderSide& other) const
  {
    return std::tie(this->Low, this->High, this->Entry, this->Edge) <
      std::tie(other.Low, other.High, other.Entry, other.Edge);
  }
  int GetReference() const { return this->Entry << 3 | this->Edge << 1 | (this->Descends ? 1 : 0); }
};

class TableBuilder
{
public:
  TableBuilder(vtkPolyData* mesh, const PatchArrays& patches, vtkRefinementSurface::Tables& tables)
    : Mesh(mesh)
    , Patches(patches)
    , Tables(tables)
    , MergedPoints(ComputeMergedPoints(mesh->GetPoints()))
  {
  }

  void BuildPoints(const double origin[3])
  {
    this->Tables.Points.resize(4 * static_cast<std::size_t>(this->Patches.GetNumberOfPoints()));
    const WeightScale scale(0, this->Patches.GetNumberOfPoints(),
      [this](vtkIdType i) { return this->Patches.GetPoint(i); });
    for (vtkIdType i = 0; i < this->Patches.GetNumberOfPoints(); ++i)
    {
      const dvec4 point = this->Patches.GetPoint(i);
      float* out = &this->Tables.Points[4 * static_cast<std::size_t>(i)];
      for (int c = 0; c < 3; ++c)
      {
        out[c] = static_cast<float>(point[c] - origin[c]);
      }
      out[3] = scale.GetWeight(point);
    }
  }

  void BuildRecords()
  {
    vtkPolyData* mesh = this->Mesh;
    vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    this->Tables.Entries.assign(static_cast<std::size_t>(mesh->GetNumberOfCells()), -1);
    this->Tables.Records.reserve(
      4 * RecordsPerFace * static_cast<std::size_t>(mesh->GetNumberOfPolys()));
    auto polygons = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* corners;
      polygons->GetCurrentCell(size, corners);
      this->AddFace(cell, corners);
      ++cell;
    }
    this->LinkSides();
  }

private:
  int GetMergedPoint(vtkIdType point) const
  {
    return static_cast<int>(
      this->MergedPoints.empty() ? point : this->MergedPoints[static_cast<std::size_t>(point)]);
  }

  void AddFace(vtkIdType cell, const vtkIdType corners[3])
  {
    const Patch patch = this->Patches.GetPatch(this->Patches.GetPatchId(cell));
    const PatchFace::PatchShape shape{ static_cast<int>(patch.FirstPoint), patch.Degrees,
      patch.IsTriangle };
    const int entry = static_cast<int>(this->Tables.Records.size() / 4);
    this->Tables.Entries[static_cast<std::size_t>(cell)] = entry;
    ivec2 uv[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      uv[corner] = ivec2(round(this->Patches.GetCoordinates(cell, corner) *
        static_cast<float>(this->Functions.patchUnit)));
    }
    int pointBorders = 0;
    for (int border = 0; border < (shape.IsTriangle ? 3 : 4); ++border)
    {
      pointBorders |= this->IsPoint(shape, border) ? 1 << border : 0;
    }
    int pointEdges = 0;
    for (int edge = 0; edge < 3; ++edge)
    {
      const int next = (edge + 1) % 3;
      const int from = this->GetMergedPoint(corners[edge]);
      const int to = this->GetMergedPoint(corners[next]);
      const int border = this->Functions.findPatchBorder(shape, uv[edge], uv[next]);
      if (border >= 0 && from != to)
      {
        this->Sides.push_back({ std::min(from, to), std::max(from, to), entry, edge, from > to });
      }
      pointEdges |= border >= 0 && (pointBorders >> border & 1) != 0 ? 1 << edge : 0;
    }
    const int hiddenBorders =
      pointBorders | (this->Patches.GetInnerBorders(this->Patches.GetPatchId(cell)) & 15);
    const int kind = shape.Degrees.x | shape.Degrees.y << 4 | (shape.IsTriangle ? 256 : 0) |
      hiddenBorders << 9 | (this->IsRational(patch) ? 1 << 13 : 0);
    std::vector<int>& records = this->Tables.Records;
    records.insert(records.end(), { shape.First, kind, pointEdges, 0 });
    for (const ivec2& corner : uv)
    {
      records.push_back(corner.x << 16 | corner.y);
    }
    records.resize(records.size() + 1, 0);
    records.resize(records.size() + 8, -1); // see LinkSides()
  }

  // Whether a border degenerates to a point.
  bool IsPoint(const PatchFace::PatchShape& shape, int border)
  {
    const PatchFace::PatchBorder points = this->Functions.patchBorder(shape, border);
    const auto getPoint = [&](int k)
    { return dvec3(this->Patches.GetPoint(this->Functions.patchBorderPoint(points, k))); };
    const dvec3 first = getPoint(0);
    for (int k = 1; k <= points.Degree; ++k)
    {
      if (getPoint(k) != first)
      {
        return false;
      }
    }
    return true;
  }

  // Whether weights differ. Equal weights cancel out.
  bool IsRational(const Patch& patch) const
  {
    const double first = this->Patches.GetPoint(patch.FirstPoint).w;
    for (int i = 1; i < patch.GetNumberOfPoints(); ++i)
    {
      if (this->Patches.GetPoint(patch.FirstPoint + i).w != first)
      {
        return true;
      }
    }
    return false;
  }

  // All faces at a border get references to the first two of them.
  void LinkSides()
  {
    std::sort(this->Sides.begin(), this->Sides.end());
    auto last = this->Sides.begin();
    for (auto first = last; first != this->Sides.end(); first = last)
    {
      last = std::find_if(first, this->Sides.end(),
        [&first](const BorderSide& side) { return !side.IsBeside(*first); });
      if (last - first < 2)
      {
        continue;
      }
      const int references[2] = { first->GetReference(), (first + 1)->GetReference() };
      for (auto side = first; side != last; ++side)
      {
        const std::size_t record = 4 * (static_cast<std::size_t>(side->Entry) + 2);
        this->Tables.Records[record + side->Edge] = references[0];
        this->Tables.Records[record + 4 + side->Edge] = references[1];
      }
    }
  }

  vtkPolyData* Mesh;
  const PatchArrays& Patches;
  vtkRefinementSurface::Tables& Tables;
  std::vector<vtkIdType> MergedPoints;
  std::vector<BorderSide> Sides;
  vtkRefinementSurface::Face NoFace{};
  PatchFace Functions{ this->NoFace };
};
}

bool BuildPatchTables(vtkPolyData* mesh, const double origin[3],
  vtkRefinementSurface::Tables& tables, std::string& error)
{
  PatchArrays patches;
  if (!patches.Take(mesh, error))
  {
    return false;
  }
  // References to records have 29 bits.
  constexpr vtkIdType maximumFaces = (vtkIdType(1) << 28) / RecordsPerFace;
  if (mesh->GetNumberOfPolys() > maximumFaces ||
    patches.GetNumberOfPoints() > std::numeric_limits<int>::max() / 4)
  {
    error = "the mesh has too many patches";
    return false;
  }
  TableBuilder builder(mesh, patches, tables);
  builder.BuildPoints(origin);
  builder.BuildRecords();
  return true;
}
}
