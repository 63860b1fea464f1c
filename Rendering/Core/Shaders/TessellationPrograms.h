// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TessellationPrograms
 * @brief   shader programs with tessellation stages, for every release of VTK
 *
 * VTK's vertex shader, once it takes its vertex from a patch, becomes the tessellation evaluation
 * shader: what it hands on feeds VTK's geometry or fragment shader as before. VTK's own shaders
 * know tessellation stages only from 9.4 on; here they are attached to a program that VTK's shader
 * cache then binds like any other. Private to the modules.
 */
#ifndef TessellationPrograms_h
#define TessellationPrograms_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkNew.h"                    // for members
#include "vtkShader.h"                 // for vtkShader::Type

#include <map>    // for signature
#include <string> // for errors

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class TessellationProgramCache;

class RELEVORENDERINGCORE_EXPORT TessellationPrograms
{
public:
  TessellationPrograms();
  ~TessellationPrograms();
  TessellationPrograms(const TessellationPrograms&) = delete;
  void operator=(const TessellationPrograms&) = delete;

  /// Whether the context, which must be current, has these stages.
  static bool AreSupported();

  /**
   * The program of these finished shaders, whose "vertex shader" is the tessellation evaluation
   * shader; `vertex` and `control` are sources of the stages before it, without #version. Linked,
   * not bound: the window's cache does that. It lives until resources are released. nullptr, with
   * GetError(), when it cannot be built.
   */
  vtkShaderProgram* Build(vtkOpenGLRenderWindow* window, const std::string& vertex,
    const std::string& control, const std::map<vtkShader::Type, vtkShader*>& shaders);

  const std::string& GetError() const { return this->Error; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<TessellationProgramCache> Cache;
  std::string Error;
};
}

#endif
