// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceSeams.h"

#include "Mesh/FaceNeighbors.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <tuple>

namespace relevo
{
namespace
{
// Cosine of the largest angle between two triangles that form a quadrilateral.
constexpr double MinimumFlatness = 0.999;
// Maximum number of triangles at one edge; edges with more are ignored.
constexpr size_t MaximumAtEdge = 8;

// An edge of a triangle, from the lower to the higher point id.
struct Edge
{
  bool IsAt(const Edge& other) const { return this->Low == other.Low && this->High == other.High; }
  bool operator<(const Edge& other) const
  {
    return std::tie(this->Low, this->High, this->Face) <
      std::tie(other.Low, other.High, other.Face);
  }

  int Low;
  int High;
  int Opposite; // corner
  int Face;
};

std::vector<Edge> GetEdges(
  const std::vector<std::array<int, 4>>& faces, const std::vector<int>& border)
{
  std::vector<Edge> edges;
  for (int face : border)
  {
    const std::array<int, 4>& corners = faces[face];
    for (int i = 0; i < 3 && corners[3] < 0; ++i)
    {
      const int a = corners[i];
      const int b = corners[(i + 1) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), corners[(i + 2) % 3], face });
    }
  }
  vtkSMPTools::Sort(edges.begin(), edges.end());
  return edges;
}

// Whether two triangles on opposite sides of an edge are coplanar.
bool AreFlat(const std::vector<dvec3>& points, const Edge& a, const Edge& b)
{
  const dvec3 along = points[a.High] - points[a.Low];
  const dvec3 normal = cross(along, points[a.Opposite] - points[a.Low]);
  const dvec3 other = cross(points[b.Opposite] - points[b.Low], along);
  return dot(normal, other) > MinimumFlatness * length(normal) * length(other);
}
}

std::vector<FaceSeam> FindSeams(const std::vector<dvec3>& points,
  const std::vector<std::array<int, 4>>& faces, const std::vector<int>& border)
{
  std::vector<std::array<int, 4>> quadrilaterals;
  std::vector<std::array<int, 2>> parts;
  for (int face : border)
  {
    if (faces[face][3] >= 0)
    {
      quadrilaterals.push_back(faces[face]);
      parts.push_back({ { face, -1 } });
    }
  }
  const std::vector<Edge> edges = GetEdges(faces, border);
  for (auto begin = edges.begin(); begin != edges.end();)
  {
    const auto first = begin;
    begin = std::find_if(begin, edges.end(), [=](const Edge& edge) { return !edge.IsAt(*first); });
    for (auto a = first; a != begin && static_cast<size_t>(begin - first) <= MaximumAtEdge; ++a)
    {
      for (auto b = a + 1; b != begin; ++b)
      {
        if (AreFlat(points, *a, *b))
        {
          quadrilaterals.push_back({ { a->Low, a->Opposite, a->High, b->Opposite } });
          parts.push_back({ { a->Face, b->Face } });
        }
      }
    }
  }
  const FaceMatch match = MatchFaces(quadrilaterals, static_cast<int>(points.size()));
  std::vector<FaceSeam> seams;
  for (size_t i = 0; i < quadrilaterals.size(); ++i)
  {
    const int other = match.Others[i];
    if (other > static_cast<int>(i))
    {
      seams.push_back({ quadrilaterals[i], { { parts[i], parts[other] } } });
    }
  }
  return seams;
}
}
