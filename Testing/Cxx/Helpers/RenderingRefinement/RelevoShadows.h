// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A render pass that draws opaque actors with shadows.
#ifndef RelevoShadows_h
#define RelevoShadows_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

// For vtkOpenGLRenderer::SetPass(). The renderer needs a positional light.
vtkSmartPointer<vtkRenderPass> RelevoMakeShadowPass();

#endif
