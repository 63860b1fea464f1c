// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternTriangulation.h"

#include <algorithm>

namespace relevo
{
PatternTriangulation::PatternTriangulation()
{
  this->Points = { { 0, 0 }, { GridScale, 0 }, { 0, GridScale } };
  this->Triangles = { { { 0, 1, 2 }, { -1, -1, -1 } } };
  this->TriangleOfVertex = { 0, 0, 0 };
}

/// Finds the triangle of p by walking towards it. In a Delaunay triangulation, walks have no
/// cycles.
int PatternTriangulation::Locate(PatternPoint p) const
{
  int t = static_cast<int>(this->Triangles.size()) - 1; // near the last point
  for (bool found = false; !found;)
  {
    found = true;
    const Triangle& triangle = this->Triangles[t];
    for (int i = 0; i < 3 && found; ++i)
    {
      const PatternPoint& a = this->Points[triangle.Vertex[Next(i)]];
      const PatternPoint& b = this->Points[triangle.Vertex[Previous(i)]];
      if (Orientation(a, b, p) < 0)
      {
        t = triangle.Neighbor[i];
        found = false;
      }
    }
  }
  return t;
}

/// Returns -1 if the triangle does not have the vertex.
int PatternTriangulation::IndexOf(int triangle, int vertex) const
{
  const int* vertices = this->Triangles[triangle].Vertex;
  const int index = static_cast<int>(std::find(vertices, vertices + 3, vertex) - vertices);
  return index < 3 ? index : -1;
}

int PatternTriangulation::IndexOfNeighbor(int triangle, int neighbor) const
{
  const int* neighbors = this->Triangles[triangle].Neighbor;
  return neighbors[0] == neighbor ? 0 : neighbors[1] == neighbor ? 1 : 2;
}

/// Sets a triangle's vertices and the neighbours opposite to them.
void PatternTriangulation::Set(int triangle, int a, int b, int c, int na, int nb, int nc)
{
  this->Triangles[triangle] = { { a, b, c }, { na, nb, nc } };
  this->TriangleOfVertex[a] = triangle;
  this->TriangleOfVertex[b] = triangle;
  this->TriangleOfVertex[c] = triangle;
}

/// Updates the index of a triangle's neighbour.
void PatternTriangulation::Link(int triangle, int former, int current)
{
  if (triangle >= 0)
  {
    this->Triangles[triangle].Neighbor[this->IndexOfNeighbor(triangle, former)] = current;
  }
}

void PatternTriangulation::Insert(PatternPoint p)
{
  const int t = this->Locate(p);
  const Triangle& triangle = this->Triangles[t];
  int side = -1; // p lies on the side opposite to this vertex
  for (int i = 0; i < 3; ++i)
  {
    const PatternPoint& a = this->Points[triangle.Vertex[Next(i)]];
    const PatternPoint& b = this->Points[triangle.Vertex[Previous(i)]];
    if (SquaredLength(p - a) == 0)
    {
      return;
    }
    if (Orientation(a, b, p) == 0)
    {
      side = i;
    }
  }

  const int vertex = static_cast<int>(this->Points.size());
  this->Points.push_back(p);
  this->TriangleOfVertex.push_back(t);
  if (side < 0)
  {
    this->SplitTriangle(t, vertex);
  }
  else
  {
    this->SplitSide(t, side, vertex);
  }
  this->Legalize();
}

/// Replaces a triangle by the three between its sides and a vertex inside.
void PatternTriangulation::SplitTriangle(int t, int vertex)
{
  const Triangle old = this->Triangles[t];
  const int* v = old.Vertex;
  const int* n = old.Neighbor;
  const int t1 = static_cast<int>(this->Triangles.size());
  const int t2 = t1 + 1;
  this->Triangles.resize(t1 + 2);
  this->Set(t, vertex, v[1], v[2], n[0], t1, t2);
  this->Set(t1, v[0], vertex, v[2], t, n[1], t2);
  this->Set(t2, v[0], v[1], vertex, t, t1, n[2]);
  this->Link(n[1], t, t1);
  this->Link(n[2], t, t2);
  this->Suspects = { { t, vertex }, { t1, vertex }, { t2, vertex } };
}

PatternTriangulation::Diamond PatternTriangulation::GetDiamond(int t, int side) const
{
  const Triangle& abc = this->Triangles[t];
  Diamond diamond;
  diamond.A = abc.Vertex[side];
  diamond.B = abc.Vertex[Next(side)];
  diamond.C = abc.Vertex[Previous(side)];
  diamond.AcrossCA = abc.Neighbor[Next(side)];
  diamond.AcrossAB = abc.Neighbor[Previous(side)];
  diamond.Other = abc.Neighbor[side];
  if (diamond.Other >= 0)
  {
    const Triangle& dcb = this->Triangles[diamond.Other];
    const int i = this->IndexOfNeighbor(diamond.Other, t);
    diamond.D = dcb.Vertex[i];
    diamond.AcrossBD = dcb.Neighbor[Next(i)];
    diamond.AcrossDC = dcb.Neighbor[Previous(i)];
  }
  return diamond;
}

/// Splits the one or two triangles at a side at a vertex on the side.
void PatternTriangulation::SplitSide(int t, int side, int vertex)
{
  const Diamond q = this->GetDiamond(t, side);
  const int t1 = static_cast<int>(this->Triangles.size());
  this->Triangles.resize(t1 + 1);
  this->Set(t, q.A, q.B, vertex, q.Other, t1, q.AcrossAB);
  this->Set(t1, q.A, vertex, q.C, q.Other, q.AcrossCA, t);
  this->Link(q.AcrossCA, t, t1);
  this->Suspects = { { t, vertex }, { t1, vertex } };
  if (q.Other < 0)
  {
    return;
  }
  const int o = q.Other;
  const int o1 = t1 + 1;
  this->Triangles.resize(o1 + 1);
  this->Set(o, q.D, q.C, vertex, t1, o1, q.AcrossDC);
  this->Set(o1, q.D, vertex, q.B, t, q.AcrossBD, o);
  this->Link(q.AcrossBD, o, o1);
  this->Triangles[t].Neighbor[0] = o1;
  this->Suspects.push_back({ o, vertex });
  this->Suspects.push_back({ o1, vertex });
}

/// Replaces a side by the other diagonal of its two triangles if the circle test requires it.
void PatternTriangulation::LegalizeSide(int t, int side)
{
  const Diamond q = this->GetDiamond(t, side);
  const auto& points = this->Points;
  if (q.Other < 0 || !IsInCircle(points[q.A], points[q.B], points[q.C], points[q.D]))
  {
    return;
  }
  const int o = q.Other;
  this->Set(t, q.A, q.B, q.D, q.AcrossBD, o, q.AcrossAB);
  this->Set(o, q.A, q.D, q.C, q.AcrossDC, q.AcrossCA, t);
  this->Link(q.AcrossBD, o, t);
  this->Link(q.AcrossCA, t, o);
  for (int vertex : { q.A, q.D })
  {
    this->Suspects.push_back({ t, vertex });
    this->Suspects.push_back({ o, vertex });
  }
}

void PatternTriangulation::Legalize()
{
  while (!this->Suspects.empty())
  {
    const auto [triangle, vertex] = this->Suspects.back();
    this->Suspects.pop_back();
    const int side = this->IndexOf(triangle, vertex);
    if (side >= 0) // the vertex still belongs to the triangle after other flips
    {
      this->LegalizeSide(triangle, side);
    }
  }
}

void PatternTriangulation::MakeDelaunay()
{
  for (int t = 0; t < static_cast<int>(this->Triangles.size()); ++t)
  {
    for (int vertex : this->Triangles[t].Vertex)
    {
      this->Suspects.push_back({ t, vertex });
    }
  }
  this->Legalize();
}

void PatternTriangulation::GetStar(int vertex, std::vector<std::pair<int, int>>& star) const
{
  star.clear();
  const int first = this->TriangleOfVertex[vertex];
  int t = first;
  do
  {
    const int i = this->IndexOf(t, vertex);
    const Triangle& triangle = this->Triangles[t];
    star.push_back({ triangle.Vertex[Next(i)], triangle.Vertex[Previous(i)] });
    t = triangle.Neighbor[Next(i)];
  } while (t != first);
}
}
