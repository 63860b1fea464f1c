// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementInstances
 * @brief   which faces are drawn, and how their patterns lie on them, on the GPU
 *
 * Each of several views has a slot, from 0 on; the one made or uploaded last is drawn.
 * Private to the module.
 */
#ifndef RefinementInstances_h
#define RefinementInstances_h

#include "Buffers/BufferTexture.h"           // for members
#include "RelevoRenderingRefinementModule.h" // for export macro

#include <map>    // for members
#include <vector> // for instances

namespace relevo
{
class ViewSelection;

class RELEVORENDERINGREFINEMENT_EXPORT RefinementInstances
{
public:
  /**
   * Upload what has changed of a selection. False when the GPU cannot hold it, here and below.
   */
  bool Upload(vtkOpenGLRenderWindow* window, int slot, const ViewSelection& selection);

  /**
   * Upload instances (face << 3 | permutation code) that were made at `time`, if that is new.
   */
  bool Upload(vtkOpenGLRenderWindow* window, int slot, const std::vector<unsigned int>& instances,
    vtkMTimeType time);

  /**
   * Make room for a selection of this number of faces, which compute shaders fill in.
   */
  bool Reserve(vtkOpenGLRenderWindow* window, int slot, size_t faces, bool morphing);

  //@{
  /// OpenGL's names of the buffers to draw; 0 for none.
  unsigned int GetInstances() const { return this->Current->Instances.GetHandle(); }
  unsigned int GetMorphTags() const { return this->Current->MorphTags.GetHandle(); }
  //@}

  /// Whether vertices of the selection to draw slide with the tags of the edges.
  bool IsMorphing() const { return this->Current && !this->Current->MorphTags.IsEmpty(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Slot
  {
    BufferTexture Instances;
    BufferTexture MorphTags;
    vtkMTimeType LevelsTime = 0;
    vtkMTimeType GroupsTime = 0;
  };
  std::map<int, Slot> Slots;
  Slot* Current = nullptr;
};
}

#endif
