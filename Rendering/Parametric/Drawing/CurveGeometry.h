// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveGeometry
 * @brief   the curves of one data set with their radii, what a view shows of them, and their
 *          buffers on the GPU
 *
 * Private to the module.
 */
#ifndef CurveGeometry_h
#define CurveGeometry_h

#include "Buffers/CurveBuffers.h"
#include "Buffers/InstanceBuffers.h"
#include "Changes/Dependencies.h"
#include "Curves/CurveMesh.h"
#include "Mathematics/FiniteBox.h"
#include "View/CurveSelection.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkAdaptiveRefinement;
class vtkOpenGLRenderWindow;
class vtkPointSet;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class CurveGeometry
{
public:
  /// Take a data set. False if it is the one that is there, and has not changed.
  bool SetCurves(vtkPointSet* input);
  vtkPointSet* GetInput() const { return this->Input; }
  const CurveMesh& GetMesh() const { return this->Mesh; }
  /// The origin of the control points on the GPU.
  const dvec3& GetOrigin() const { return this->Origin; }

  /// The shape that curves are drawn as.
  struct Shape
  {
    int Sides = 1; // 1: lines, 2: ribbons, else tubes
    double Radius = 0.0;
    std::string RadiusArrayName;
  };
  /// After SetCurves(): false if the curves have this shape already.
  bool SetShape(const Shape& shape);
  int GetSides() const { return this->Current.Sides; }
  /// The error of the array of radii, with which nothing can be drawn; or "".
  const std::string& GetRadiusError() const { return this->RadiusError; }

  /// Of all that is drawn; not initialized where there is nothing to draw.
  void GetBounds(double bounds[6]) const;

  /// Choose the curves and their segments for a view. What is wrong with the recipe, or "".
  std::string Select(
    vtkAdaptiveRefinement* recipe, vtkRenderer* renderer, vtkActor* actor, bool isCulled);
  const CurveSelection& GetSelection() const { return this->Selection; }

  /// Upload what has changed; `withCells` also the numbers of cells. False where there is no room.
  bool Upload(vtkOpenGLRenderWindow* window, bool withCells);
  const CurveBuffers& GetBuffers() const { return this->Buffers; }
  vtkIdType GetNumberOfUploads() const { return this->NumberOfUploads; }
  vtkTypeInt64 GetMemorySize() const;

  //@{
  /// Give programs the curves, and those of them that are drawn.
  void Activate(vtkShaderProgram* program);
  void ActivateInstances(vtkShaderProgram* program) { this->Instances.Activate(program); }
  void Deactivate();
  //@}
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkPointSet> Input;
  Dependencies InputSource;
  CurveMesh Mesh;
  FiniteBox PointBox;
  dvec3 Origin = dvec3(0.0); // its middle
  Dependencies ShapeSource;
  Shape Current;
  std::vector<double> Radii; // at control points; one for all of them
  std::string RadiusError;

  CurveSelection Selection;
  dvec4 Eye = dvec4(0.0);
  CurveBuffers Buffers;
  bool NeedsCurves = true;
  bool NeedsRadii = true;
  bool NeedsFrames = true;
  InstanceBuffers Instances;
  vtkIdType NumberOfUploads = 0;
};
}

#endif
