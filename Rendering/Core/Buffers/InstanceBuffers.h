// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   InstanceBuffers
 * @brief   which faces are drawn, and how their patterns lie on them, on the GPU
 *
 * Each of several views has a slot, from 0 on; the one made or uploaded last is drawn.
 * Private to the modules.
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
   * Upload instances (face << 3 | permutation code) that were made at `time`, if that is new. False
   * when the GPU cannot hold them, here and below.
   */
  bool Upload(vtkOpenGLRenderWindow* window, int slot, const std::vector<unsigned int>& instances,
    vtkMTimeType time);

  /**
   * Upload three morph tags for each face, or none, into the slot that Upload() took last, if
   * `time` is new.
   */
  bool UploadMorphTags(
    vtkOpenGLRenderWindow* window, const std::vector<float>& tags, vtkMTimeType time);

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
