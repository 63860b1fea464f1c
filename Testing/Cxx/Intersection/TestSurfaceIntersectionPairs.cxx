// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises exactly the pairs of triangles that intersect, tested with
// small meshes of whole coordinates. Many triangles touch in a corner, along an edge, or are
// coplanar.
#include "Mesh/MovedSurface.h"
#include "Pairs/PairSearch.h"
#include "RelevoCheck.h"
#include "RelevoTrianglePairs.h"

#include <set>
#include <utility>

namespace
{
using Pairs = std::set<std::pair<vtkIdType, vtkIdType>>;

Pairs FindPairs(const relevo::MovedSurface& first, const relevo::MovedSurface& second)
{
  Pairs pairs;
  for (const relevo::IntersectingPair& pair : relevo::FindMeetingPairs(first, second))
  {
    pairs.emplace(pair.Triangles[0], pair.Triangles[1]);
  }
  return pairs;
}

void Take(RelevoCheck& check, const RelevoWholeMesh& mesh, relevo::MovedSurface& surface)
{
  CHECK(surface.Take(mesh.NewPolyData()).empty());
  CHECK(surface.Move({}).empty());
  CHECK_EQUAL(surface.GetNumberOfFlatTriangles(), 0);
  CHECK_EQUAL(surface.GetNumberOfTriangles(), static_cast<vtkIdType>(mesh.Triangles.size()));
}

void TestTwoMeshes(RelevoCheck& check, RelevoDice& dice, int side, Pairs::size_type& total)
{
  const RelevoWholeMesh first(dice, side, 8, 12);
  const RelevoWholeMesh second(dice, side, 7, 10);
  relevo::MovedSurface surfaces[2];
  Take(check, first, surfaces[0]);
  Take(check, second, surfaces[1]);
  Pairs expected;
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 10; ++j)
    {
      if (RelevoMeet(first.GetCorners(i), second.GetCorners(j)))
      {
        expected.emplace(i, j);
      }
    }
  }
  CHECK_EQUAL(FindPairs(surfaces[0], surfaces[1]), expected);
  total += expected.size();
}

void TestOneMesh(RelevoCheck& check, RelevoDice& dice, int side, Pairs::size_type& total)
{
  const RelevoWholeMesh mesh(dice, side, 8, 14);
  relevo::MovedSurface surface;
  Take(check, mesh, surface);
  Pairs expected;
  for (int i = 0; i < 14; ++i)
  {
    for (int j = i + 1; j < 14; ++j)
    {
      if (RelevoMeetBeyond(mesh, i, j))
      {
        expected.emplace(i, j);
      }
    }
  }
  CHECK_EQUAL(FindPairs(surface, surface), expected);
  total += expected.size();
}
}

int TestSurfaceIntersectionPairs(int, char*[])
{
  RelevoCheck check;
  RelevoDice dice(1);
  Pairs::size_type two = 0;
  Pairs::size_type one = 0;
  for (int i = 0; i < 4000; ++i)
  {
    TestTwoMeshes(check, dice, 3 + i % 6, two);
    TestOneMesh(check, dice, 3 + i % 6, one);
  }
  // Both intersecting and separate pairs occur.
  CHECK(two > 50000 && two < 430000);
  CHECK_GREATER(one, 50000);
  CHECK_LESS(one, 320000);
  return check.GetResult();
}
