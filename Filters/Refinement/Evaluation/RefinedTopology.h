// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedTopology
 * @brief   numbers the points of a refined mesh and shares them between faces
 *
 * The order is: the input's points, the points inside each edge, the points inside each face, then
 * copies for faces with other normals. Edges are shared if the input shares their points, not if
 * points only coincide. One face, the owner, evaluates each point that is not a copy.
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
  vtkIdType Original; // the id before unused points are removed

  /// The sorted corner with the largest weight.
  int GetNearestCorner() const
  {
    const int first = this->Weights[1] > this->Weights[0] ? 1 : 0;
    return this->Weights[2] > this->Weights[first] ? 2 : first;
  }
};

class RefinedTopology
{
public:
  /// Builds the edges of the mesh, which must outlive the topology.
  RefinedTopology(
    RefinementMesh& mesh, const PatternSelection& selection, vtkIdType numberOfInputPoints);

  /// Add copies of points for faces whose normals differ from the owner's.
  void Split(const SplitPoints& splits);

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  int GetNumberOfFaces() const { return static_cast<int>(this->Patterns.size()); }
  const FacePattern& GetPattern(int face) const { return this->Patterns[face]; }
  /// Whether this point of the input is a corner of a face.
  bool IsCorner(vtkIdType inputPoint) const { return this->PointOwners[inputPoint] >= 0; }

  //@{
  /// The number of points inside an edge of a face (3 * face + edge), and the point at `step`
  /// (from 1) from the first end of an edge of the mesh.
  int GetNumberOfInnerPoints(int faceEdge) const;
  vtkIdType GetEdgePoint(int edge, int step) const
  {
    return this->FirstEdgePoints[static_cast<size_t>(edge)] + step - 1;
  }
  //@}
  /// The weights at step 0, which is a sorted corner (3 * face + corner), or at a step of an edge
  /// (3 * face + edge).
  void GetWeights(int use, int step, float weights[3]) const;

  /// A point with the position of another point and a different normal.
  struct PointCopy
  {
    vtkIdType Original;
    vec3 Normal;
  };
  /// The points from GetFirstCopy() on.
  const std::vector<PointCopy>& GetCopies() const { return this->Copies; }
  vtkIdType GetFirstCopy() const
  {
    return this->NumberOfPoints - static_cast<vtkIdType>(this->Copies.size());
  }

  /// The points of all pattern vertices of a face.
  void GetPoints(int face, std::vector<vtkIdType>& points) const;

  /// The points that this face owns, corners first.
  void GetOwnedPoints(int face, std::vector<RefinedPoint>& points) const;

private:
  /// An edge of the pattern on a face, from corner i of the pattern to corner i + 1.
  struct Edge
  {
    int Use; // 3 * face + sorted edge
    int Id;
    bool IsOwned; // by the face
    bool Forward;
    int Segments;
  };
  Edge GetEdge(int face, int patternEdge) const;
  /// The point of a face at a step of a corner or an edge, see GetWeights().
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
  std::vector<int> PointOwners; // per input point
  std::vector<int> EdgeOwners;  // per edge of the mesh

  std::vector<PointCopy> Copies;
  std::vector<vtkIdType> CornerCopies; // by use, -1 for none; empty without copies
  std::vector<vtkIdType>
    FirstEdgeCopies;                 // by use, into EdgeCopies; -1 for none; empty without copies
  std::vector<vtkIdType> EdgeCopies; // all points inside an edge, copied or not

  vtkIdType NumberOfPoints = 0;
};
}

#endif
