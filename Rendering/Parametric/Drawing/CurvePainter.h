// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvePainter
 * @brief   draws the curves of one data set as VTK's mapper draws a polydata
 *
 * Lights, clipping planes, opacity, render passes and selections are VTK's: where its shaders read
 * a vertex, they are given one of a curve. Private to the module.
 */
#ifndef CurvePainter_h
#define CurvePainter_h

#include "Buffers/CurveBuffers.h"
#include "Buffers/CurveColors.h"
#include "Buffers/CurvePatterns.h"
#include "Buffers/InstanceBuffers.h"
#include "Changes/Dependencies.h"
#include "Curves/CurveMesh.h"
#include "Mathematics/FiniteBox.h"
#include "Shaders/CurveShader.h"
#include "Shaders/TessellationPrograms.h"
#include "View/CurveSelection.h"
#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAdaptiveRefinement;
class vtkPointSet;

namespace relevo
{
class CurvePainter : public vtkOpenGLPolyDataMapper
{
public:
  static CurvePainter* New();
  vtkTypeMacro(CurvePainter, vtkOpenGLPolyDataMapper);

  /// Take a data set. False if it is the one that is there, and has not changed.
  bool SetCurves(vtkPointSet* input);
  /// Tells what is wrong with cells.
  const CurveMesh& GetMesh() const { return this->Mesh; }

  /// What curves become.
  struct Shape
  {
    int Sides = 1; // 1: lines, 2: ribbons, else tubes
    double Radius = 0.0;
    std::string RadiusArrayName;
  };
  /// After SetCurves(). What is wrong with the array of radii, or ""; nothing is to be drawn then.
  std::string SetShape(const Shape& shape);

  /// Not initialized where there is nothing to draw.
  void GetCurveBounds(double bounds[6]) const;

  /// How to draw.
  struct Settings
  {
    vtkAdaptiveRefinement* Recipe = nullptr;
    vtkMapper* Scalars = nullptr; // what colours by
    bool IsTessellated = false;
    bool IsCulled = true;
  };
  /// Before RenderPiece(): have what a view shows on the GPU. What is wrong, or "".
  std::string Prepare(vtkRenderer* renderer, vtkActor* actor, const Settings& settings);

  //@{
  /// After it: what is wrong with colours, the shaders or tessellation, or "".
  const std::string& GetColorProblem() const { return this->ColorProblem; }
  const std::string& GetShaderProblem() const { return this->ShaderProblem; }
  const std::string& GetTessellationProblem() const { return this->TessellationProblem; }
  //@}
  bool IsTessellated() const { return this->Options.IsTessellated; }

  /// What the largest ids are that are drawn for a selection.
  void AnnounceIds(vtkHardwareSelector* selector) const;

  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop) override;

  const CurveSelection& GetCurveSelection() const { return this->Selection; }
  vtkIdType CountDrawnSegments() const;
  vtkIdType CountHiddenSegments() const;
  int GetNumberOfDrawCalls() const { return this->NumberOfDrawCalls; }
  vtkTypeInt64 GetMemorySize() const;
  vtkIdType GetNumberOfBufferBuilds() const { return this->NumberOfBufferBuilds; }
  vtkIdType GetNumberOfShaderBuilds() const { return this->NumberOfShaderBuilds; }

protected:
  CurvePainter();
  ~CurvePainter() override;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void BuildShaders(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  CurvePainter(const CurvePainter&) = delete;
  void operator=(const CurvePainter&) = delete;

  void UpdateBox();
  bool Upload(vtkOpenGLRenderWindow* window, bool withCells);
  void UpdateColors(vtkOpenGLRenderWindow* window, vtkMapper* scalars);
  void ChooseMethod(vtkActor* actor, bool isTessellated);
  bool BuildStages(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor);
  void DrawInstances(unsigned int mode);
  void DrawPatches();
  int GetMostSegments() const; // of a curve

  vtkSmartPointer<vtkPointSet> CurveInput;
  Dependencies CurveSource;
  CurveMesh Mesh;
  FiniteBox PointBox;
  dvec3 Origin = dvec3(0.0); // its middle
  Dependencies ShapeSource;
  Shape CurveShape;
  std::vector<double> Radii; // at control points; one for all of them
  std::string RadiusProblem;
  vtkNew<vtkPolyData> Box; // VTK's mapper wants points

  CurveSelection Selection;
  dvec4 Eye = dvec4(0.0);
  CurveBuffers Buffers;
  bool NeedsCurves = true;
  bool NeedsRadii = true;
  bool NeedsFrames = true;
  CurveColors Colors;
  Dependencies ColorSource;
  std::string ColorProblem;
  CurvePatterns Patterns;
  InstanceBuffers Instances;

  CurveShaderOptions Options;
  Dependencies ShaderKey;
  vtkOpenGLHelper Helper;
  vtkNew<vtkShaderProgram> NoProgram;
  TessellationPrograms Programs;
  std::string TessellationProblem;
  Dependencies FailedStages; // of tessellation shaders that could not be built
  MissingAnchors Missing;
  std::string ShaderProblem;
  Dependencies FailedSources; // of shaders that could not be built
  int NumberOfDrawCalls = 0;
  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;
};
}

#endif
