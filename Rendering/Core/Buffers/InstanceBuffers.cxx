// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/InstanceBuffers.h"

#include "vtkOpenGLRenderWindow.h"

namespace relevo
{
bool InstanceBuffers::Upload(vtkOpenGLRenderWindow* window, int slot,
  const std::vector<unsigned int>& instances, vtkMTimeType time)
{
  this->Current = &this->Slots[slot];
  if (this->Current->GroupsTime != time)
  {
    if (!this->Current->Instances.Upload(window, instances))
    {
      return false;
    }
    this->Current->GroupsTime = time;
  }
  return true;
}

bool InstanceBuffers::UploadMorphTags(
  vtkOpenGLRenderWindow* window, const std::vector<float>& tags, vtkMTimeType time)
{
  if (this->Current->LevelsTime != time)
  {
    if (tags.empty())
    {
      this->Current->MorphTags.ReleaseGraphicsResources(window);
    }
    else if (!this->Current->MorphTags.Upload(window, tags, 3))
    {
      return false;
    }
    this->Current->LevelsTime = time;
  }
  return true;
}

bool InstanceBuffers::Reserve(vtkOpenGLRenderWindow* window, int slot, size_t faces, bool morphing)
{
  this->Current = &this->Slots[slot];
  this->Current->GroupsTime = 0; // the data of Upload() are overwritten
  this->Current->LevelsTime = 0;
  if (!morphing)
  {
    this->Current->MorphTags.ReleaseGraphicsResources(window);
  }
  return this->Current->Instances.ReserveIntegers(window, faces) &&
    (!morphing || this->Current->MorphTags.ReserveFloats(window, faces, 3));
}

void InstanceBuffers::Activate(vtkShaderProgram* program)
{
  if (this->Current)
  {
    this->Current->Instances.Activate(program, "relevoInstances");
    this->Current->MorphTags.Activate(program, "relevoMorphTags");
  }
}

void InstanceBuffers::Deactivate()
{
  if (this->Current)
  {
    this->Current->Instances.Deactivate();
    this->Current->MorphTags.Deactivate();
  }
}

vtkTypeInt64 InstanceBuffers::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const auto& slot : this->Slots)
  {
    size += slot.second.Instances.GetMemorySize() + slot.second.MorphTags.GetMemorySize();
  }
  return size;
}

void InstanceBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& slot : this->Slots)
  {
    slot.second.Instances.ReleaseGraphicsResources(window);
    slot.second.MorphTags.ReleaseGraphicsResources(window);
  }
  this->Slots.clear();
  this->Current = nullptr;
}
}
