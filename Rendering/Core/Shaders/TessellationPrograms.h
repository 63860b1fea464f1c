// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TessellationPrograms
 * @brief   shader programs with tessellation stages, for all supported releases of VTK
 *
 * VTK's vertex shader becomes the tessellation evaluation shader after it has been changed to take
 * its vertex from a patch. Its output feeds VTK's geometry or fragment shader as before. VTK
 * supports tessellation stages only from 9.4 on; here they are attached to a program that VTK's
 * shader cache binds like any other. Private to the modules.
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

  /// Return whether the current context supports these stages.
  static bool AreSupported();

  /**
   * Return the program of finished shaders whose "vertex shader" is the tessellation evaluation
   * shader. `vertex` and `control` are the sources of the stages before it, without #version. The
   * program is linked but not bound: the window's cache binds it. It lives until resources are
   * released. If it cannot be built, return nullptr and set GetError().
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
