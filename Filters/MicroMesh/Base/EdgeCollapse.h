// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EdgeCollapse
 * @brief   simplifies a dense mesh to a coarse mesh of some of its vertices
 *
 * A step moves a vertex along an edge to a neighbour, in the order of quadric errors. Each coarse
 * vertex represents a cluster of vertices of the dense mesh. A step is legal if the surface stays a
 * manifold, if no triangle turns over or becomes a sliver, if triangles face the mean normals of
 * the clusters at their corners, and if the size of the cluster is within the limits of all its
 * vertices. Vertices on lines move along their line, and all vertices of the line stay within the
 * tolerance of the coarse edges.
 *
 * The order of steps does not depend on threads.
 */
#ifndef EdgeCollapse_h
#define EdgeCollapse_h

#include "Base/AreaQuadric.h"
#include "Dense/DenseMesh.h"

#include <functional> // for progress
#include <queue>      // for members
#include <utility>    // for std::pair
#include <vector>     // for members

namespace relevo
{
class EdgeCollapse
{
public:
  using Triangle = DenseMesh::Triangle;

  /// `limits` are the largest sizes of the clusters of each vertex.
  EdgeCollapse(const DenseMesh& mesh, const std::vector<int>& limits, double lineTolerance);

  /// A step moves the first vertex to the second.
  using Moves = std::vector<std::pair<int, int>>;

  /// Repeat the steps of another simplification of the mesh, except those that the limits forbid
  /// and those that depend on them. Much faster than Run(), which can continue then.
  void Repeat(const Moves& moves);

  /// Simplify until the mesh has `target` triangles or the next step has an error above `error`,
  /// which becomes the largest error of the steps. `goOn(share)` is called from time to time and
  /// returns false to stop. Returns whether it did not stop.
  bool Run(std::size_t target, double& error, const std::function<bool(double)>& goOn);

  /// All steps, in their order.
  const Moves& GetMoves() const { return this->Done; }

  /// Whether a triangle of the dense mesh is left. Its corners and wedges are then those of the
  /// coarse mesh.
  bool IsLeft(std::size_t triangle) const { return this->AreLeft[triangle] != 0; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  Triangle GetWedges(std::size_t triangle) const
  {
    return this->Wedges.empty() ? this->Mesh.GetWedges(this->Triangles[triangle])
                                : this->Wedges[triangle];
  }

  /// Whether a vertex never moves.
  bool IsKept(int vertex) const
  {
    const auto v = static_cast<std::size_t>(vertex);
    return this->Mesh.Kinds[v] == DenseMesh::Kind::LOCKED || this->AreKept[v] != 0;
  }

  /// The coarse vertex of a vertex.
  int FindRoot(int vertex);
  int GetClusterSize(int root) const { return this->Sizes[static_cast<std::size_t>(root)]; }
  /// The sum of the normals of a cluster's triangles.
  const vec3& GetNormal(int root) const { return this->Normals[static_cast<std::size_t>(root)]; }
  int GetNumberOfTriangles(int root) const;
  /// The flags of the line between two coarse vertices; 0 for none.
  unsigned char GetLineFlags(int a, int b) const;

  /// Free all memory except that of FindRoot() and GetClusterSize().
  void FreeMesh();

private:
  struct Step
  {
    float Error;
    int Vertex;
    int Stamp;

    bool operator<(const Step& other) const // the largest of std::priority_queue is next
    {
      return this->Error != other.Error ? this->Error > other.Error : this->Vertex > other.Vertex;
    }
  };

  // Corners are 3 * triangle + corner. Calls f(triangle, corner) for those of a vertex.
  template <typename Function>
  void ForEachUse(int vertex, const Function& f) const
  {
    for (int use = this->FirstUses[static_cast<std::size_t>(vertex)]; use >= 0;
         use = this->NextUses[static_cast<std::size_t>(use)])
    {
      f(static_cast<std::size_t>(use / 3), use % 3);
    }
  }
  void AddUse(int vertex, int use)
  {
    int& first = this->FirstUses[static_cast<std::size_t>(vertex)];
    this->NextUses[static_cast<std::size_t>(use)] = first;
    first = use;
  }
  void RemoveUse(int vertex, int use);
  void FindNeighbours(int vertex, std::vector<int>& neighbours);
  double GetError(int from, int to) const;
  double GetLeastError(int vertex) const;
  bool CanMove(int vertex) const;
  bool HasSize(int from, int to) const;
  void Evaluate(int vertex);
  bool IsLegal(int from, int to);
  bool HasSimpleLink(int from, int to);
  bool KeepsShape(int from, int to) const;
  bool KeepsLine(int from, int to) const;
  bool IsLineWithin(int vertex, int a, int b) const;
  bool MapWedges(int from, int to);
  void Collapse(int from, int to);
  void JoinLines(int from, int to);

  const DenseMesh& Mesh;
  double LineTolerance2;
  std::vector<char> AreKept; // per vertex, by its line
  std::vector<Triangle> Triangles;
  std::vector<Triangle> Wedges; // empty if the dense mesh has none
  std::vector<char> AreLeft;
  std::size_t NumberLeft = 0;
  std::vector<int> NextUses; // per corner, the next one of the same vertex, or -1
  // Per vertex:
  std::vector<int> FirstUses;        // corners
  std::vector<AreaQuadric> Quadrics; // relative to the vertex
  std::vector<vec3> Normals;
  std::vector<int> Roots;
  std::vector<int> Sizes;
  std::vector<int> Limits;
  std::vector<int> Targets; // the neighbour of the best step
  std::vector<int> Stamps;
  std::vector<char> AreQueued;
  std::vector<int> Marks; // of the last search for neighbours
  LineTable LineEnds;

  Moves Done;
  std::priority_queue<Step> Steps;
  int Mark = 0;
  std::vector<int> Neighbours; // scratch
  std::vector<std::pair<double, int>> Candidates;
  std::vector<std::pair<int, int>> WedgeMap; // from the wedges of a vertex to those of another
};
}

#endif
