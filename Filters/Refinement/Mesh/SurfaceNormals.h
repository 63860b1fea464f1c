// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceNormals
 * @brief   the normals of a mesh's triangles and merged points
 *
 * Normals are in the mesh's coordinates. The cofactors of the actor's matrix transform area vectors
 * to world coordinates, see Placement::GetNormal().
 */
#ifndef SurfaceNormals_h
#define SurfaceNormals_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceTriangles.h"

#include <memory> // for members
#include <vector> // for members

namespace relevo
{
class SurfaceNormals
{
public:
  explicit SurfaceNormals(std::shared_ptr<const SurfaceTriangles> triangles);

  const SurfaceTriangles& GetTriangles() const { return *this->Triangles; }
  /// The normal of each triangle, with a length of twice its area.
  const std::vector<dvec3>& GetAreaVectors() const { return this->AreaVectors; }
  /// The sum of the area vectors of the triangles at a merged point.
  dvec3 GetAreaVectorAt(vtkIdType mergedPoint) const;

private:
  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::vector<dvec3> AreaVectors;
};
}

#endif
