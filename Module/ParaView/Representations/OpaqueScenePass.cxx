// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpaqueScenePass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

namespace relevo
{
vtkStandardNewMacro(OpaqueScenePass);

void OpaqueScenePass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  this->NumberOfRenderedProps = 0;
  this->ClearLights(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  if (auto* opengl = vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    opengl->DeviceRenderOpaqueGeometry(state->GetFrameBuffer());
  }
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    this->NumberOfRenderedProps += state->GetPropArray()[i]->RenderOverlay(renderer);
  }
}
}
