// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceEdges.h"

#include "vtkPolyData.h"

#include <tuple>

namespace
{
// A side of a triangle. Sorted, those of an edge follow each other.
struct Side
{
  vtkIdType Points[2]; // the lower first
  vtkIdType Triangle;
  bool Descending; // the triangle passes it from the higher point to the lower

  bool operator<(const Side& other) const
  {
    return std::tie(this->Points[0], this->Points[1], this->Triangle) <
      std::tie(other.Points[0], other.Points[1], other.Triangle);
  }
  bool IsOnEdgeOf(const Side& other) const
  {
    return this->Points[0] == other.Points[0] && this->Points[1] == other.Points[1];
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
          const vtkIdType from = triangles[t][i];
          const vtkIdType to = triangles[t][(i + 1) % 3];
          sides[3 * t + i] = { { std::min(from, to), std::max(from, to) }, t, from > to };
        }
      }
    });
  vtkSMPTools::Sort(sides.begin(), sides.end());
  return sides;
}
}

namespace relevo
{
void SurfaceEdges::Update(vtkPolyData* mesh)
{
  const GeometryStamp stamp = MakeGeometryStamp(mesh);
  if (this->Of == stamp)
  {
    return;
  }
  this->Of = stamp;
  this->Triangles = SurfaceTriangles(mesh);

  this->Edges.clear();
  const std::vector<Side> sides = MakeSides(this->Triangles.GetTriangles());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    while (last < sides.size() && sides[last].IsOnEdgeOf(sides[first]))
    {
      ++last;
    }
    const Side& side = sides[first];
    SurfaceEdge edge{ { side.Points[0], side.Points[1] }, { side.Triangle, -1 },
      SurfaceEdge::OPEN };
    if (last - first == 1)
    {
      this->Edges.push_back(edge);
    }
    else if (last - first == 2)
    {
      edge.Type =
        side.Descending != sides[first + 1].Descending ? SurfaceEdge::INNER : SurfaceEdge::FLIPPED;
    }
    for (std::size_t i = first; i + 1 < last; ++i)
    {
      edge.Triangles[0] = sides[i].Triangle;
      edge.Triangles[1] = sides[i + 1].Triangle;
      this->Edges.push_back(edge);
    }
  }

  this->Starts.assign(this->Triangles.GetNumberOfPoints() + 1, 0);
  for (const SurfaceEdge& edge : this->Edges)
  {
    ++this->Starts[edge.Points[0] + 1];
    ++this->Starts[edge.Points[1] + 1];
  }
  for (std::size_t place = 1; place < this->Starts.size(); ++place)
  {
    this->Starts[place] += this->Starts[place - 1];
  }
  this->Uses.resize(2 * this->Edges.size());
  std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    for (vtkIdType place : this->Edges[i].Points)
    {
      this->Uses[next[place]++] = static_cast<vtkIdType>(i);
    }
  }
}
}
