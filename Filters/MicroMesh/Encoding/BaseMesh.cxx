// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/BaseMesh.h"

#include "Base/EdgeCollapse.h"
#include "Data/OctahedralUnit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace relevo
{
namespace
{
// The multiples to which points are rounded, in displacements of 1, which are at most a quarter of
// the tolerance. Rounding moves a point by at most 0.06 of the tolerance.
constexpr double RoundingOfStep = 0.25;
// Only vertices are rounded whose triangles have larger heights, in multiples. Otherwise points
// could become the same, also those of other blocks of a surface.
constexpr double LeastHeight = 4.0;
}

BaseMesh::BaseMesh(const DenseMesh& dense, EdgeCollapse& collapse, double step)
{
  this->AddPoints(dense, collapse, step);
  this->AddEdges(collapse);
}

void BaseMesh::AddPoints(const DenseMesh& dense, EdgeCollapse& collapse, double step)
{
  std::vector<int> numbers(dense.Points.size(), -1);
  for (std::size_t t = 0; t < dense.Triangles.size(); ++t)
  {
    if (!collapse.IsLeft(t))
    {
      continue;
    }
    MicroMesh::Face face{};
    for (int c = 0; c < 3; ++c)
    {
      const int vertex = collapse.GetTriangles()[t][c];
      int& number = numbers[static_cast<std::size_t>(vertex)];
      if (number < 0)
      {
        number = static_cast<int>(this->Vertices.size());
        this->Vertices.push_back(vertex);
      }
      face.Corners[c] = number;
    }
    this->Mesh.Faces.push_back(face);
    this->Triangles.push_back(static_cast<int>(t));
    this->Wedges.push_back(collapse.GetWedges(t));
  }
  const std::vector<double> heights = this->FindHeights(dense);
  const double multiple = RoundingOfStep * step;
  for (std::size_t i = 0; i < this->Vertices.size(); ++i)
  {
    const int vertex = this->Vertices[i];
    const bool isSingle = collapse.GetClusterSize(vertex) == 1;
    const bool isKept = isSingle || dense.IsFixed(vertex) || heights[i] < LeastHeight * multiple ||
      dense.Kinds[static_cast<std::size_t>(vertex)] == DenseMesh::Kind::LOCKED;
    this->AddPoint(dense, vertex, isKept ? 0.0 : multiple);
    this->AreSingle.push_back(isSingle ? 1 : 0);
    this->Densities.push_back(
      2.0 * collapse.GetClusterSize(vertex) / collapse.GetNumberOfTriangles(vertex));
    const vec3 normal = FromOctahedral(ToOctahedral(dvec3(collapse.GetNormal(vertex))));
    const vec3 fixed = dense.GetFixedDirection(vertex);
    this->Mesh.Directions.push_back(
      fixed != vec3(0.0f) ? fixed : normal * static_cast<float>(step));
  }
}

// The smallest height of the triangles at each point, from there to the opposite side.
std::vector<double> BaseMesh::FindHeights(const DenseMesh& dense) const
{
  std::vector<double> heights(this->Vertices.size(), std::numeric_limits<double>::infinity());
  for (const MicroMesh::Face& face : this->Mesh.Faces)
  {
    dvec3 x[3];
    for (int c = 0; c < 3; ++c)
    {
      const int vertex = this->Vertices[static_cast<std::size_t>(face.Corners[c])];
      x[c] = dense.Points[static_cast<std::size_t>(vertex)];
    }
    const double area = length(cross(x[1] - x[0], x[2] - x[0]));
    for (int c = 0; c < 3; ++c)
    {
      const double side = length(x[(c + 2) % 3] - x[(c + 1) % 3]);
      double& height = heights[static_cast<std::size_t>(face.Corners[c])];
      height = std::min(height, side > 0.0 ? area / side : 0.0);
    }
  }
  return heights;
}

// Adds a vertex, rounded to multiples of a length if it is not 0.
void BaseMesh::AddPoint(const DenseMesh& dense, int vertex, double multiple)
{
  const dvec3& point = dense.Points[static_cast<std::size_t>(vertex)];
  const dvec3 place = dense.GetPlace(vertex);
  this->Mesh.Points.push_back(point);
  this->Places.push_back(place);
  if (multiple > 0.0)
  {
    const double length = multiple * dense.Scale;
    dvec3 rounded(0.0);
    for (int c = 0; c < 3; ++c)
    {
      rounded[c] = std::nearbyint(place[c] / length) * length;
      rounded[c] = dense.CanStore(rounded[c]) ? rounded[c] : place[c];
    }
    this->Mesh.Points.back() = dense.FromInput(rounded);
    this->Places.back() = rounded;
  }
}

void BaseMesh::AddEdges(const EdgeCollapse& collapse)
{
  struct Side
  {
    std::uint64_t Ends;
    int Index; // 3 * face + edge
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < this->Mesh.Faces.size(); ++f)
  {
    for (int e = 0; e < 3; ++e)
    {
      const auto from = static_cast<std::uint64_t>(this->Mesh.Faces[f].Corners[e]);
      const auto to = static_cast<std::uint64_t>(this->Mesh.Faces[f].Corners[(e + 1) % 3]);
      sides.push_back(
        { std::min(from, to) << 32 | std::max(from, to), 3 * static_cast<int>(f) + e });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return a.Ends != b.Ends ? a.Ends < b.Ends : a.Index < b.Index; });
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const auto low = static_cast<std::size_t>(sides[i].Ends >> 32);
    const auto high = static_cast<std::size_t>(sides[i].Ends & 0xffffffffu);
    if (i == 0 || sides[i].Ends != sides[i - 1].Ends)
    {
      this->Mesh.Edges.push_back({ 0, 0 });
      this->EdgeFlags.push_back(collapse.GetLineFlags(this->Vertices[low], this->Vertices[high]));
    }
    MicroMesh::Face& face = this->Mesh.Faces[static_cast<std::size_t>(sides[i].Index / 3)];
    const int e = sides[i].Index % 3;
    const bool isReversed = face.Corners[e] != static_cast<int>(low);
    face.Edges[e] = static_cast<int>(this->Mesh.Edges.size() - 1) << 1 | (isReversed ? 1 : 0);
  }
}

