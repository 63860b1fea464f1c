// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceEdges
 * @brief   the edges of the triangles of a mesh, and point tags computed from edge tags
 *
 * An edge is a pair of merged points that at least one triangle joins. Edges are sorted by their
 * merged points, so that an edge is found in logarithmic time.
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
/// Two triangles that share an edge, or the one triangle at an open edge.
struct SurfaceEdgeSides
{
  enum Types : unsigned char
  {
    INNER,   // exactly two triangles with the same winding
    FLIPPED, // exactly two triangles with opposite winding
    OPEN     // one triangle, or more than two: one item for each consecutive pair
  };

  /// The edge's index.
  int Edge;
  /// Indices of the triangles; -1 for none.
  int Triangles[2];
  Types Type;
};

class RELEVOFILTERSCORE_EXPORT SurfaceEdges
{
public:
  /// The two merged points of an edge, the lower id first.
  struct Edge
  {
    int MergedPoints[2];
  };

  explicit SurfaceEdges(std::shared_ptr<const SurfaceTriangles> triangles);
  explicit SurfaceEdges(vtkPolyData* mesh);

  const SurfaceTriangles& GetTriangles() const { return *this->Triangles; }

  int GetNumberOfEdges() const { return static_cast<int>(this->Edges.size()); }
  /// All edges, sorted by their merged points.
  const std::vector<Edge>& GetEdges() const { return this->Edges; }
  /// The index of the edge between two merged points in any order, or -1 if there is none.
  int FindEdge(vtkIdType a, vtkIdType b) const;

  /// The triangles at the edges, in the order of edges. Edges of one or two triangles have one
  /// item.
  const std::vector<SurfaceEdgeSides>& GetSides() const { return this->Sides; }
  /// Call f(i) for the index of each item of the edge in GetSides().
  template <typename Function>
  void ForEachSides(int edge, Function&& f) const
  {
    for (int i = this->FirstSides[edge]; i < this->FirstSides[edge + 1]; ++i)
    {
      f(i);
    }
  }

  /// Give each point the largest tag of the edges at its merged point, or 0 if there are none.
  void TagPoints(const float* edgeTags, vtkFloatArray* tags) const;

private:
  void BuildEdges();
  void BuildUses();

  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::vector<Edge> Edges;
  std::vector<int> FirstEdges; // per merged point, index of the first edge whose lower end it is
  std::vector<SurfaceEdgeSides> Sides;
  std::vector<int> FirstSides; // index of the first item per edge
  std::vector<int> Starts;     // index into Uses per merged point
  std::vector<int> Uses;       // indices of edges
};

/// Set the tag of each edge to f(i), where i is its index. f is called in parallel.
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
