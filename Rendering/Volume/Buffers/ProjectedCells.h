// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProjectedCells
 * @brief   the corners of tetrahedra on the GPU, and their visibility order
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
  /// Upload a mesh of tetrahedra with corners. Return false if it does not fit into the buffer
  /// textures of this OpenGL.
  bool Upload(vtkOpenGLRenderWindow* window, const RayCastMesh& mesh);

  /// Sort the cells from back to front for an eye in the mesh's coordinates, as in VisibilityOrder.
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
  dvec4 Eye = dvec4(0.0); // eye of the last order; 0 for none
};
}

#endif
