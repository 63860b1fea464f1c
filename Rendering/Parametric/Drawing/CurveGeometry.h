// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveGeometry
 * @brief   the curves of a data set with their radii, their selection for a view, and their buffers
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
  /// Set a data set. Return false if it is the current one and has not changed.
  bool SetCurves(vtkPointSet* input);
  vtkPointSet* GetInput() const { return this->Input; }
  const CurveMesh& GetMesh() const { return this->Mesh; }
  /// Return the origin of the control points on the GPU.
  const dvec3& GetOrigin() const { return this->Origin; }

  /// The shape of the curves.
  struct Shape
  {
    int Sides = 1; // 1: lines, 2: ribbons, more: tubes
    double Radius = 0.0;
    std::string RadiusArrayName;
  };
  /// Set the shape, after SetCurves(). Return false if it has not changed.
  bool SetShape(const Shape& shape);
  int GetSides() const { return this->Current.Sides; }
  /// Return the error of the array of radii, or "". With an error nothing can be drawn.
  const std::string& GetRadiusError() const { return this->RadiusError; }

  /// Compute the bounds of everything that is drawn; they are uninitialized if there is nothing to
  /// draw.
  void GetBounds(double bounds[6]) const;

  /// Select the curves and their segments for a view. Return the error of the recipe, or "".
  std::string Select(
    vtkAdaptiveRefinement* recipe, vtkRenderer* renderer, vtkActor* actor, bool isCulled);
  const CurveSelection& GetSelection() const { return this->Selection; }

  /// Upload the data that have changed; `withCells` includes ids of cells. Return false if OpenGL
  /// lacks memory.
  bool Upload(vtkOpenGLRenderWindow* window, bool withCells);
  const CurveBuffers& GetBuffers() const { return this->Buffers; }
  vtkIdType GetNumberOfUploads() const { return this->NumberOfUploads; }
  vtkTypeInt64 GetMemorySize() const;

  //@{
  /// Bind the curves, or the indices of the drawn curves, to programs.
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
  dvec3 Origin = dvec3(0.0); // the centre of the curves
  Dependencies ShapeSource;
  Shape Current;
  std::vector<double> Radii; // at control points; a single radius applies to all
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
