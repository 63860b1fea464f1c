// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementMethod
 * @brief   how a mapper draws refined faces
 *
 * There is one subclass for each of vtkAdaptiveRefinementMapper::Methods. A method provides the
 * GLSL that assigns a vertex to its face and computes its weights there, the buffers for it, and
 * the draw calls. All methods share the code after the weights. Buffers are rebuilt only when the
 * selection has changed. Private to the module.
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

/// The faces to draw, and the data that a mapper's methods share.
struct RefinementDrawing
{
  vtkOpenGLRenderWindow* Window;
  const RefinementMesh* Mesh;
  const ViewSelection* Selection;
  /// The slot of the view's selection, in [0, RefinementState::MaximumViews).
  int Slot;
  /// The selection of the GPU; nullptr if the CPU has selected.
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

  /// The values of vtkAdaptiveRefinementMapper::Methods.
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

  /// Return the feature that the current context lacks for the method ("OpenGL 4.0"); empty for
  /// none.
  virtual std::string GetMissing() const { return {}; }

  /// Return why the method cannot draw these levels, as a clause ("it halves edges ..."); empty if
  /// it can.
  virtual std::string FindError(const PatternFamily&) const { return {}; }

  /// Return whether the method draws these primitives, with its own triangles in a wireframe.
  virtual bool CanDraw(Primitives) const { return true; }

  /// How the method draws the levels of edges: unchanged, rounded, or the highest of all.
  enum class DrawnLevels
  {
    MORPHED,
    ROUNDED,
    HIGHEST
  };
  virtual DrawnLevels GetDrawnLevels() const { return DrawnLevels::ROUNDED; }

  /// Return whether the method can draw a selection of compute shaders.
  virtual bool TakesComputeSelection() const { return false; }

  /// Return whether vertices belong to patterns on the GPU. Colours of faces are then those of the
  /// patterns; otherwise they are set per face.
  virtual bool HasPatterns() const { return true; }

  /**
   * Upload the data of a drawing. Return false and set GetError() if it fails.
   */
  virtual bool Upload(const RefinementDrawing& drawing) = 0;
  const std::string& GetError() const { return this->Error; }

  /// Set the options that depend on the method.
  virtual void FillOptions(
    const RefinementDrawing& drawing, RefinementShaderOptions& options) const = 0;

  /// Return whether the method's shaders run in stages that VTK's programs do not have.
  /// BuildProgram() then builds them.
  virtual bool HasStages() const { return false; }

  /**
   * Return the linked program of VTK's finished shaders with the method's own stages. It lives
   * until resources are released. If it cannot be built, return nullptr and set GetError().
   */
  virtual vtkShaderProgram* BuildProgram(
    const RefinementDrawing&, const std::map<vtkShader::Type, vtkShader*>&)
  {
    return nullptr;
  }

  /**
   * Draw the uploaded data with the current program and vertex array. Return the number of draw
   * calls.
   */
  virtual int Draw(
    const RefinementDrawing& drawing, vtkShaderProgram* program, Primitives primitives) = 0;

  /**
   * Count the triangles of Draw(), and those of the culled faces. Return false if the numbers are
   * those of vtkAdaptiveRefinementFilter.
   */
  virtual bool CountTriangles(const RefinementDrawing&, FaceSums&) const { return false; }

  /// Return the number of bytes on the GPU, without the shared data.
  virtual vtkTypeInt64 GetMemorySize() const { return 0; }
  virtual void ReleaseGraphicsResources(vtkWindow*) {}

protected:
  RefinementMethod();

  /// Upload the parts of the selection that have changed. Return false if the GPU cannot hold it.
  static bool UploadInstances(const RefinementDrawing& drawing);

  /// Set the error that the mesh does not fit into buffer textures, and return false.
  bool FailForSize();

  std::string Error;
};
}

#endif
