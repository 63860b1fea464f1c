// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/ContextWatch.h"

#include "vtkObjectFactory.h"

namespace relevo
{
vtkStandardNewMacro(ContextWatch);

bool ContextWatch::Release()
{
  if (this->IsReleasing)
  {
    return false;
  }
  this->HasReleased = false;
  // If there is a context, VTK's callback calls the virtual method below.
  this->vtkTextureObject::ReleaseGraphicsResources(nullptr);
  return this->HasReleased;
}

void ContextWatch::ReleaseGraphicsResources(vtkWindow* window)
{
  this->IsReleasing = true;
  this->HasReleased = true;
  if (this->OnRelease)
  {
    this->OnRelease(window);
  }
  this->IsReleasing = false;
  this->Superclass::ReleaseGraphicsResources(window);
}
}
