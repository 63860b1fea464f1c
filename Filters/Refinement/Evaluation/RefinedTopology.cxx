// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/RefinedTopology.h"

#include "Evaluation/PatternSelection.h"
#include "Evaluation/SplitPoints.h"
#include "Patterns/RefinementPattern.h"

#include <algorithm>

namespace relevo
{
namespace
{
// The positions of a pattern's corners and edges under a permutation code.
struct EdgePlacement
{
  explicit EdgePlacement(int code)
  {
    const auto& order = GetCornerOrder(code);
    for (int i = 0; i < 3; ++i)
    {
      this->Corners[order[i]] = i;
    }
    for (int i = 0; i < 3; ++i)
    {
      const int from = this->Corners[i];
      const int to = this->Corners[(i + 1) % 3];
      // Sorted corners 0 1 make edge 0, 1 2 make edge 1, 0 2 make edge 2.
      this->Edges[i] = from + to == 1 ? 0 : (from + to == 3 ? 1 : 2);
      this->Forward[i] = from < to;
    }
  }

  int Corners[3]; // sorted corners
  int Edges[3];   // sorted edges
  bool Forward[3];
};

const EdgePlacement& GetEdgePlacement(int code)
{
  static const EdgePlacement placements[6] = { EdgePlacement(0), EdgePlacement(1), EdgePlacement(2),
    EdgePlacement(3), EdgePlacement(4), EdgePlacement(5) };
  return placements[code];
}
}

RefinedTopology::RefinedTopology(
  RefinementMesh& mesh, const PatternSelection& selection, vtkIdType numberOfInputPoints)
  : Mesh(mesh)
  , FirstInnerPoints(mesh.Faces.size())
  , PointOwners(static_cast<size_t>(numberOfInputPoints), -1)
{
  mesh.BuildEdges();
  this->EdgeOwners = mesh.EdgeOwners;
  this->FirstEdgePoints.resize(mesh.EdgeOwners.size());
  this->Patterns.reserve(mesh.Faces.size());
  for (int face = 0; face < selection.GetNumberOfFaces(); ++face)
  {
    this->Patterns.push_back(selection.GetFacePattern(face));
  }

  vtkIdType next = static_cast<vtkIdType>(this->PointOwners.size());
  const int numberOfFaces = this->GetNumberOfFaces();
  for (int face = 0; face < numberOfFaces; ++face)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = this->GetEdge(face, i);
      if (edge.IsOwned)
      {
        this->FirstEdgePoints[edge.Id] = next;
        next += edge.Segments - 1;
      }
    }
  }
  for (int face = 0; face < numberOfFaces; ++face)
  {
    const RefinementPattern& pattern = *this->Patterns[face].Pattern;
    this->FirstInnerPoints[face] = next;
    next += pattern.GetNumberOfVertices() - pattern.GetNumberOfBorderVertices();
    for (int corner : mesh.Faces[face].Corners)
    {
      int& owner = this->PointOwners[corner];
      owner = owner < 0 ? face : owner;
    }
  }
  this->NumberOfPoints = next;
}

void RefinedTopology::Split(const SplitPoints& splits)
{
  for (const SplitPoints::Owner& owner : splits.PointOwners)
  {
    this->PointOwners[owner.Element] = owner.Use / 3;
  }
  for (const SplitPoints::Owner& owner : splits.EdgeOwners)
  {
    this->EdgeOwners[owner.Element] = owner.Use;
  }
  const std::vector<SplitPoints::Copy>& seen = splits.Copies;
  if (seen.empty())
  {
    return;
  }
  this->CornerCopies.assign(3 * this->Patterns.size(), -1);
  this->FirstEdgeCopies.assign(3 * this->Patterns.size(), -1);
  auto first = seen.begin(); // first copy at the current point
  for (auto copy = first; copy != seen.end(); ++copy)
  {
    first = copy->Point == first->Point ? first : copy;
    const size_t use = static_cast<size_t>(copy->Use);
    // A previous face may have the same normal here.
    const auto same = std::find_if(
      first, copy, [&](const SplitPoints::Copy& other) { return other.Normal == copy->Normal; });
    vtkIdType id = this->NumberOfPoints;
    if (same != copy)
    {
      id = this->GetPoint(same->Use, same->Step);
    }
    else
    {
      this->Copies.push_back({ copy->Point, copy->Normal });
      ++this->NumberOfPoints;
    }
    if (copy->Step == 0)
    {
      this->CornerCopies[use] = id;
      continue;
    }
    vtkIdType& firstInEdge = this->FirstEdgeCopies[use];
    if (firstInEdge < 0)
    {
      firstInEdge = static_cast<vtkIdType>(this->EdgeCopies.size());
      for (int step = 1; step <= this->GetNumberOfInnerPoints(copy->Use); ++step)
      {
        this->EdgeCopies.push_back(this->GetEdgePoint(this->Mesh.FaceEdges[use], step));
      }
    }
    this->EdgeCopies[static_cast<size_t>(firstInEdge + copy->Step - 1)] = id;
  }
}

