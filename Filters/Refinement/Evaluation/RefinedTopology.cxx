// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/RefinedTopology.h"

#include "Evaluation/PatternSelection.h"
#include "Patterns/RefinementPattern.h"

namespace relevo
{
namespace
{
// Where a pattern's corners and edges come to lie under a permutation code.
struct Placement
{
  explicit Placement(int code)
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

const Placement& GetPlacement(int code)
{
  static const Placement placements[6] = { Placement(0), Placement(1), Placement(2), Placement(3),
    Placement(4), Placement(5) };
  return placements[code];
}
}

RefinedTopology::RefinedTopology(RefinementMesh& mesh, const PatternSelection& selection,
  vtkRefinementSurface* surface, vtkIdType numberOfInputPoints)
  : Splits(mesh, surface, numberOfInputPoints)
  , FirstInnerPoints(mesh.Faces.size())
  , FirstEdgePoints(Splits.EdgeOwners.size())
  , PointOwners(static_cast<size_t>(numberOfInputPoints + Splits.NumberOfCopies), -1)
{
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
    for (int i = 0; i < 3; ++i)
    {
      int& owner = this->PointOwners[this->GetCorner(face, i)];
      owner = owner < 0 ? face : owner;
    }
  }
  this->NumberOfPoints = next;
}

RefinedTopology::Edge RefinedTopology::GetEdge(int face, int patternEdge) const
{
  const FacePattern& pattern = this->Patterns[face];
  const Placement& placement = GetPlacement(pattern.Code);
  const size_t faceEdge = 3 * static_cast<size_t>(face) + placement.Edges[patternEdge];
  const int id = this->Splits.FaceEdges[faceEdge];
  return { id, this->Splits.EdgeOwners[id] == static_cast<int>(faceEdge),
    placement.Forward[patternEdge], pattern.Pattern->Segments[patternEdge] };
}

void RefinedTopology::GetPoints(int face, std::vector<vtkIdType>& points) const
{
  const RefinementPattern& pattern = *this->Patterns[face].Pattern;
  points.resize(static_cast<size_t>(pattern.GetNumberOfVertices()));
  const int* corners = GetPlacement(this->Patterns[face].Code).Corners;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = this->GetCorner(face, corners[i]);
  }
  size_t vertex = 3;
  for (int i = 0; i < 3; ++i)
  {
    const Edge edge = this->GetEdge(face, i);
    const int inner = edge.Segments - 1;
    const vtkIdType first = this->FirstEdgePoints[edge.Id];
    for (int k = 0; k < inner; ++k)
    {
      points[vertex++] = first + (edge.Forward ? k : inner - 1 - k);
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
    this->Patterns[face].GetWeights(vertex, point.Weights);
    points.push_back(point);
  };
  const int* corners = GetPlacement(code).Corners;
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType corner = this->GetCorner(face, corners[i]);
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
