// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of a shader variant's key that comes from the actor and the renderer.
 *
 * vtkOpenGLPolyDataMapper writes shaders for the actor that it draws, and writes them anew when the
 * actor's property has changed since, not when it draws another actor. Of a mapper that several
 * actors or renderers share, each variant has programs of its own. Private to the modules.
 */
#ifndef ShaderVariantKey_h
#define ShaderVariantKey_h

#include "Changes/Dependencies.h"      // for keys
#include "RelevoRenderingCoreModule.h" // for export macro

#include <string>  // for names
#include <utility> // for textures
#include <vector>  // for textures

class vtkActor;
class vtkRenderer;
class vtkTexture;

namespace relevo
{
/// A texture and the name that shaders know it by.
using NamedTexture = std::pair<vtkTexture*, std::string>;

/**
 * All of an actor and of a renderer that decides how shaders read, but for what
 * vtkOpenGLPolyDataMapper notices itself: values that change are in, the times of changes are not.
 */
RELEVORENDERINGCORE_EXPORT Dependencies GetShaderVariantKey(
  vtkRenderer* ren, vtkActor* act, const std::vector<NamedTexture>& textures);

/// Whether the actor has fragment shader text of its own.
RELEVORENDERINGCORE_EXPORT bool HasOwnFragments(vtkActor* act);
}

#endif