vtkIdType RefinedTopology::GetPoint(int use, int step) const
{
  if (step == 0)
  {
    return this->GetCorner(use / 3, use % 3);
  }
  const vtkIdType copies =
    this->FirstEdgeCopies.empty() ? -1 : this->FirstEdgeCopies[static_cast<size_t>(use)];
  return copies < 0 ? this->GetEdgePoint(this->Mesh.FaceEdges[static_cast<size_t>(use)], step)
                    : this->EdgeCopies[static_cast<size_t>(copies + step - 1)];
}

int RefinedTopology::GetNumberOfInnerPoints(int faceEdge) const
{
  int segments[3];
  this->Patterns[faceEdge / 3].GetEdgeSegments(segments);
  return segments[faceEdge % 3] - 1;
}

void RefinedTopology::GetWeights(int use, int step, float weights[3]) const
{
  const int face = use / 3;
  const FacePattern& pattern = this->Patterns[face];
  if (step == 0)
  {
    for (int i = 0; i < 3; ++i)
    {
      weights[i] = i == use % 3 ? 1.0f : 0.0f;
    }
    return;
  }
  int vertex = 3;
  for (int i = 0; i < 3; ++i)
  {
    const Edge edge = this->GetEdge(face, i);
    if (edge.Use == use)
    {
      pattern.GetWeights(vertex + (edge.Forward ? step - 1 : edge.Segments - 1 - step), weights);
      return;
    }
    vertex += edge.Segments - 1;
  }
}

RefinedTopology::Edge RefinedTopology::GetEdge(int face, int patternEdge) const
{
  const FacePattern& pattern = this->Patterns[face];
  const EdgePlacement& placement = GetEdgePlacement(pattern.Code);
  const int use = 3 * face + placement.Edges[patternEdge];
  const int id = this->Mesh.FaceEdges[static_cast<size_t>(use)];
  return { use, id, this->EdgeOwners[id] == use, placement.Forward[patternEdge],
    pattern.Pattern->Segments[patternEdge] };
}

void RefinedTopology::GetPoints(int face, std::vector<vtkIdType>& points) const
{
  const RefinementPattern& pattern = *this->Patterns[face].Pattern;
  points.resize(static_cast<size_t>(pattern.GetNumberOfVertices()));
  const int* corners = GetEdgePlacement(this->Patterns[face].Code).Corners;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = this->GetCorner(face, corners[i]);
  }
  size_t vertex = 3;
  for (int i = 0; i < 3; ++i)
  {
    const Edge edge = this->GetEdge(face, i);
    for (int step = 1; step < edge.Segments; ++step)
    {
      points[vertex++] = this->GetPoint(edge.Use, edge.Forward ? step : edge.Segments - step);
    }
  }
  for (vtkIdType next = this->FirstInnerPoints[face]; vertex < points.size(); ++vertex)
  {
    points[vertex] = next++;
  }
}

void RefinedTopology::GetOwnedPoints(int face, std::vector<RefinedPoint>& points) const
{
  points.clear();
  const RefinementPattern& pattern = *this->Patterns[face].Pattern;
  const int code = this->Patterns[face].Code;
  auto add = [&](vtkIdType id, int vertex)
  {
    RefinedPoint point;
    point.Id = id;
    point.Original = id;
    this->Patterns[face].GetWeights(vertex, point.Weights);
    points.push_back(point);
  };
  const int* corners = GetEdgePlacement(code).Corners;
  for (int i = 0; i < 3; ++i)
  {
    const int corner = this->Mesh.Faces[face].Corners[corners[i]];
    if (this->PointOwners[corner] == face)
    {
      add(corner, i);
    }
  }
  int vertex = 3;
  for (int i = 0; i < 3; ++i)
  {
    const Edge edge = this->GetEdge(face, i);
    const int inner = edge.Segments - 1;
    if (edge.IsOwned)
    {
      for (int k = 0; k < inner; ++k)
      {
        add(this->FirstEdgePoints[edge.Id] + (edge.Forward ? k : inner - 1 - k), vertex + k);
      }
    }
    vertex += inner;
  }
  for (vtkIdType next = this->FirstInnerPoints[face]; vertex < pattern.GetNumberOfVertices();
       ++vertex)
  {
    add(next++, vertex);
  }
}
}
