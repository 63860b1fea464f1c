// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping/LatticePatch.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Smaller parts of a cell are not needed in practice.
constexpr int MaximumParts = 64;
}

LatticePatch::LatticePatch(
  const HeightTile& tile, const TerrainPlacement& placement, const MapBox& box, double tolerance)
  : Tile(tile)
  , Placement(placement)
  , Tolerance(tolerance)
  , Size(std::ldexp(1.0, tile.Level))
{
  this->Box = box;
  for (int axis = 0; axis < 2; ++axis)
  {
    this->FirstVertex[axis] = static_cast<std::int64_t>(std::floor(box.Low[axis] / this->Size));
    this->LastVertex[axis] = static_cast<std::int64_t>(std::ceil(box.High[axis] / this->Size));
  }
}

MapPosition LatticePatch::ToLattice(const MapPosition& position) const
{
  return { { position[0] / this->Size, position[1] / this->Size } };
}

bool LatticePatch::GetCell(const std::array<std::int64_t, 2>& first, Cell& cell) const
{
  cell.First = first;
  const auto i = static_cast<int>(
    first[0] - static_cast<std::int64_t>(this->Tile.Column) * HeightTile::CellsPerTile);
  const auto j = static_cast<int>(
    first[1] - static_cast<std::int64_t>(this->Tile.Row) * HeightTile::CellsPerTile);
  for (int corner = 0; corner < 4; ++corner)
  {
    cell.Heights[corner] = this->Tile.GetHeight(i + corner % 2, j + corner / 2);
  }
  return std::none_of(
    cell.Heights.begin(), cell.Heights.end(), [](double height) { return std::isnan(height); });
}

bool LatticePatch::FindCell(const MapPosition& inLattice, Cell& cell) const
{
  std::array<std::int64_t, 2> first;
  for (int axis = 0; axis < 2; ++axis)
  {
    first[axis] = std::clamp(static_cast<std::int64_t>(std::floor(inLattice[axis])),
      this->FirstVertex[axis], this->LastVertex[axis] - 1);
  }
  return this->GetCell(first, cell);
}

SurfaceVertex LatticePatch::GetVertex(const Cell& cell, const MapPosition& inLattice) const
{
  const double u = inLattice[0] - static_cast<double>(cell.First[0]);
  const double v = inLattice[1] - static_cast<double>(cell.First[1]);
  const auto& h = cell.Heights;
  SurfaceVertex vertex;
  vertex.Position = { { inLattice[0] * this->Size, inLattice[1] * this->Size } };
  vertex.Height = (1.0 - v) * ((1.0 - u) * h[0] + u * h[1]) + v * ((1.0 - u) * h[2] + u * h[3]);
  const auto [column, row] = vertex.Position;
  vertex.World = this->Placement.ToWorld(column, row, vertex.Height);
  vertex.Up = this->Placement.GetUp(column, row);
  return vertex;
}

SurfacePoint LatticePatch::GetPoint(const Cell& cell, const MapPosition& position) const
{
  SurfacePoint point;
  point.Vertices[0] = this->GetVertex(cell, this->ToLattice(position));
  return point;
}

// The distance of a parabola from its chord is inverse to the square of the number of parts.
int LatticePatch::CountParts(double largestDistance) const
{
  return static_cast<int>(std::clamp(
    std::ceil(std::sqrt(std::abs(largestDistance) / this->Tolerance)), 1.0, double(MaximumParts)));
}

