// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  NormalSplits
 * @brief   points and edges of a mesh, apart where the surface gives faces different normals
 *
 * A surface may give the faces around a point or an edge normals of their own: a crease. Faces that
 * see the same normals share what they see; others have copies.
 *
 * Private to the module's own sources.
 */
#ifndef NormalSplits_h
#define NormalSplits_h

#include "vtkType.h"

#include <vector>

class vtkRefinementSurface;

namespace relevo
{
class RefinementMesh;

struct NormalSplits
{
  /// The surface may be nullptr. Builds the mesh's edges.
  NormalSplits(RefinementMesh& mesh, vtkRefinementSurface* surface, vtkIdType numberOfPoints);

  /// As those of the mesh, with more edges where they come apart.
  std::vector<int> FaceEdges;
  std::vector<int> EdgeOwners;

  /// For each face the points of its sorted corners; from the given number of points on, copies.
  std::vector<vtkIdType> FaceCorners;
  vtkIdType NumberOfCopies = 0;

private:
  void SplitCorners(const RefinementMesh& mesh, vtkRefinementSurface* surface,
    const std::vector<char>& isSplit, vtkIdType numberOfPoints);
  void SplitEdges(
    const RefinementMesh& mesh, vtkRefinementSurface* surface, const std::vector<char>& isSplit);
};
}

#endif
