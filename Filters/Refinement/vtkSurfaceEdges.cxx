// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceEdges.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <tuple>

namespace
{
// A side of a triangle. Sorted, those of an edge follow each other.
struct Side
{
  int Places[2]; // the lower first
  int Triangle;
  bool Descending; // the triangle passes it from the higher place to the lower

  bool operator<(const Side& other) const
  {
    return std::tie(this->Places[0], this->Places[1], this->Triangle) <
      std::tie(other.Places[0], other.Places[1], other.Triangle);
  }
  bool IsOnEdgeOf(const Side& other) const
  {
    return this->Places[0] == other.Places[0] && this->Places[1] == other.Places[1];
  }
};

std::vector<Side> MakeSides(const std::vector<relevo::SurfaceTriangles::Triangle>& triangles)
{
  std::vector<Side> sides(3 * triangles.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        for (int i = 0; i < 3; ++i)
        {
          const int from = static_cast<int>(triangles[t][i]);
          const int to = static_cast<int>(triangles[t][(i + 1) % 3]);
          sides[3 * t + i] = { { std::min(from, to), std::max(from, to) }, static_cast<int>(t),
            from > to };
        }
      }
    });
  vtkSMPTools::Sort(sides.begin(), sides.end());
  return sides;
}

// Counts become starts: element i of the result is the sum of all counts before i.
void Accumulate(std::vector<int>& counts)
{
  int sum = 0;
  for (int& count : counts)
  {
    sum += count;
    count = sum - count;
  }
}
}

namespace relevo
{
bool SurfaceEdges::Update(vtkPolyData* mesh)
{
  const GeometryStamp stamp = MakeGeometryStamp(mesh);
  if (this->Of == stamp)
  {
    return false;
  }
  this->Of = stamp;
  this->Triangles = SurfaceTriangles(mesh);
  this->BuildEdges();
  this->BuildUses();
  return true;
}

void SurfaceEdges::BuildEdges()
{
  this->Edges.clear();
  this->Sides.clear();
  this->FirstSides.clear();
  this->FirstEdges.assign(this->Triangles.GetNumberOfPoints() + 1, 0);
  const std::vector<Side> sides = MakeSides(this->Triangles.GetTriangles());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    while (last < sides.size() && sides[last].IsOnEdgeOf(sides[first]))
    {
      ++last;
    }
    const Side& side = sides[first];
    SurfaceEdgeSides two{ this->GetNumberOfEdges(), { side.Triangle, -1 }, SurfaceEdgeSides::OPEN };
    this->Edges.push_back({ { side.Places[0], side.Places[1] } });
    this->FirstSides.push_back(static_cast<int>(this->Sides.size()));
    ++this->FirstEdges[side.Places[0]];
    if (last - first == 1)
    {
      this->Sides.push_back(two);
    }
    else if (last - first == 2)
    {
      two.Type = side.Descending != sides[first + 1].Descending ? SurfaceEdgeSides::INNER
                                                                : SurfaceEdgeSides::FLIPPED;
    }
    for (std::size_t i = first; i + 1 < last; ++i)
    {
      two.Triangles[0] = sides[i].Triangle;
      two.Triangles[1] = sides[i + 1].Triangle;
      this->Sides.push_back(two);
    }
  }
  this->FirstSides.push_back(static_cast<int>(this->Sides.size()));
  Accumulate(this->FirstEdges);
}

void SurfaceEdges::BuildUses()
{
  this->Starts.assign(this->Triangles.GetNumberOfPoints() + 1, 0);
  for (const Edge& edge : this->Edges)
  {
    ++this->Starts[edge.Places[0]];
    ++this->Starts[edge.Places[1]];
  }
  Accumulate(this->Starts);
  this->Uses.resize(2 * this->Edges.size());
  std::vector<int> next(this->Starts.begin(), this->Starts.end() - 1);
  for (int edge = 0; edge < this->GetNumberOfEdges(); ++edge)
  {
    for (int place : this->Edges[edge].Places)
    {
      this->Uses[next[place]++] = edge;
    }
  }
}

int SurfaceEdges::FindEdge(vtkIdType a, vtkIdType b) const
{
  const vtkIdType low = std::min(a, b);
  const vtkIdType high = std::max(a, b);
  if (low < 0 || low >= this->Triangles.GetNumberOfPoints())
  {
    return -1;
  }
  const auto first = this->Edges.begin() + this->FirstEdges[low];
  const auto last = this->Edges.begin() + this->FirstEdges[low + 1];
  const auto found = std::lower_bound(
    first, last, high, [](const Edge& edge, vtkIdType place) { return edge.Places[1] < place; });
  return found != last && found->Places[1] == high ? static_cast<int>(found - this->Edges.begin())
                                                   : -1;
}

void SurfaceEdges::TagPoints(const float* edgeTags, vtkFloatArray* tags) const
{
  const vtkIdType numberOfPoints = this->Triangles.GetNumberOfPoints();
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(numberOfPoints);
  float* values = tags->GetPointer(0);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const vtkIdType place = this->Triangles.GetPlace(point);
        float tag = 0.0f;
        for (int i = this->Starts[place]; i < this->Starts[place + 1]; ++i)
        {
          tag = std::max(tag, edgeTags[this->Uses[i]]);
        }
        values[point] = tag;
      }
    });
  tags->Modified();
}
}
