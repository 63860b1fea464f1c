// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceEdges
 * @brief   the edges of a mesh's triangles, and tags of points from tags of edges
 *
 * An edge is a pair of places that at least one triangle joins. Edges are counted from 0, in the
 * order of their places, so that an edge is found in logarithmic time.
 */
#ifndef SurfaceEdges_h
#define SurfaceEdges_h

#include "Mesh/SurfaceTriangles.h"
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkFloatArray.h"           // for TagEdges
#include "vtkSMPTools.h"             // for TagEdges

#include <memory> // for members
#include <vector> // for members

class vtkPolyData;

namespace relevo
{
/// Two triangles that meet at an edge, or one that meets none.
struct SurfaceEdgeSides
{
  enum Types : unsigned char
  {
    INNER,   // of exactly two triangles that wind alike
    FLIPPED, // of exactly two triangles that wind against each other
    OPEN     // of one triangle, or of more than two: sides for every two that follow each other
  };

  /// The edge's index.
  int Edge;
  /// Indices of triangles; -1 for none.
  int Triangles[2];
  Types Type;
};

class RELEVOFILTERSCORE_EXPORT SurfaceEdges
{
public:
  /// The two places of an edge, the lower first.
  struct Edge
  {
    int MergedPoints[2];
  };

  explicit SurfaceEdges(std::shared_ptr<const SurfaceTriangles> triangles);
  explicit SurfaceEdges(vtkPolyData* mesh);

  const SurfaceTriangles& GetTriangles() const { return *this->Triangles; }

  int GetNumberOfEdges() const { return static_cast<int>(this->Edges.size()); }
  /// All edges, sorted by their places.
  const std::vector<Edge>& GetEdges() const { return this->Edges; }
  /// The index of the edge between two places in any order; -1 when there is none.
  int FindEdge(vtkIdType a, vtkIdType b) const;

  /// What meets at the edges, in their order: one item for an edge of one or two triangles.
  const std::vector<SurfaceEdgeSides>& GetSides() const { return this->Sides; }
  /// Calls f(i) for the index of each of the edge's items in GetSides().
  template <typename Function>
  void ForEachSides(int edge, Function&& f) const
  {
    for (int i = this->FirstSides[edge]; i < this->FirstSides[edge + 1]; ++i)
    {
      f(i);
    }
  }

  /// Give every point the largest of the tags of the edges at its place, and 0 where there is none.
  void TagPoints(const float* edgeTags, vtkFloatArray* tags) const;

private:
  void BuildEdges();
  void BuildUses();

  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::vector<Edge> Edges;
  std::vector<int> FirstEdges; // of those whose lower place it is, per place
  std::vector<SurfaceEdgeSides> Sides;
  std::vector<int> FirstSides; // per edge
  std::vector<int> Starts;     // into Uses, per place
  std::vector<int> Uses;       // edges
};

/// Give every edge the tag f(i) of its index. f is called in parallel.
template <typename Function>
void TagEdges(const SurfaceEdges& edges, vtkFloatArray* tags, Function&& f)
{
  const int numberOfEdges = edges.GetNumberOfEdges();
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(numberOfEdges);
  float* values = tags->GetPointer(0);
  vtkSMPTools::For(0, numberOfEdges,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int edge = static_cast<int>(begin); edge < end; ++edge)
      {
        values[edge] = f(edge);
      }
    });
  tags->Modified();
}
}

#endif
