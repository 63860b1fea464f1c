// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   textures without mipmaps, with one value per texel
 *
 * Private to the module.
 */
#ifndef ReliefTexture_h
#define ReliefTexture_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace relevo
{
vtkSmartPointer<vtkTextureObject> MakeReliefTexture(
  vtkOpenGLRenderWindow* window, const ivec2& size, const void* values, int components, int type);

/// Activate a texture, if it exists and the program has this sampler.
void ActivateReliefTexture(
  vtkShaderProgram* program, vtkTextureObject* texture, const char* sampler);
}

#endif
