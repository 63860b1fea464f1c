// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementPrograms
 * @brief   what draws refined faces: the helpers of a mapper, and their programs for each variant
 *
 * Several actors and renderers can share a mapper, and their shaders differ: see ShaderVariantKey.
 * All helpers, VTK's included, have the programs of the variant in use; those of the others are
 * stored here. Private to the module.
 */
#ifndef RefinementPrograms_h
#define RefinementPrograms_h

#include "Changes/Dependencies.h"
#include "Shaders/RefinementShader.h" // for ShaderPurpose
#include "Shaders/RefinementShaderOptions.h"
#include "Stages/StageResult.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkShaderProgram.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkAdaptiveRefinement;
class vtkWindow;

namespace relevo
{
class RefinementPrograms
{
public:
  using Shaders = std::map<vtkShader::Type, vtkShader*>;

  /// The two are VTK's types of primitives.
  RefinementPrograms(int triangles, int vertices);
  ~RefinementPrograms();
  RefinementPrograms(const RefinementPrograms&) = delete;
  void operator=(const RefinementPrograms&) = delete;

  //@{
  /**
   * What draws refined faces, and their vertices when those are visible, and more of the former,
   * for subclasses.
   */
  vtkOpenGLHelper& GetFaces() { return this->Faces; }
  vtkOpenGLHelper& GetVertices() { return this->Vertices; }
  vtkOpenGLHelper* AddFaceHelper();
  bool IsFaceHelper(const vtkOpenGLHelper* helper) const;
  //@}

  bool UsesVariant(const Dependencies& key) const { return this->VariantKey == key; }
  /**
   * Have all helpers, and VTK's own, use the programs of another variant. `swap` exchanges what
   * else VTK knows of them for what it is given, which is empty for a new variant.
   */
  void UseVariant(const Dependencies& key, const std::vector<vtkOpenGLHelper*>& helpersOfVTK,
    const std::function<void(std::shared_ptr<void>&)>& swap, vtkWindow* window);

  //@{
  /**
   * The options of a helper's shaders in this frame: change the options, then call
   * UpdateKey().
   */
  RefinementShaderOptions& GetOptions(const vtkOpenGLHelper* helper);
  void UpdateKey(const vtkOpenGLHelper* helper);
  //@}
  /// Fill in what a recipe's surface and displacement are.
  void FillOptions(vtkAdaptiveRefinement* recipe, RefinementShaderOptions& options) const;

  //@{
  /**
   * Around vtkOpenGLPolyDataMapper::UpdateShaders(): false where the shaders cannot be built, and
   * nothing of them has changed. `sources` are those that are not in the options.
   */
  bool CanUpdate(const vtkOpenGLHelper& helper, const Dependencies& sources);
  StageResult CheckUpdated(const vtkOpenGLHelper& helper);
  //@}

  /**
   * In GetNeedToRebuildShaders(), for a helper of faces: whether its shaders are to be built,
   * because VTK needs it or the key is another. The last program is gone then.
   */
  bool NeedsBuild(vtkOpenGLHelper& helper, bool isNeededByVTK);

  /**
   * In GetNeedToRebuildShaders(), for a method that links programs with stages of its own:
   * build(shaders) writes VTK's three shaders, and link(shaders) returns the program, nullptr if it
   * cannot be built.
   */
  enum class Built
  {
    PROGRAM, // VTK's shader cache binds it like any other
    NOTHING, // VTK's shader cache has a program for shaders that lack anchors
    FAILED
  };
  Built BuildWithStages(vtkOpenGLHelper& helper, int method,
    const std::function<void(Shaders&)>& build,
    const std::function<vtkShaderProgram*(Shaders&)>& link);

  /**
   * In BuildShaders(), once they are written: a helper's shaders that lack anchors draw nothing.
   */
  StageResult Finish(const vtkOpenGLHelper* helper, Shaders& shaders, const MissingAnchors& missing,
    bool isSelecting);

  //@{
  /**
   * In ReplaceShaderValues(), for a helper of faces, before and after VTK writes.
   */
  void Mark(const vtkOpenGLHelper* helper, const ShaderPurpose& purpose, Shaders& shaders,
    MissingAnchors& missing);
  void Refine(const vtkOpenGLHelper* helper, const ShaderPurpose& purpose, Shaders& shaders,
    MissingAnchors& missing);
  //@}

  /// The attributes that a helper's shaders read from buffers.
  const std::vector<std::string>& GetAttributes(const vtkOpenGLHelper* helper);
  /// Whether a helper has a program that draws.
  bool Draws(const vtkOpenGLHelper& helper);
  /// Whether shaders without ids have drawn in the pass of a selection; false the next time.
  bool TakeLackOfIds();

  //@{
  /**
   * Whether a method's own stages could not be built from these sources, of the recipe and the
   * actor, for the variant in use.
   */
  void SetFailedSources(vtkAdaptiveRefinement* recipe, vtkActor* actor);
  bool HasFailed(vtkAdaptiveRefinement* recipe, vtkActor* actor);
  void ForgetFailures();
  //@}

  /// No program of a method's own is used any more.
  void ForgetMethod(int method);

  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct State
  {
    RefinementShaderOptions Options;
    Dependencies Key;       // of these
    bool HasNewKey = false; // since the last frame
    Dependencies Sources;   // of the rest
    bool HasFailed = false; // to be built
    std::vector<std::string> Attributes;
    int Method = -1; // that has linked the program; -1 for VTK's shader cache
    bool DrawsNothing = false;
  };
  struct Variant
  {
    std::map<vtkOpenGLHelper*, std::unique_ptr<vtkOpenGLHelper>> Helpers;
    std::shared_ptr<void> Info;
    std::map<const vtkOpenGLHelper*, State> States;
    Dependencies FailedSources;
    unsigned long LastUse = 0;
  };
  void Swap(Variant& variant, const std::vector<vtkOpenGLHelper*>& helpersOfVTK,
    const std::function<void(std::shared_ptr<void>&)>& swap);
  void ReleaseOldest(vtkWindow* window);

  vtkOpenGLHelper Faces;
  vtkOpenGLHelper Vertices;
  std::vector<std::unique_ptr<vtkOpenGLHelper>> MoreFaces;
  std::vector<vtkOpenGLHelper*> Helpers = { &this->Faces, &this->Vertices }; // all

  // Of the variant in use.
  std::map<const vtkOpenGLHelper*, State> States;
  Dependencies FailedSources;

  std::map<Dependencies, Variant> Variants; // the others
  Dependencies VariantKey;
  unsigned long NumberOfUses = 0;

  vtkNew<vtkShaderProgram> NoProgram;
  vtkNew<vtkLinearSurface> Linear; // where the recipe has no surface
  std::string Error;               // that was reported last
  bool LacksIds = false;           // in the pass of a selection that has begun
  vtkIdType NumberOfBuilds = 0;
};
}

#endif
