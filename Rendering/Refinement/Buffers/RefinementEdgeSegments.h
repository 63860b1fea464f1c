// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementEdgeSegments
 * @brief   the number of segments of each face's edges, on the GPU
 *
 * Methods without patterns use it. Each of several views has a slot, counted from 0; the slot that
 * was uploaded last is drawn. Private to the module.
 */
#ifndef RefinementEdgeSegments_h
#define RefinementEdgeSegments_h

#include "Buffers/BufferTexture.h" // for members

#include <map> // for members

namespace relevo
{
class RefinementMesh;
class ViewSelection;

class RefinementEdgeSegments
{
public:
  /**
   * Upload the numbers of a selection, if they are new. Return false if the GPU cannot hold them.
   */
  bool Upload(vtkOpenGLRenderWindow* window, int slot, const RefinementMesh& mesh,
    const ViewSelection& selection);

  /**
   * Bind the numbers to a shader's usamplerBuffer relevoEdgeSegments: one texel per face, n01 | n12
   * << 8 | n02 << 16 | turned << 24 for the segments of the sorted edges; turned is 1 if the order
   * of the sorted corners is opposite to the cell's orientation.
   */
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Slot
  {
    BufferTexture Segments;
    vtkMTimeType LevelsTime = 0;
  };
  std::map<int, Slot> Slots;
  Slot* Current = nullptr;
};
}

#endif
