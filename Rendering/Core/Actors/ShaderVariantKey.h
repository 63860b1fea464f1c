// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file The part of a shader variant's key that comes from the actor and the renderer.
 *
 * vtkOpenGLPolyDataMapper writes shaders for the actor that it draws. It writes them again when the
 * actor's property has changed, but not when it draws another actor. If several actors or renderers
 * share a mapper, each variant has its own programs. Private to the modules.
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
/// A texture and its name in shaders.
using NamedTexture = std::pair<vtkTexture*, std::string>;

/**
 * Return all properties of an actor and a renderer that affect the shaders' source, except for
 * those that vtkOpenGLPolyDataMapper checks itself. The key contains values, not modification
 * times.
 */
RELEVORENDERINGCORE_EXPORT Dependencies GetShaderVariantKey(
  vtkRenderer* ren, vtkActor* act, const std::vector<NamedTexture>& textures);

/// Return whether the actor has its own fragment shader code.
RELEVORENDERINGCORE_EXPORT bool HasOwnFragments(vtkActor* act);
}

#endif
