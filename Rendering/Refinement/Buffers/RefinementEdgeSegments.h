// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementEdgeSegments
 * @brief   into how many segments each edge of each face is cut, on the GPU
 *
 * For methods that are not made of patterns. Of several views, each in a slot from 0 on; the one
 * that was uploaded last is drawn. Private to the module.
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
   * Upload those of a selection, if they are new. False when the GPU cannot hold them.
   */
  bool Upload(vtkOpenGLRenderWindow* window, int slot, const RefinementMesh& mesh,
    const ViewSelection& selection);

  /**
   * For a shader's usamplerBuffer relevoEdgeSegments: one texel per face, n01 | n12 << 8 |
   * n02 << 16 | turned << 24 for the segments of the sorted edges; turned is 1 where the sorted
   * corners run against the cell's sense.
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
