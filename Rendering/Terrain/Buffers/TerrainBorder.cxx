// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/TerrainBorder.h"

#include "Bisection/FaceHeights.h"
#include "Lattice/BlockErrors.h"
#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace relevo
{
namespace
{
using LatticePoint = std::array<std::int64_t, 2>;

// A convex part of a triangle. Each border adds a corner.
struct ClippedTriangle
{
  std::array<LatticePoint, 5> Points;
  int Count = 0;
};

LatticePoint GetUnits(const TerrainFace& face, int a, int b)
{
  const int shift = face.Level - BlockErrors::FinestLevel;
  const LatticePoint vertex = face.GetVertex(a, b);
  return { { vertex[0] << shift, vertex[1] << shift } };
}

std::array<LatticePoint, 3> GetFaceCorners(const TerrainFace& face)
{
  return { { GetUnits(face, 0, 0), GetUnits(face, TerrainFace::Segments, 0),
    GetUnits(face, 0, TerrainFace::Segments) } };
}

// Twice the area.
std::int64_t GetArea(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool IsOnLine(
  const LatticePoint& from, const LatticePoint& to, const std::array<LatticePoint, 2>& points)
{
  return GetArea(from, to, points[0]) == 0 && GetArea(from, to, points[1]) == 0;
}

// Edges are parallel to an axis or diagonal, so that all points are whole numbers.
void ClipTriangle(int axis, std::int64_t last, ClippedTriangle& triangle)
{
  ClippedTriangle clipped;
  for (int i = 0; i < triangle.Count; ++i)
  {
    const LatticePoint& here = triangle.Points[i];
    const LatticePoint& next = triangle.Points[(i + 1) % triangle.Count];
    if (here[axis] <= last)
    {
      clipped.Points[clipped.Count++] = here;
    }
    if ((here[axis] < last && next[axis] > last) || (here[axis] > last && next[axis] < last))
    {
      LatticePoint& point = clipped.Points[clipped.Count++];
      const std::int64_t along = next[axis] - here[axis];
      const std::int64_t across = next[1 - axis] - here[1 - axis];
      point[axis] = last;
      point[1 - axis] = here[1 - axis] +
        (across == 0 ? 0 : (last - here[axis]) * ((across > 0) == (along > 0) ? 1 : -1));
    }
  }
  triangle = clipped;
}

int GetSign(std::int64_t number)
{
  return number > 0 ? 1 : number < 0 ? -1 : 0;
}

std::array<std::uint64_t, 2> MakeSideKey(const LatticePoint& a, const LatticePoint& b)
{
  const std::uint64_t keys[2] = { MakeGridKey(a[0], a[1]), MakeGridKey(b[0], b[1]) };
  return { { std::min(keys[0], keys[1]), std::max(keys[0], keys[1]) } };
}

bool AreSameFaces(const TerrainFace& a, const TerrainFace& b)
{
  // Compares bits, because heights may be NaN.
  return a.Level == b.Level && a.Made == b.Made && a.Apex == b.Apex && a.Step1 == b.Step1 &&
    a.Step2 == b.Step2 && a.Morph == b.Morph && a.Tile == b.Tile && a.CoarseTile == b.CoarseTile &&
    std::memcmp(a.CornerHeights.data(), b.CornerHeights.data(), sizeof(a.CornerHeights)) == 0;
}

// The vertices of a face that have no height or, on a globe, no position; empty if all have.
std::vector<bool> FindMissing(const TerrainFace& face, const GlobeFaces::Vertices* vertices)
{
  std::vector<bool> missing;
  const FaceHeights heights(face);
  for (int b = 0; b <= TerrainFace::Segments; ++b)
  {
    for (int a = 0; a + b <= TerrainFace::Segments; ++a)
    {
      const int index = GlobeFaces::GetIndex(a, b);
      if (std::isnan(heights.GetHeight(a, b)) ||
        (vertices && std::isnan((*vertices)[index].Position[0])))
      {
        missing.resize(GlobeFaces::VerticesPerFace, false);
        missing[index] = true;
      }
    }
  }
  return missing;
}
}

void TerrainBorder::Clear()
{
  this->Faces.clear();
  this->AreAtBorder.clear();
  this->Means.clear();
  this->Triangles.clear();
}

void TerrainBorder::Update(const std::vector<TerrainFace>& faces, const Settings& settings)
{
  if (faces.size() == this->Faces.size() &&
    std::equal(faces.begin(), faces.end(), this->Faces.begin(), AreSameFaces))
  {
    return;
  }
  this->Clear();
  this->Current = settings;
  this->Faces = faces;
  this->FindFaces(faces);
  this->OpenEdges.clear();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (this->AreAtBorder[i])
    {
      this->AddFace(faces, static_cast<int>(i), this->Missing[i]);
    }
  }
  this->AddOpenSides();
}

// Finds the faces at borders, those with missing data, and the neighbours of these.
void TerrainBorder::FindFaces(const std::vector<TerrainFace>& faces)
{
  this->AreAtBorder.assign(faces.size(), false);
  this->Missing.assign(faces.size(), {});
  this->SidesAtBorder.clear();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const std::array<LatticePoint, 3> corners = GetFaceCorners(faces[i]);
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto count = [&corners](const auto& condition)
      { return std::count_if(corners.begin(), corners.end(), condition); };
      const std::int64_t last = this->Current.Last[axis];
      const bool isBeyond = count([=](const LatticePoint& c) { return c[axis] > last; }) > 0;
      const bool isAtLast = count([=](const LatticePoint& c) { return c[axis] == last; }) == 2;
      const bool isAtFirst = this->Current.HasFirst[axis] &&
        count([=](const LatticePoint& c) { return c[axis] == 0; }) == 2;
      this->AreAtBorder[i] = this->AreAtBorder[i] || isBeyond || isAtLast || isAtFirst;
    }
    this->Missing[i] =
      FindMissing(faces[i], this->Current.Vertices ? (*this->Current.Vertices)[i] : nullptr);
    if (!this->Missing[i].empty())
    {
      this->AreAtBorder[i] = true;
      for (int side = 0; side < 3; ++side)
      {
        this->SidesAtBorder[MakeSideKey(corners[side], corners[(side + 1) % 3])] = 0;
      }
    }
  }
  if (!this->SidesAtBorder.empty())
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const std::array<LatticePoint, 3> corners = GetFaceCorners(faces[i]);
      for (int side = 0; side < 3 && !this->AreAtBorder[i]; ++side)
      {
        this->AreAtBorder[i] =
          this->SidesAtBorder.count(MakeSideKey(corners[side], corners[(side + 1) % 3])) > 0;
      }
    }
    this->SidesAtBorder.clear();
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const std::array<LatticePoint, 3> corners = GetFaceCorners(faces[i]);
    for (int side = 0; side < 3 && this->AreAtBorder[i]; ++side)
    {
      ++this->SidesAtBorder[MakeSideKey(corners[side], corners[(side + 1) % 3])];
    }
  }
}