void LatticePatch::AddPieces(const MapSegment& segment, std::vector<Piece>& pieces) const
{
  const auto clip = [&](double tolerance)
  {
    SegmentRange range;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double low = this->Box.Low[axis] - tolerance;
      const double high = this->Box.High[axis] + tolerance;
      range.Clip(segment.Start[axis] - low, segment.End[axis] - low);
      range.Clip(high - segment.Start[axis], high - segment.End[axis]);
    }
    return range;
  };
  SegmentRange range = clip(0.0);
  if (range.IsEmpty())
  {
    range = clip(MapSegment::Tolerance);
  }
  if (range.IsEmpty())
  {
    return;
  }
  const MapPosition start = this->ToLattice(segment.Start);
  const MapPosition end = this->ToLattice(segment.End);
  std::vector<double> parameters = { range.First, range.Last };
  range.AddCrossings(start[0], end[0], parameters);
  range.AddCrossings(start[1], end[1], parameters);
  std::sort(parameters.begin(), parameters.end());
  const double shortest = MapSegment::Tolerance / segment.GetLength();
  double first = parameters.front();
  for (double last : parameters)
  {
    Cell cell;
    if (last - first <= shortest)
    {
      continue;
    }
    if (this->FindCell(this->ToLattice(segment.Get(0.5 * (first + last))), cell))
    {
      const double length = last - first;
      const int parts = this->CountParts(
        cell.GetTwist() * (end[0] - start[0]) * (end[1] - start[1]) * length * length / 4.0);
      for (int i = 0; i < parts; ++i)
      {
        const double t0 = first + length * i / parts;
        const double t1 = i + 1 == parts ? last : first + length * (i + 1) / parts;
        pieces.push_back(
          { t0, t1, this->GetPoint(cell, segment.Get(t0)), this->GetPoint(cell, segment.Get(t1)) });
      }
    }
    first = last;
  }
}

bool LatticePatch::FindPoint(const MapPosition& position, SurfacePoint& point) const
{
  for (int axis = 0; axis < 2; ++axis)
  {
    if (!(position[axis] >= this->Box.Low[axis] - MapSegment::Tolerance &&
          position[axis] <= this->Box.High[axis] + MapSegment::Tolerance))
    {
      return false;
    }
  }
  Cell cell;
  if (!this->FindCell(this->ToLattice(position), cell))
  {
    return false;
  }
  point = this->GetPoint(cell, position);
  return true;
}

void LatticePatch::VisitTriangles(const MapBox& box, const TriangleVisitor& visitor) const
{
  std::array<std::int64_t, 2> first;
  std::array<std::int64_t, 2> last;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = std::max(box.Low[axis], this->Box.Low[axis]);
    const double high = std::min(box.High[axis], this->Box.High[axis]);
    first[axis] =
      std::max(static_cast<std::int64_t>(std::floor(low / this->Size)), this->FirstVertex[axis]);
    last[axis] =
      std::min(static_cast<std::int64_t>(std::ceil(high / this->Size)), this->LastVertex[axis]);
  }
  for (std::int64_t row = first[1]; row < last[1]; ++row)
  {
    for (std::int64_t column = first[0]; column < last[0]; ++column)
    {
      Cell cell;
      if (this->GetCell({ { column, row } }, cell) && !this->VisitCell(cell, visitor))
      {
        return;
      }
    }
  }
}

// Two triangles have a quarter of the twist as their largest distance from the cell.
bool LatticePatch::VisitCell(const Cell& cell, const TriangleVisitor& visitor) const
{
  const int parts = this->CountParts(cell.GetTwist() / 4.0);
  const auto getVertex = [&](int i, int j)
  {
    return this->GetVertex(cell,
      { { static_cast<double>(cell.First[0]) + double(i) / parts,
        static_cast<double>(cell.First[1]) + double(j) / parts } });
  };
  for (int j = 0; j < parts; ++j)
  {
    for (int i = 0; i < parts; ++i)
    {
      const SurfaceVertex corners[4] = { getVertex(i, j), getVertex(i + 1, j),
        getVertex(i + 1, j + 1), getVertex(i, j + 1) };
      if (!visitor({ { corners[0], corners[1], corners[2] } }) ||
        !visitor({ { corners[0], corners[2], corners[3] } }))
      {
        return false;
      }
    }
  }
  return true;
}
}
