// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping/FacePatch.h"

#include "Bisection/FaceHeights.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr int FaceSegments = TerrainFace::Segments;

// Positions on an edge belong to both faces in spite of rounding errors, in cells of the pattern.
constexpr double EdgeTolerance = 1e-7;
}

FacePatch::FacePatch(const TerrainFace& face, const GlobeFaces::Vertices* vertices,
  const TerrainPlacement& placement, const MapPosition& lastSample)
  : Face(face)
  , Vertices(vertices)
  , Placement(placement)
  , LastSample(lastSample)
  , Size(std::ldexp(1.0, face.Level))
{
  for (const PatternVertex& corner : { PatternVertex{ { 0, 0 } },
         PatternVertex{ { FaceSegments, 0 } }, PatternVertex{ { 0, FaceSegments } } })
  {
    this->Box.Add(face.GetSample(corner[0], corner[1]));
  }
  this->Box.Clip(lastSample);
}

MapPosition FacePatch::ToPattern(const MapPosition& position) const
{
  const TerrainFace& face = this->Face;
  const double x = position[0] / this->Size - static_cast<double>(face.Apex[0]);
  const double y = position[1] / this->Size - static_cast<double>(face.Apex[1]);
  // The steps are orthogonal and have equal lengths.
  const double squared = face.Step1[0] * face.Step1[0] + face.Step1[1] * face.Step1[1];
  return { { (x * face.Step1[0] + y * face.Step1[1]) / squared,
    (x * face.Step2[0] + y * face.Step2[1]) / squared } };
}

SurfaceVertex FacePatch::GetVertex(const PatternVertex& vertex) const
{
  SurfaceVertex result;
  result.Position = this->Face.GetSample(vertex[0], vertex[1]);
  result.Height = FaceHeights(this->Face).GetHeight(vertex[0], vertex[1]);
  if (this->Vertices)
  {
    const auto [a, b] = vertex;
    result.World = GlobeFaces::GetWorld(this->Face, *this->Vertices, this->Placement, a, b);
    result.Up = (*this->Vertices)[GlobeFaces::GetIndex(a, b)].Up;
    // There is no surface outside of the projection.
    result.Height = std::isnan(result.World[0]) ? result.World[0] : result.Height;
  }
  else
  {
    result.World = this->Placement.ToWorld(result.Position[0], result.Position[1], result.Height);
  }
  return result;
}

bool FacePatch::GetTriangle(
  const std::array<PatternVertex, 3>& vertices, SurfaceTriangle& triangle) const
{
  for (int i = 0; i < 3; ++i)
  {
    triangle[i] = this->GetVertex(vertices[i]);
    if (std::isnan(triangle[i].Height))
    {
      return false;
    }
  }
  return true;
}

// The cells of the pattern are split along the diagonal between vertices (a, b) with an even sum.
bool FacePatch::FindTriangle(const MapPosition& inPattern, SurfaceTriangle& triangle) const
{
  const int i = static_cast<int>(std::clamp(std::floor(inPattern[0]), 0.0, FaceSegments - 1.0));
  const int j = static_cast<int>(std::clamp(std::floor(inPattern[1]), 0.0, FaceSegments - 1.0 - i));
  const double u = inPattern[0] - i;
  const double v = inPattern[1] - j;
  const PatternVertex low = { { i, j } };
  const PatternVertex right = { { i + 1, j } };
  const PatternVertex up = { { i, j + 1 } };
  const PatternVertex high = { { i + 1, j + 1 } };
  if ((i + j) % 2 == 0)
  {
    return u >= v ? this->GetTriangle({ { low, right, high } }, triangle)
                  : this->GetTriangle({ { low, high, up } }, triangle);
  }
  return u + v <= 1.0 || i + j == FaceSegments - 1
    ? this->GetTriangle({ { low, right, up } }, triangle)
    : this->GetTriangle({ { right, high, up } }, triangle);
}

void FacePatch::AddPieces(const MapSegment& segment, std::vector<Piece>& pieces) const
{
  const MapPosition start = this->ToPattern(segment.Start);
  const MapPosition end = this->ToPattern(segment.End);
  const auto clip = [&](double tolerance)
  {
    SegmentRange range;
    for (int axis = 0; axis < 2; ++axis)
    {
      range.Clip(start[axis] + tolerance, end[axis] + tolerance);
      range.Clip(segment.Start[axis] + tolerance, segment.End[axis] + tolerance);
      const double last = this->LastSample[axis] + tolerance;
      range.Clip(last - segment.Start[axis], last - segment.End[axis]);
    }
    const double last = FaceSegments + tolerance;
    range.Clip(last - start[0] - start[1], last - end[0] - end[1]);
    return range;
  };
  SegmentRange range = clip(0.0);
  if (range.IsEmpty())
  {
    range = clip(EdgeTolerance);
  }
  if (range.IsEmpty())
  {
    return;
  }
  std::vector<double> parameters = { range.First, range.Last };
  range.AddCrossings(start[0], end[0], parameters);
  range.AddCrossings(start[1], end[1], parameters);
  range.AddCrossings(0.5 * (start[0] + start[1]), 0.5 * (end[0] + end[1]), parameters);
  range.AddCrossings(0.5 * (start[0] - start[1]), 0.5 * (end[0] - end[1]), parameters);
  std::sort(parameters.begin(), parameters.end());
  const double shortest = MapSegment::Tolerance / segment.GetLength();
  double first = parameters.front();
  for (double last : parameters)
  {
    if (last - first <= shortest)
    {
      continue;
    }
    SurfaceTriangle triangle;
    if (this->FindTriangle(this->ToPattern(segment.Get(0.5 * (first + last))), triangle))
    {
      const auto getPoint = [&](double t) { return GetSurfacePoint(triangle, segment.Get(t)); };
      pieces.push_back({ first, last, getPoint(first), getPoint(last) });
    }
    first = last;
  }
}

bool FacePatch::FindPoint(const MapPosition& position, SurfacePoint& point) const
{
  const MapPosition inPattern = this->ToPattern(position);
  const bool isInside = inPattern[0] >= -EdgeTolerance && inPattern[1] >= -EdgeTolerance &&
    inPattern[0] + inPattern[1] <= FaceSegments + EdgeTolerance &&
    std::min(position[0], position[1]) >= -EdgeTolerance &&
    position[0] <= this->LastSample[0] + EdgeTolerance &&
    position[1] <= this->LastSample[1] + EdgeTolerance;
  SurfaceTriangle triangle;
  if (!isInside || !this->FindTriangle(inPattern, triangle))
  {
    return false;
  }
  point = GetSurfacePoint(triangle, position);
  return true;
}

void FacePatch::VisitTriangles(const MapBox& box, const TriangleVisitor& visitor) const
{
  constexpr int side = FaceSegments + 1;
  std::array<SurfaceVertex, side * side> grid;
  for (int b = 0; b < side; ++b)
  {
    for (int a = 0; a + b < side; ++a)
    {
      grid[b * side + a] = this->GetVertex({ { a, b } });
    }
  }
  for (const TerrainFace::PatternTriangle& vertices : TerrainFace::GetPattern())
  {
    SurfaceTriangle triangle;
    MapBox bounds;
    bool isMissing = false;
    for (int i = 0; i < 3; ++i)
    {
      triangle[i] = grid[vertices[i][1] * side + vertices[i][0]];
      bounds.Add(triangle[i].Position);
      isMissing = isMissing || std::isnan(triangle[i].Height);
    }
    if (!isMissing && bounds.Overlaps(box) && !visitor(triangle))
    {
      return;
    }
  }
}
}
