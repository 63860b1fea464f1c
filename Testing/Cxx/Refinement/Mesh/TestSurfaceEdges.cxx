// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that relevo::SurfaceEdges finds the edges and their triangles, compared with pairs of
// merged points collected triangle by triangle.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Mesh/SurfaceEdges.h"
#include "vtkIdList.h"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace
{
using Pair = std::pair<vtkIdType, vtkIdType>;

// Merges points by comparing coordinates exactly.
std::vector<vtkIdType> FindPlaces(vtkPolyData* mesh)
{
  std::map<std::array<double, 3>, vtkIdType> first;
  std::vector<vtkIdType> places;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    double x[3];
    mesh->GetPoint(point, x);
    places.push_back(
      first.insert({ { { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 } }, point }).first->second);
  }
  return places;
}

// The triangles of each edge, and how many of them traverse it upwards.
struct Uses
{
  int Triangles = 0;
  int Ascending = 0;
};

std::map<Pair, Uses> FindEdges(vtkPolyData* mesh)
{
  const std::vector<vtkIdType> places = FindPlaces(mesh);
  std::map<Pair, Uses> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      const std::array<vtkIdType, 3> triangle{ { places[ids->GetId(0)], places[ids->GetId(i)],
        places[ids->GetId(i + 1)] } };
      if (std::set<vtkIdType>(triangle.begin(), triangle.end()).size() < 3)
      {
        continue;
      }
      for (int side = 0; side < 3; ++side)
      {
        const vtkIdType from = triangle[side];
        const vtkIdType to = triangle[(side + 1) % 3];
        Uses& uses = edges[{ std::min(from, to), std::max(from, to) }];
        ++uses.Triangles;
        uses.Ascending += from < to;
      }
    }
  }
  return edges;
}

void TestMesh(RelevoCheck& check, vtkPolyData* mesh)
{
  const auto expected = FindEdges(mesh);
  const relevo::SurfaceEdges edges(mesh);
  CHECK_EQUAL(edges.GetNumberOfEdges(), static_cast<int>(expected.size()));
  int index = 0;
  for (const auto& item : expected) // sorted, as the edges are
  {
    const Pair& places = item.first;
    const Uses& uses = item.second;
    CHECK_EQUAL(edges.GetEdges()[index].MergedPoints[0], places.first);
    CHECK_EQUAL(edges.GetEdges()[index].MergedPoints[1], places.second);
    CHECK_EQUAL(edges.FindEdge(places.first, places.second), index);
    CHECK_EQUAL(edges.FindEdge(places.second, places.first), index);
    int sides = 0;
    edges.ForEachSides(index,
      [&](int i)
      {
        const relevo::SurfaceEdgeSides& two = edges.GetSides()[i];
        ++sides;
        CHECK_EQUAL(two.Edge, index);
        const auto type = uses.Triangles != 2 ? relevo::SurfaceEdgeSides::OPEN
          : uses.Ascending == 1               ? relevo::SurfaceEdgeSides::INNER
                                              : relevo::SurfaceEdgeSides::FLIPPED;
        CHECK_EQUAL(two.Type, type);
        CHECK_EQUAL((two.Triangles[1] < 0), (uses.Triangles == 1));
      });
    CHECK_EQUAL(sides, std::max(1, uses.Triangles - 1));
    ++index;
  }
  const vtkIdType n = mesh->GetNumberOfPoints();
  for (vtkIdType a = -1; a <= n; ++a)
  {
    for (vtkIdType b = -1; b <= std::min<vtkIdType>(n, 60); ++b)
    {
      if (expected.count({ std::min(a, b), std::max(a, b) }) == 0)
      {
        CHECK_EQUAL(edges.FindEdge(a, b), -1);
      }
    }
  }

  // The tag of a point is the largest of the coincident points.
  std::vector<float> tags(expected.size());
  std::vector<float> largest(n, 0.0f);
  for (int edge = 0; edge < edges.GetNumberOfEdges(); ++edge)
  {
    tags[edge] = static_cast<float>((edge * 7919) % 1000);
    for (int place : edges.GetEdges()[edge].MergedPoints)
    {
      largest[place] = std::max(largest[place], tags[edge]);
    }
  }
  vtkNew<vtkFloatArray> ofPoints;
  edges.TagPoints(tags.data(), ofPoints);
  const std::vector<vtkIdType> places = FindPlaces(mesh);
  CHECK_EQUAL(ofPoints->GetNumberOfTuples(), n);
  for (vtkIdType point = 0; point < n; ++point)
  {
    CHECK_EQUAL(ofPoints->GetValue(point), largest[places[point]]);
  }
}
}

int TestSurfaceEdges(int, char*[])
{
  RelevoCheck check;
  for (vtkPolyData* mesh : std::vector<RelevoMeshes::Mesh>{ RelevoMeshes::Make(),
         RelevoMeshes::Sphere(9, 7), RelevoMeshes::Explode(RelevoMeshes::Sphere(9, 7)),
         RelevoMeshes::NonManifold(), RelevoMeshes::Moebius(), RelevoMeshes::Cone(),
         RelevoMeshes::Cube(), RelevoMeshes::NegativeZeros(), RelevoMeshes::Plane(5, 4),
         RelevoMeshes::FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } },
           { { { 0, 1, 2 } }, { { 1, 0, 2 } }, { { 0, 1, 1 } }, { { 2, 1, 0 } } }) })
  {
    TestMesh(check, mesh);
  }
  return check.GetResult();
}