void BaseMesh::ChooseLevels(int maximumLevel, const std::vector<int>& raises)
{
  std::vector<char> areStraight(this->Mesh.Edges.size());
  for (std::size_t e = 0; e < areStraight.size(); ++e)
  {
    areStraight[e] = this->EdgeFlags[e] != 0;
    this->Mesh.Edges[e].Level = 0;
  }
  for (std::size_t f = 0; f < this->Mesh.Faces.size(); ++f)
  {
    MicroMesh::Face& face = this->Mesh.Faces[f];
    double triangles = 0.0; // of the dense mesh, about
    for (int c = 0; c < 3; ++c)
    {
      const auto corner = static_cast<std::size_t>(face.Corners[c]);
      const auto next = static_cast<std::size_t>(face.Corners[(c + 1) % 3]);
      triangles += this->Densities[corner];
      areStraight[static_cast<std::size_t>(face.Edges[c] >> 1)] |=
        this->AreSingle[corner] != 0 && this->AreSingle[next] != 0;
    }
    const int level =
      static_cast<int>(std::ceil(0.5 * std::log2(std::max(1.0, triangles)))) + raises[f];
    face.Level = this->IsOriginal(face) ? 0 : std::min(level, maximumLevel);
  }
  for (const MicroMesh::Face& face : this->Mesh.Faces)
  {
    for (int reference : face.Edges)
    {
      const auto e = static_cast<std::size_t>(reference >> 1);
      int& level = this->Mesh.Edges[e].Level;
      level = areStraight[e] != 0 ? 0 : std::max(level, face.Level);
    }
  }
  for (MicroMesh::Face& face : this->Mesh.Faces)
  {
    for (int reference : face.Edges)
    {
      face.Level =
        std::max(face.Level, this->Mesh.Edges[static_cast<std::size_t>(reference >> 1)].Level);
    }
  }
}
}
