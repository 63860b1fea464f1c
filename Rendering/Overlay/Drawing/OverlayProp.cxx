// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/OverlayProp.h"

#include "vtkObjectFactory.h"

namespace relevo
{
vtkStandardNewMacro(OverlayProp);

//------------------------------------------------------------------------------
OverlayProp::OverlayProp()
{
  this->PickableOff();
  this->UseBoundsOff();
}

//------------------------------------------------------------------------------
OverlayProp::~OverlayProp() = default;

//------------------------------------------------------------------------------
int OverlayProp::RenderOverlay(vtkViewport* viewport)
{
  return this->Draw && this->Draw(viewport) ? 1 : 0;
}

//------------------------------------------------------------------------------
void OverlayProp::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Release)
  {
    this->Release(window);
  }
}
}
