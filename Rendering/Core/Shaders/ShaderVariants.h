// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ShaderVariants
 * @brief   the programs of something that draws by VTK's shaders: one per variant
 *
 * A vtkOpenGLPolyDataMapper calls this class from the methods that it overrides. A program is built
 * when VTK asks for it or its key has changed. Shaders that lack an anchor draw nothing; a program
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
   * Have a program ready: update() calls vtkOpenGLPolyDataMapper::UpdateShaders(). `sources` are
   * all that the program is built from. False if there is none.
   */
  bool Update(
    vtkOpenGLHelper& helper, const Dependencies& sources, const std::function<void()>& update);

  /**
   * In GetNeedToRebuildShaders(): whether a program is to be built, because VTK needs it or the key
   * is another. The last program is gone then.
   */
  bool NeedsBuild(vtkOpenGLHelper& helper, bool isNeededByVTK, const Dependencies& key);
  /// The key of a program that is built in place of the one that was asked for.
  void SetKey(const vtkOpenGLHelper& helper, const Dependencies& key);

  /**
   * In BuildShaders(): build() calls that of the superclass.
   */
  void Build(Shaders& shaders, const std::function<void()>& build);

  /**
   * In GetNeedToRebuildShaders(), for a program with stages that VTK does not write: build(shaders)
   * writes VTK's three shaders, and link(shaders) returns the program, or nullptr if it cannot be
   * built. False if VTK is to build its own, which draws nothing where anchors are missing.
   */
  bool BuildWithStages(vtkOpenGLHelper& helper, const std::function<void(Shaders&)>& build,
    const std::function<vtkShaderProgram*(Shaders&)>& link);

  /// Anchors that the shaders of this build lack.
  MissingAnchors& GetMissing() { return this->Missing; }
  /// The error of the shaders that were built last, or "".
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
