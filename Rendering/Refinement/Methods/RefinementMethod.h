// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementMethod
 * @brief   how a mapper draws refined faces
 *
 * One subclass for each of vtkAdaptiveRefinementMapper::Methods. A method says in GLSL how a vertex
 * comes to its face and to its weights there, has on the GPU what that takes, and makes the draw
 * calls; all that comes after the weights is the same under every method. Whatever it keeps on the
 * GPU is made anew only when the selection changed. Private to the module.
 */
#ifndef RefinementMethod_h
#define RefinementMethod_h

#include "Compute/RefinementComputeView.h" // for Primitives
#include "vtkShader.h"                     // for vtkShader::Type
#include "vtkType.h"                       // for vtkTypeInt64

#include <map>    // for signature
#include <string> // for sentences

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class PatternFamily;
class PatternLibrary;
class InstanceBuffers;
class RefinementMesh;
class RefinementPatternBuffer;
class ViewSelection;
struct FaceSums;
struct RefinementShaderOptions;

/// What is drawn, and what the methods of a mapper share.
struct RefinementDrawing
{
  vtkOpenGLRenderWindow* Window;
  const RefinementMesh* Mesh;
  const ViewSelection* Selection;
  /// Where the view's selection is kept, in [0, RefinementState::MaximumViews).
  int Slot;
  /// What the GPU has selected; nullptr where the CPU has.
  RefinementComputeView* ComputeView;
  /// The patterns; nullptr without a recipe.
  const PatternLibrary* Library;
  /// Whether a wireframe is drawn.
  bool HasLines;
  RefinementPatternBuffer* Patterns;
  InstanceBuffers* Instances;
};

class RefinementMethod
{
public:
  using Primitives = RefinementComputeView::Primitives;

  virtual ~RefinementMethod();
  RefinementMethod(const RefinementMethod&) = delete;
  void operator=(const RefinementMethod&) = delete;

  /// The numbers of vtkAdaptiveRefinementMapper::Methods.
  enum Methods
  {
    ARKFPI = 0,
    ARK = 1,
    DMR = 2,
    SUAPT = 3,
    HARDWARE_TESSELLATION = 4,
    UNIFORM = 5
  };
  static const char* GetName(int method);

  /// What the current context lacks for it, as a clause ("OpenGL 4.0"); empty for nothing.
  virtual std::string GetMissing() const { return {}; }

  /// Why it cannot draw such levels, as a clause ("it halves edges ..."); empty if it can.
  virtual std::string FindError(const PatternFamily&) const { return {}; }

  /// Whether it draws these primitives, with its own picture of a wireframe.
  virtual bool CanDraw(Primitives) const { return true; }

  /// How it draws the levels of edges: as they are, rounded, or the highest of all.
  enum class DrawnLevels
  {
    MORPHED,
    ROUNDED,
    HIGHEST
  };
  virtual DrawnLevels GetDrawnLevels() const { return DrawnLevels::ROUNDED; }

  /// Whether it can draw what compute shaders have selected.
  virtual bool TakesComputeSelection() const { return false; }

  /// Whether vertices belong to patterns on the GPU. Colours of faces are those of the patterns
  /// then, else they are given face by face.
  virtual bool HasPatterns() const { return true; }

  /**
   * Have on the GPU what a drawing takes. False, with GetError(), when it cannot be had.
   */
  virtual bool Upload(const RefinementDrawing& drawing) = 0;
  const std::string& GetError() const { return this->Error; }

  /// Fill in what the shaders depend on.
  virtual void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const = 0;

  /// Whether its shaders run in stages that VTK's programs do not have: BuildProgram() makes them.
  virtual bool HasStages() const { return false; }

  /**
   * The program of VTK's finished shaders with the method's own stages, linked. It lives until
   * resources are released. nullptr, with GetError(), when it cannot be built.
   */
  virtual vtkShaderProgram* BuildProgram(
    const RefinementDrawing&, const std::map<vtkShader::Type, vtkShader*>&)
  {
    return nullptr;
  }

  /**
   * Draw what was uploaded, with the program and a vertex array that are in use. Returns the number
   * of draw calls.
   */
  virtual int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) = 0;

  /**
   * Count the triangles that Draw() draws, and would draw of the culled faces, where they are
   * others than those of vtkAdaptiveRefinementFilter; else false.
   */
  virtual bool CountTriangles(const RefinementDrawing&, FaceSums&) const { return false; }

  /// Bytes on the GPU, beside what the methods share.
  virtual vtkTypeInt64 GetMemorySize() const { return 0; }
  virtual void ReleaseGraphicsResources(vtkWindow*) {}

protected:
  RefinementMethod();

  /// Upload what has changed of the selection. False when the GPU cannot hold it.
  static bool UploadInstances(const RefinementDrawing& drawing);

  /// Say that the mesh does not fit into buffer textures; returns false.
  bool FailForSize();

  std::string Error;
};
}

#endif