// Adds the triangles of a face, and walls below the edges that no neighbour in the face has.
void TerrainBorder::AddFace(
  const std::vector<TerrainFace>& faces, int index, const std::vector<bool>& missing)
{
  const TerrainFace& face = faces[static_cast<std::size_t>(index)];
  this->MeansOfFace.clear();
  std::vector<Edge> edges;
  for (const TerrainFace::PatternTriangle& triangle : TerrainFace::GetPattern())
  {
    const bool isMissing = !missing.empty() &&
      std::any_of(triangle.begin(), triangle.end(),
        [&missing](const std::array<int, 2>& ab)
        { return missing[static_cast<std::size_t>(GlobeFaces::GetIndex(ab[0], ab[1]))]; });
    if (!isMissing)
    {
      this->AddTriangle(face, index, triangle, edges);
    }
  }
  const auto isBefore = [](const Edge& a, const Edge& b) { return a.Means < b.Means; };
  std::sort(edges.begin(), edges.end(), isBefore);
  const std::array<LatticePoint, 3> corners = GetFaceCorners(face);
  for (const Edge& edge : edges)
  {
    Edge reversed;
    reversed.Means = { { edge.Means[1], edge.Means[0] } };
    if (std::binary_search(edges.begin(), edges.end(), reversed, isBefore))
    {
      continue;
    }
    bool hasWall = true;
    bool isOnSide = false;
    if (!this->IsOnBorder(edge, hasWall))
    {
      for (int side = 0; side < 3; ++side)
      {
        isOnSide = isOnSide || IsOnLine(corners[side], corners[(side + 1) % 3], edge.Points);
      }
    }
    if (isOnSide)
    {
      this->OpenEdges.push_back(edge);
    }
    else if (hasWall)
    {
      this->AddWall(edge);
    }
  }
}

