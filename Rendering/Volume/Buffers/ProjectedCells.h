// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProjectedCells
 * @brief   the corners of tetrahedra on the GPU, and the order in which they are drawn
 *
 * Private to the module.
 */
#ifndef ProjectedCells_h
#define ProjectedCells_h

#include "Buffers/BufferTexture.h"
#include "Mesh/VisibilityOrder.h"

namespace relevo
{
struct RayCastMesh;

class ProjectedCells
{
public:
  /// A mesh of tetrahedra with corners. false when it does not fit into this OpenGL's buffer
  /// textures.
  bool Upload(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh);

  /// From back to front as seen from an eye, as of VisibilityOrder, in the mesh's coordinates.
  bool Sort(vtkOpenGLRenderWindow* window, const dvec4& eye);

  bool HasOrder() const { return this->Eye != dvec4(0.0); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  int GetNumberOfCells() const { return this->NumberOfCells; }
  vtkTypeInt64 GetMemorySize() const
  {
    return this->Corners.GetMemorySize() + this->Order.GetMemorySize();
  }

private:
  BufferTexture Corners;
  BufferTexture Order;
  VisibilityOrder Visibility;
  int NumberOfCells = 0;
  dvec4 Eye = dvec4(0.0); // of the last order; 0 for none
};
}

#endif
