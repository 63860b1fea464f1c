// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ShaderVariants
 * @brief   the programs of a mapper that draws with VTK's shaders, one for each variant
 *
 * A vtkOpenGLPolyDataMapper calls this class from the methods that it overrides. A program is built
 * when VTK requests it or its key has changed. Shaders that lack an anchor draw nothing. A program
 * that cannot be built is tried again when its sources have changed. Private to the modules.
 */
#ifndef ShaderVariants_h
#define ShaderVariants_h

#include "Changes/Dependencies.h"
#include "RelevoRenderingCoreModule.h" // for export macro
#include "Shaders/ShaderText.h"
#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkType.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT ShaderVariants
{
public:
  using Shaders = std::map<vtkShader::Type, vtkShader*>;

  explicit ShaderVariants(int number = 1);
  ~ShaderVariants();
  ShaderVariants(const ShaderVariants&) = delete;
  void operator=(const ShaderVariants&) = delete;

  vtkOpenGLHelper& GetHelper(int variant = 0) { return this->Variants[variant].Helper; }

  /**
   * Prepare a program. update() calls vtkOpenGLPolyDataMapper::UpdateShaders(). `sources` are all
   * dependencies of the program. Return false if there is no program.
   */
  bool Update(
    vtkOpenGLHelper& helper, const Dependencies& sources, const std::function<void()>& update);

  /**
   * Return whether to build a program, in GetNeedToRebuildShaders(): VTK needs it or the key has
   * changed. This discards the last program.
   */
  bool NeedsBuild(vtkOpenGLHelper& helper, bool isNeededByVTK, const Dependencies& key);
  /// Set the key of a program that is built instead of the requested one.
  void SetKey(const vtkOpenGLHelper& helper, const Dependencies& key);

  /**
   * Build the shaders, in BuildShaders(). build() calls the method of the superclass.
   */
  void Build(Shaders& shaders, const std::function<void()>& build);

  /**
   * Build a program with stages that VTK does not write, in GetNeedToRebuildShaders().
   * build(shaders) writes VTK's three shaders. link(shaders) returns the program, or nullptr if it
   * cannot be built. Return false if VTK must build its own program, which draws nothing if anchors
   * are missing.
   */
  bool BuildWithStages(vtkOpenGLHelper& helper, const std::function<void(Shaders&)>& build,
    const std::function<vtkShaderProgram*(Shaders&)>& link);

  /// Return the anchors that the shaders being built lack.
  MissingAnchors& GetMissing() { return this->Missing; }
  /// Return the error of the shaders that were built last, or "".
  const std::string& GetError() const { return this->Error; }
  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Variant
  {
    vtkOpenGLHelper Helper;
    Dependencies Key;
  };
  Dependencies& GetKey(const vtkOpenGLHelper& helper);

  std::vector<Variant> Variants;
  vtkNew<vtkShaderProgram> NoProgram;
  MissingAnchors Missing;
  std::string Error;
  Dependencies FailedSources;
  vtkIdType NumberOfBuilds = 0;
};
}

#endif