bool TerrainBorder::IsOnBorder(const Edge& edge, bool& hasWall) const
{
  for (int axis = 0; axis < 2; ++axis)
  {
    for (std::int64_t border : { std::int64_t(0), this->Current.Last[axis] })
    {
      if (edge.Points[0][axis] == border && edge.Points[1][axis] == border)
      {
        hasWall = border > 0 || this->Current.HasFirst[axis];
        return true;
      }
    }
  }
  return false;
}

// Edges on the sides of faces can have a triangle of another face.
void TerrainBorder::AddOpenSides()
{
  std::unordered_map<SideKey, int, HashSide> numbers;
  for (const Edge& edge : this->OpenEdges)
  {
    ++numbers[MakeSideKey(edge.Points[0], edge.Points[1])];
  }
  for (const Edge& edge : this->OpenEdges)
  {
    if (numbers[MakeSideKey(edge.Points[0], edge.Points[1])] > 1)
    {
      continue;
    }
    const std::array<LatticePoint, 3> corners =
      GetFaceCorners(this->Faces[static_cast<std::size_t>(edge.Face)]);
    for (int side = 0; side < 3; ++side)
    {
      const LatticePoint& from = corners[side];
      const LatticePoint& to = corners[(side + 1) % 3];
      if (IsOnLine(from, to, edge.Points) && this->SidesAtBorder[MakeSideKey(from, to)] > 1)
      {
        this->AddWall(edge);
      }
    }
  }
}

void TerrainBorder::AddTriangle(const TerrainFace& face, int index,
  const TerrainFace::PatternTriangle& triangle, std::vector<Edge>& edges)
{
  ClippedTriangle clipped;
  for (const auto& [a, b] : triangle)
  {
    clipped.Points[clipped.Count++] = GetUnits(face, a, b);
  }
  if ((GetArea(clipped.Points[0], clipped.Points[1], clipped.Points[2]) < 0) !=
    this->Current.IsMirrored)
  {
    std::swap(clipped.Points[1], clipped.Points[2]);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    ClipTriangle(axis, this->Current.Last[axis], clipped);
    if (clipped.Count < 3)
    {
      return;
    }
  }
  std::array<int, 5> means;
  for (int i = 0; i < clipped.Count; ++i)
  {
    means[i] = this->AddMean(face, triangle, clipped.Points[i]);
  }
  for (int i = 0; i < clipped.Count; ++i)
  {
    const int next = (i + 1) % clipped.Count;
    edges.push_back(
      { index, { { means[i], means[next] } }, { { clipped.Points[i], clipped.Points[next] } } });
  }
  for (bool isAtBase : { false, true })
  {
    for (int i = 2; i < clipped.Count; ++i)
    {
      this->Triangles.push_back({ index, isAtBase ? Bottom : 0,
        { { { means[0], isAtBase }, { means[isAtBase ? i : i - 1], isAtBase },
          { means[isAtBase ? i - 1 : i], isAtBase } } } });
    }
  }
}

