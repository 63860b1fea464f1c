// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvePainter
 * @brief   draws the curves of one data set as VTK's mapper draws a polydata
 *
 * Lights, clipping planes, opacity, render passes and selections are VTK's: its shaders get a
 * vertex of a curve instead of a vertex of the mesh. Private to the module.
 */
#ifndef CurvePainter_h
#define CurvePainter_h

#include "Buffers/CurveColors.h"
#include "Buffers/CurvePatterns.h"
#include "Changes/Dependencies.h"
#include "Drawing/CurveGeometry.h"
#include "Shaders/CurveShader.h"
#include "Shaders/TessellationPrograms.h"
#include "Shaders/VariantPainter.h"

#include <string>
#include <vector>

class vtkAdaptiveRefinement;
class vtkPointSet;

namespace relevo
{
class CurvePainter : public VariantPainter
{
public:
  static CurvePainter* New();
  vtkTypeMacro(CurvePainter, VariantPainter);

  /// Set a data set. Return false if it is the current one and has not changed.
  bool SetCurves(vtkPointSet* input);
  /// Set the shape, after SetCurves(). Return the error of the array of radii, or ""; with an error
  /// nothing can be drawn.
  std::string SetShape(const CurveGeometry::Shape& shape);
  /// Return the curves, including the errors of cells.
  const CurveMesh& GetMesh() const { return this->Geometry.GetMesh(); }

  /// Compute the bounds; they are uninitialized if there is nothing to draw.
  void GetCurveBounds(double bounds[6]) const { this->Geometry.GetBounds(bounds); }

  /// The settings for drawing.
  struct Settings
  {
    vtkAdaptiveRefinement* Recipe = nullptr;
    vtkMapper* Scalars = nullptr; // the mapper with the settings of scalars
    bool IsTessellated = false;
    bool IsCulled = true;
  };
  /// Upload the data of a view, before RenderPiece(). Return the error, or "".
  std::string Prepare(vtkRenderer* renderer, vtkActor* actor, const Settings& settings);

  //@{
  /// Return the error of the colours or of tessellation, or "", after RenderPiece().
  const std::string& GetColorError() const { return this->ColorError; }
  const std::string& GetTessellationError() const { return this->TessellationError; }
  //@}
  bool IsTessellated() const { return this->Options.IsTessellated; }

  /// Report the largest ids that a selection draws.
  void AnnounceIds(vtkHardwareSelector* selector) const;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  const CurveSelection& GetCurveSelection() const { return this->Geometry.GetSelection(); }
  vtkIdType CountDrawnSegments() const;
  vtkIdType CountHiddenSegments() const;
  int GetNumberOfDrawCalls() const { return this->NumberOfDrawCalls; }
  vtkTypeInt64 GetMemorySize() const;

  /// How often levels have been evaluated, data uploaded and shaders built.
  struct Counts
  {
    vtkIdType Selections = 0;
    vtkIdType BufferBuilds = 0;
    vtkIdType ShaderBuilds = 0;

    void operator+=(const Counts& other);
  };
  Counts GetCounts() const;

protected:
  CurvePainter();
  ~CurvePainter() override;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor* actor) override;
  void FinishShaders(ShaderVariants::Shaders& shaders) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  CurvePainter(const CurvePainter&) = delete;
  void operator=(const CurvePainter&) = delete;

  void UpdateBox();
  void UpdateColors(vtkOpenGLRenderWindow* window, vtkMapper* scalars);
  void ChooseMethod(vtkActor* actor, bool isTessellated);
  bool BuildStages(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor);
  void DrawInstances(unsigned int mode);
  void DrawPatches();
  int GetMaximumSegments() const; // per curve

  CurveGeometry Geometry;
  CurveColors Colors;
  Dependencies ColorSource;
  std::string ColorError;
  CurvePatterns Patterns;

  CurveShaderOptions Options;
  TessellationPrograms Programs;
  std::string TessellationError;
  Dependencies FailedStages; // tessellation shaders that could not be built
  int NumberOfDrawCalls = 0;
};
}

#endif
