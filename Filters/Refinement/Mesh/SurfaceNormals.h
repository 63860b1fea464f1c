// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceNormals
 * @brief   the normals of a mesh's triangles, and of its places
 *
 * In the mesh's coordinates: an actor's matrix takes area vectors to the world by its cofactors,
 * see Placement::GetNormal().
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
  /// Per triangle its normal, twice as long as its area.
  const std::vector<dvec3>& GetAreaVectors() const { return this->AreaVectors; }
  /// The sum of the area vectors of the triangles at a place.
  dvec3 GetAreaVectorAt(vtkIdType mergedPoint) const;

private:
  std::shared_ptr<const SurfaceTriangles> Triangles;
  std::vector<dvec3> AreaVectors;
};
}

#endif