// The weights are areas, which are the same for all triangles of an edge up to a power of 2.
int TerrainBorder::AddMean(
  const TerrainFace& face, const TerrainFace::PatternTriangle& triangle, const Point& point)
{
  const auto [found, isNew] = this->MeansOfFace.emplace(
    MakeGridKey(point[0], point[1]), static_cast<int>(this->Means.size()));
  if (!isNew)
  {
    return found->second;
  }
  std::array<LatticePoint, 3> corners;
  std::transform(triangle.begin(), triangle.end(), corners.begin(),
    [&face](const std::array<int, 2>& ab) { return GetUnits(face, ab[0], ab[1]); });
  const auto area = static_cast<double>(GetArea(corners[0], corners[1], corners[2]));
  Mean mean{};
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t part = GetArea(point, corners[(i + 1) % 3], corners[(i + 2) % 3]);
    if (part != 0)
    {
      mean.Vertices[mean.NumberOfVertices] = triangle[i];
      if (mean.NumberOfVertices < 2)
      {
        mean.Weights[mean.NumberOfVertices] = static_cast<float>(static_cast<double>(part) / area);
      }
      ++mean.NumberOfVertices;
    }
  }
  this->Means.push_back(mean);
  return found->second;
}

void TerrainBorder::AddWall(const Edge& edge)
{
  // The wall faces to the right of the edge, seen from above.
  const int turn = this->Current.IsMirrored ? -1 : 1;
  const int outward[2] = { turn * GetSign(edge.Points[1][1] - edge.Points[0][1]),
    -turn * GetSign(edge.Points[1][0] - edge.Points[0][0]) };
  const int side = 1 + (outward[0] + 1) + 3 * (outward[1] + 1);
  const auto& [first, second] = edge.Means;
  this->Triangles.push_back(
    { edge.Face, side, { { { second, false }, { first, false }, { first, true } } } });
  this->Triangles.push_back(
    { edge.Face, side, { { { second, false }, { first, true }, { second, true } } } });
}

std::vector<unsigned int> TerrainBorder::Expand(
  TerrainPatterns::Primitives primitives, const std::vector<unsigned int>& places) const
{
  std::vector<unsigned int> numbers;
  const auto add = [&](const Triangle& triangle, const Corner& corner)
  {
    const Mean& mean = this->Means[static_cast<std::size_t>(corner.Mean)];
    unsigned int vertices = 0;
    for (int i = 0; i < 3; ++i)
    {
      vertices |= static_cast<unsigned int>(mean.Vertices[i][0] + 16 * mean.Vertices[i][1])
        << (8 * i);
    }
    vertices |= static_cast<unsigned int>(mean.NumberOfVertices) << 24 |
      static_cast<unsigned int>(corner.IsAtBase ? 1 : 0) << 26 |
      static_cast<unsigned int>(triangle.Side) << 27;
    unsigned int weights[2];
    std::memcpy(weights, mean.Weights.data(), sizeof(weights));
    numbers.insert(numbers.end(),
      { places[static_cast<std::size_t>(triangle.Face)], vertices, weights[0], weights[1] });
  };
  const auto getId = [](const Corner& corner)
  { return 2 * corner.Mean + (corner.IsAtBase ? 1 : 0); };
  std::vector<std::uint64_t> known; // ids are those of one face
  int face = -1;
  for (const Triangle& triangle : this->Triangles)
  {
    if (triangle.Face != face)
    {
      known.clear();
      face = triangle.Face;
    }
    for (int i = 0; i < 3; ++i)
    {
      const Corner& here = triangle.Corners[i];
      const Corner& next = triangle.Corners[(i + 1) % 3];
      if (primitives == TerrainPatterns::TRIANGLES)
      {
        add(triangle, here);
        continue;
      }
      const bool isPoint = primitives == TerrainPatterns::POINTS;
      const std::uint64_t key = isPoint
        ? static_cast<std::uint64_t>(getId(here))
        : MakeGridKey(std::min(getId(here), getId(next)), std::max(getId(here), getId(next)));
      if (std::find(known.begin(), known.end(), key) != known.end())
      {
        continue;
      }
      known.push_back(key);
      add(triangle, here);
      if (!isPoint)
      {
        add(triangle, next);
      }
    }
  }
  return numbers;
}
}
