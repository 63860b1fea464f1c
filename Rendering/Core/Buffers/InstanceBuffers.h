// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   InstanceBuffers
 * @brief   the faces to draw and the permutations of their patterns, on the GPU
 *
 * Each of several views has a slot, counted from 0. The slot that was allocated or uploaded last is
 * drawn. Private to the modules.
 */
#ifndef InstanceBuffers_h
#define InstanceBuffers_h

#include "Buffers/BufferTexture.h"     // for members
#include "RelevoRenderingCoreModule.h" // for export macro

#include <map>    // for members
#include <vector> // for instances

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT InstanceBuffers
{
public:
  /**
   * Upload instances (face << 3 | permutation code) that were generated at `time`, if that has
   * changed. All methods return false if the GPU cannot hold the data.
   */
  bool Upload(vtkOpenGLRenderWindow* window, int slot, const std::vector<unsigned int>& instances,
    vtkMTimeType time);

  /**
   * Upload three morph tags per face, or none, into the slot of the last Upload(), if `time` has
   * changed.
   */
  bool UploadMorphTags(
    vtkOpenGLRenderWindow* window, const std::vector<float>& tags, vtkMTimeType time);

  /**
   * Allocate a selection of this number of faces, which compute shaders fill in.
   */
  bool Reserve(vtkOpenGLRenderWindow* window, int slot, size_t faces, bool morphing);

  //@{
  /// Return OpenGL's names of the buffers to draw; 0 for none.
  unsigned int GetInstances() const { return this->Current->Instances.GetHandle(); }
  unsigned int GetMorphTags() const { return this->Current->MorphTags.GetHandle(); }
  //@}

  /// Return whether vertices of the selection to draw morph with the tags of the edges.
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
