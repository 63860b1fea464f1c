// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedTopology
 * @brief   how the patterns of a mesh's faces share points
 *
 * Numbers the points of a refined mesh: the input's points, then the points inside each edge, then
 * those inside each face, then copies of the former for faces that see other normals there. Edges
 * are shared as the input shares points; where points coincide without being shared, so do the
 * edges. Every point but a copy is evaluated by one face, its owner.
 */
#ifndef RefinedTopology_h
#define RefinedTopology_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/FacePattern.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace relevo
{
struct SplitPoints;
class PatternSelection;

/// A refined point on a face, with the weights of the face's sorted corners.
struct RefinedPoint
{
  vtkIdType Id;
  float Weights[3];
  vtkIdType Original; // the id before unused points are left out

  /// The sorted corner that weighs most.
  int GetNearestCorner() const
  {
    const int first = this->Weights[1] > this->Weights[0] ? 1 : 0;
    return this->Weights[2] > this->Weights[first] ? 2 : first;
  }
};

class RefinedTopology
{
public:
  /// Builds the mesh's edges. The mesh must outlive the topology.
  RefinedTopology(
    RefinementMesh& mesh, const PatternSelection& selection, vtkIdType numberOfInputPoints);

  /// Give faces points of their own where they see other normals than the owner.
  void Split(const SplitPoints& splits);

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  int GetNumberOfFaces() const { return static_cast<int>(this->Patterns.size()); }
  const FacePattern& GetPattern(int face) const { return this->Patterns[face]; }
  /// Whether a face has this point of the input as a corner.
  bool IsCorner(vtkIdType inputPoint) const { return this->PointOwners[inputPoint] >= 0; }

  //@{
  /// Of an edge of a face (3 * face + edge): the number of points inside it; of an edge of the
  /// mesh: the point that is `step` (1 and on) from its first end.
  int GetNumberOfInnerPoints(int faceEdge) const;
  vtkIdType GetEdgePoint(int edge, int step) const
  {
    return this->FirstEdgePoints[static_cast<size_t>(edge)] + step - 1;
  }
  //@}
  /// Weights at step 0, a face's sorted corner, or another step of its edge: 3 * face + corner or
  /// edge.
  void GetWeights(int use, int step, float weights[3]) const;

  /// A point that lies where another one does, with another normal.
  struct PointCopy
  {
    vtkIdType Original;
    vec3 Normal;
  };
  /// Those of the points from GetFirstCopy() on.
  const std::vector<PointCopy>& GetCopies() const { return this->Copies; }
  vtkIdType GetFirstCopy() const
  {
    return this->NumberOfPoints - static_cast<vtkIdType>(this->Copies.size());
  }

  /// The points of all pattern vertices of a face.
  void GetPoints(int face, std::vector<vtkIdType>& points) const;

  /// The points that this face is the owner of, corners first.
  void GetOwnedPoints(int face, std::vector<RefinedPoint>& points) const;

private:
  /// One of the pattern's edges on a face, from the pattern's corner i to i + 1.
  struct Edge
  {
    int Use; // 3 * face + sorted edge
    int Id;
    bool IsOwned; // by the face
    bool Forward;
    int Segments;
  };
  Edge GetEdge(int face, int patternEdge) const;
  /// The point that a face has at a step of a corner or an edge, see GetWeights().
  vtkIdType GetPoint(int use, int step) const;
  vtkIdType GetCorner(int face, int sortedCorner) const
  {
    const size_t use = 3 * static_cast<size_t>(face) + sortedCorner;
    return this->CornerCopies.empty() || this->CornerCopies[use] < 0
      ? this->Mesh.Faces[face].Corners[sortedCorner]
      : this->CornerCopies[use];
  }

  const RefinementMesh& Mesh;
  std::vector<FacePattern> Patterns;
  std::vector<vtkIdType> FirstInnerPoints;
  std::vector<vtkIdType> FirstEdgePoints;
  std::vector<int> PointOwners; // of the input's points
  std::vector<int> EdgeOwners;  // as those of the mesh

  std::vector<PointCopy> Copies;
  std::vector<vtkIdType> CornerCopies;    // by use, -1 for none; empty without copies
  std::vector<vtkIdType> FirstEdgeCopies; // by use, into EdgeCopies; the same
  std::vector<vtkIdType> EdgeCopies;      // the points inside an edge, copies or not

  vtkIdType NumberOfPoints = 0;
};
}

#endif
