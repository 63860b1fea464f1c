// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternMesh.h"

#include "Patterns/PatternInnerPoints.h"
#include "Patterns/PatternPoint.h"
#include "Patterns/PatternSmoother.h"
#include "Patterns/PatternTriangulation.h"

#include <cstddef>
#include <cstdint>

namespace
{
using namespace relevo;

/// The number, in the order of the pattern, of the vertex at v = i / n, w = j / n in the regular
/// grid of n segments. Inner vertices are ordered by rows.
int RegularVertex(int n, int i, int j)
{
  const int k = n - i - j;
  if (k == n)
  {
    return 0;
  }
  if (i == n)
  {
    return 1;
  }
  if (j == n)
  {
    return 2;
  }
  if (j == 0)
  {
    return 2 + i;
  }
  if (k == 0)
  {
    return 1 + n + j;
  }
  if (i == 0)
  {
    return 2 * n + k;
  }
  // Row j follows j - 1 rows of n - 2, n - 3, ... vertices.
  return 3 * n + (j - 1) * (n - 1) - (j - 1) * j / 2 + i - 1;
}

PatternTriangulation TriangulateBorder(const int segments[3])
{
  PatternTriangulation triangulation; // contains the corners
  const auto border = MakeBorderVertices(segments, GridScale);
  for (std::size_t i = 3; i < border.size(); ++i)
  {
    triangulation.Insert({ border[i][1], border[i][2] });
  }
  return triangulation;
}

/// Smooths the triangulation of a border with inner points, and again without obstructing points.
PatternTriangulation TriangulateInside(const int segments[3], const PatternTriangulation& border)
{
  const std::size_t firstInner = border.Points.size();
  std::vector<PatternPoint> inner = MakeInnerPoints(segments, border.Points);
  for (;;) // ends because each round starts with fewer points
  {
    PatternTriangulation triangulation = border;
    for (const PatternPoint& p : inner)
    {
      triangulation.Insert(p);
    }
    PatternSmoother smoother(triangulation, static_cast<int>(firstInner));
    smoother.Move();
    const std::vector<bool> superfluous = smoother.FindSuperfluousPoints();
    inner.clear();
    for (std::size_t i = firstInner; i < superfluous.size(); ++i)
    {
      if (!superfluous[i])
      {
        inner.push_back(triangulation.Points[i]);
      }
    }
    if (firstInner + inner.size() == superfluous.size())
    {
      return triangulation;
    }
  }
}
}

namespace relevo
{
PatternMesh MakeRegularMesh(int n)
{
  PatternMesh mesh;
  const int segments[3] = { n, n, n };
  mesh.Vertices = MakeBorderVertices(segments, WeightScale);
  for (int j = 1; j < n; ++j)
  {
    for (int i = 1; i + j < n; ++i)
    {
      const std::int64_t v = DivideRounded(i * WeightScale, n);
      const std::int64_t w = DivideRounded(j * WeightScale, n);
      mesh.Vertices.push_back({ WeightScale - v - w, v, w });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i + j < n; ++i)
    {
      mesh.Triangles.push_back(
        { RegularVertex(n, i, j), RegularVertex(n, i + 1, j), RegularVertex(n, i, j + 1) });
      if (i + j + 1 < n)
      {
        mesh.Triangles.push_back({ RegularVertex(n, i + 1, j), RegularVertex(n, i + 1, j + 1),
          RegularVertex(n, i, j + 1) });
      }
    }
  }
  return mesh;
}

PatternMesh MakeGradedMesh(const int segments[3])
{
  const PatternTriangulation border = TriangulateBorder(segments);
  const PatternTriangulation triangulation = TriangulateInside(segments, border);

  PatternMesh mesh;
  mesh.Vertices = MakeBorderVertices(segments, WeightScale);
  constexpr std::int64_t unit = WeightScale / GridScale;
  for (std::size_t i = border.Points.size(); i < triangulation.Points.size(); ++i)
  {
    const PatternPoint& p = triangulation.Points[i];
    mesh.Vertices.push_back({ (GridScale - p.V - p.W) * unit, p.V * unit, p.W * unit });
  }
  for (const auto& triangle : triangulation.Triangles)
  {
    mesh.Triangles.push_back({ triangle.Vertex[0], triangle.Vertex[1], triangle.Vertex[2] });
  }
  return mesh;
}
}
