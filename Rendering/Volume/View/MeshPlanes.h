// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshPlanes
 * @brief   a mapper's clipping planes as the rays of a mesh see them
 *
 * Computed in double precision relative to the mesh, which may lie anywhere. Private to the module.
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

  /// Null for none. Of more planes than there can be, the first ones; then false.
  bool Compute(vtkPlaneCollection* planes, const dmat4& meshToWorld);

  bool IsEmpty() const { return this->Planes.empty(); }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  std::vector<float> Planes; // 4 each
};
}

#endif
