// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveCurveRepresentation
 * @brief   draws line cells of any degree with a vtkAdaptiveCurveMapper
 *
 * The input is an unstructured grid, polygonal data, or a composite data set of them. Line cells of
 * all types are drawn: lines, poly-lines, quadratic edges, cubic lines, and Lagrange and Bézier
 * curves. Other cells are ignored; data without line cells give a warning. The number of segments
 * of each curve keeps its error on the screen below a bound in pixels.
 *
 * Colours, opacity, transforms and the visibility of blocks are those of
 * vtkGeometryRepresentationWithFaces. Blocks have no colours or opacities of their own, and
 * selections ignore curves. If ranks are blended, they are ordered by the regions of their data.
 *
 * @sa vtkAdaptiveCurveMapper vtkPatchErrorDepthTagMetric
 */
#ifndef vtkAdaptiveCurveRepresentation_h
#define vtkAdaptiveCurveRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkGeometryRepresentationWithFaces.h"

#include <memory> // for Internals

class vtkAdaptiveCurveMapper;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkAdaptiveCurveRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkAdaptiveCurveRepresentation* New();
  vtkTypeMacro(vtkAdaptiveCurveRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkAdaptiveCurveMapper* GetMapper();

  //@{
  /**
   * Set the largest distance on the screen between the drawn curves and the exact ones, in pixels:
   * at least 0.001, default 0.5. A value out of range is an error and changes nothing.
   */
  void SetScreenSpaceError(double pixels);
  double GetScreenSpaceError();
  //@}

  //@{
  /**
   * Set the shape of the curves: lines (0, the default), ribbons (1) or tubes (2); see
   * vtkAdaptiveCurveMapper. A value out of range is an error and changes nothing.
   */
  void SetCurveRepresentation(int representation);
  int GetCurveRepresentation();
  //@}

  //@{
  /// Set half the width of ribbons and tubes, in units of the data: at least 0, default 0.5.
  void SetRadius(double radius);
  double GetRadius();
  //@}

  //@{
  /// Set the point array of radii, which replace SetRadius(). "" (the default) uses none.
  void SetRadiusArrayName(const char* name);
  const char* GetRadiusArrayName();
  //@}

  //@{
  /// Set the number of sides of a tube: 3 to 64, default 8.
  void SetNumberOfSides(int sides);
  int GetNumberOfSides();
  //@}

  /// Does nothing, because there are no decimated curves.
  void SetSuppressLOD(bool suppress) override;

  /// Does nothing, because selections ignore curves.
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;

  void Update() override;
  using Superclass::Update;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkAdaptiveCurveRepresentation();
  ~vtkAdaptiveCurveRepresentation() override;

  bool AddToView(vtkView* view) override;

private:
  vtkAdaptiveCurveRepresentation(const vtkAdaptiveCurveRepresentation&) = delete;
  void operator=(const vtkAdaptiveCurveRepresentation&) = delete;

  void GiveBounds(vtkInformation* inInfo);
  int RequestRender(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
