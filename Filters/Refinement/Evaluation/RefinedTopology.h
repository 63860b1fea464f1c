// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedTopology
 * @brief   how the patterns of a mesh's faces share points
 *
 * Numbers the points of a refined mesh: the input's points, copies of them for faces that see other
 * normals there, then the points inside each edge, then those inside each face. Edges are shared as
 * the input shares points and as faces see the same normals; where points coincide without being
 * shared, so do the edges. Every point is evaluated by one face, its owner.
 *
 * Private to the module's own sources.
 */
#ifndef RefinedTopology_h
#define RefinedTopology_h

#include "Mesh/NormalSplits.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/FacePattern.h"
#include "vtkType.h"

#include <vector>

namespace relevo
{
class PatternSelection;

/// A refined point on a face, with the weights of the face's sorted corners.
struct RefinedPoint
{
  vtkIdType Id;
  float Weights[3];

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
  /// The surface may be nullptr.
  RefinedTopology(RefinementMesh& mesh, const PatternSelection& selection,
    vtkRefinementSurface* surface, vtkIdType numberOfInputPoints);

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  int GetNumberOfFaces() const { return static_cast<int>(this->Patterns.size()); }
  const FacePattern& GetPattern(int face) const { return this->Patterns[face]; }
  /// Whether a face has this point of the input as a corner.
  bool IsCorner(vtkIdType inputPoint) const { return this->PointOwners[inputPoint] >= 0; }

  /// The points of all pattern vertices of a face.
  void GetPoints(int face, std::vector<vtkIdType>& points) const;

  /// The points that this face is the owner of, corners first.
  void GetOwnedPoints(int face, std::vector<RefinedPoint>& points) const;

private:
  /// One of the pattern's edges on a face, from the pattern's corner i to i + 1.
  struct Edge
  {
    int Id;
    bool IsOwned; // by the face
    bool Forward;
    int Segments;
  };
  Edge GetEdge(int face, int patternEdge) const;
  vtkIdType GetCorner(int face, int sortedCorner) const
  {
    return this->Splits.FaceCorners[3 * static_cast<size_t>(face) + sortedCorner];
  }

  const NormalSplits Splits;
  std::vector<FacePattern> Patterns;
  std::vector<vtkIdType> FirstInnerPoints;
  std::vector<vtkIdType> FirstEdgePoints;
  std::vector<int> PointOwners; // of the input's points and their copies
  vtkIdType NumberOfPoints = 0;
};
}

#endif
