// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshPlanes
 * @brief   a mapper's clipping planes in the coordinates of a mesh
 *
 * They are computed in double precision relative to the mesh, which may be far from the origin.
 * Private to the module.
 */
#ifndef MeshPlanes_h
#define MeshPlanes_h

#include "Mathematics/RefinementMathematics.h"

#include <vector>

class vtkPlaneCollection;
class vtkShaderProgram;

namespace relevo
{
class MeshPlanes
{
public:
  static constexpr int MaximumPlanes = 32;

  /// Compute the planes; nullptr has none. If there are too many, use the first ones and return
  /// false.
  bool Compute(vtkPlaneCollection* planes, const dmat4& meshToWorld);

  bool IsEmpty() const { return this->Planes.empty(); }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  std::vector<float> Planes; // 4 each
};
}

#endif
