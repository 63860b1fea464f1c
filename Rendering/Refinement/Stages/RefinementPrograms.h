// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementPrograms
 * @brief   the helpers of a mapper that draw refined faces, with their programs for each variant
 *
 * Several actors and renderers can share a mapper, but their shaders differ: see ShaderVariantKey.
 * All helpers, including VTK's, have the programs of the current variant; the programs of the
 * others are stored here. Private to the module.
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

  /// The arguments are VTK's types of primitives.
  RefinementPrograms(int triangles, int vertices);
  ~RefinementPrograms();
  RefinementPrograms(const RefinementPrograms&) = delete;
  void operator=(const RefinementPrograms&) = delete;

  //@{
  /**
   * Return the helpers that draw refined faces and their visible vertices, and further helpers of
   * faces for subclasses.
   */
  vtkOpenGLHelper& GetFaces() { return this->Faces; }
  vtkOpenGLHelper& GetVertices() { return this->Vertices; }
  vtkOpenGLHelper* AddFaceHelper();
  bool IsFaceHelper(const vtkOpenGLHelper* helper) const;
  //@}

  bool UsesVariant(const Dependencies& key) const { return this->VariantKey == key; }
  /**
   * Make all helpers, including VTK's, use the programs of another variant. `swap` exchanges the
   * remaining state of VTK's mapper with its argument, which is empty for a new variant.
   */
  void UseVariant(const Dependencies& key, const std::vector<vtkOpenGLHelper*>& helpersOfVTK,
    const std::function<void(std::shared_ptr<void>&)>& swap, vtkWindow* window);

  //@{
  /**
   * Return the options of a helper's shaders in this frame. Call UpdateKey() after changing them.
   */
  RefinementShaderOptions& GetOptions(const vtkOpenGLHelper* helper);
  void UpdateKey(const vtkOpenGLHelper* helper);
  //@}
  /// Set the options that depend on a recipe's surface and displacement.
  void FillOptions(vtkAdaptiveRefinement* recipe, RefinementShaderOptions& options) const;

  //@{
  /**
   * Call these before and after vtkOpenGLPolyDataMapper::UpdateShaders(). CanUpdate() returns false
   * if the shaders cannot be built and their sources have not changed. `sources` are those that are
   * not in the options.
   */
  bool CanUpdate(const vtkOpenGLHelper& helper, const Dependencies& sources);
  StageResult CheckUpdated(const vtkOpenGLHelper& helper);
  //@}

  /**
   * Return whether to build the shaders of a helper of faces, in GetNeedToRebuildShaders(): VTK
   * needs it or the key has changed. This discards the last program.
   */
  bool NeedsBuild(vtkOpenGLHelper& helper, bool isNeededByVTK);

  /**
   * Build a program for a method with its own stages, in GetNeedToRebuildShaders(). build(shaders)
   * writes VTK's three shaders. link(shaders) returns the program, or nullptr if it cannot be
   * built.
   */
  enum class Built
  {
    PROGRAM, // VTK's shader cache can bind the program
    NOTHING, // VTK's shader cache has an empty program, because anchors are missing
    FAILED
  };
  Built BuildWithStages(vtkOpenGLHelper& helper, int method,
    const std::function<void(Shaders&)>& build,
    const std::function<vtkShaderProgram*(Shaders&)>& link);

  /**
   * Check the shaders of a helper, in BuildShaders(), after they have been written. Shaders that
   * lack anchors draw nothing.
   */
  StageResult Finish(const vtkOpenGLHelper* helper, Shaders& shaders, const MissingAnchors& missing,
    bool isSelecting);

  //@{
  /**
   * Change the shaders of a helper of faces, in ReplaceShaderValues(), before and after VTK does.
   */
  void Mark(const vtkOpenGLHelper* helper, const ShaderPurpose& purpose, Shaders& shaders,
    MissingAnchors& missing);
  void Refine(const vtkOpenGLHelper* helper, const ShaderPurpose& purpose, Shaders& shaders,
    MissingAnchors& missing);
  //@}

  /// Return the attributes that a helper's shaders read from buffers.
  const std::vector<std::string>& GetAttributes(const vtkOpenGLHelper* helper);
  /// Return whether a helper has a program that draws.
  bool Draws(const vtkOpenGLHelper& helper);
  /// Return whether shaders without ids have drawn in the pass of a selection, and reset this.
  bool TakeLackOfIds();

  //@{
  /**
   * Set or return whether a method's own stages could not be built for the current variant from
   * these sources of the recipe and the actor.
   */
  void SetFailedSources(vtkAdaptiveRefinement* recipe, vtkActor* actor);
  bool HasFailed(vtkAdaptiveRefinement* recipe, vtkActor* actor);
  void ForgetFailures();
  //@}

  /// Forget the programs with a method's own stages.
  void ForgetMethod(int method);

  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct State
  {
    RefinementShaderOptions Options;
    Dependencies Key;       // of the options
    bool HasNewKey = false; // new since the last frame
    Dependencies Sources;   // the other sources
    bool HasFailed = false; // the build has failed
    std::vector<std::string> Attributes;
    int Method = -1; // the method that has linked the program; -1 for VTK's shader cache
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
  std::vector<vtkOpenGLHelper*> Helpers = { &this->Faces, &this->Vertices }; // all helpers

  // The states of the current variant.
  std::map<const vtkOpenGLHelper*, State> States;
  Dependencies FailedSources;

  std::map<Dependencies, Variant> Variants; // the other variants
  Dependencies VariantKey;
  unsigned long NumberOfUses = 0;

  vtkNew<vtkShaderProgram> NoProgram;
  vtkNew<vtkLinearSurface> Linear; // used if the recipe has no surface
  std::string Error;               // error that was reported last
  bool LacksIds = false;           // in the current pass of a selection
  vtkIdType NumberOfBuilds = 0;
};
}

#endif
