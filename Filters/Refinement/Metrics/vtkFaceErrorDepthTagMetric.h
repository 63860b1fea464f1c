// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFaceErrorDepthTagMetric
 * @brief   superclass of metrics that limit how far refined faces deviate from a detailed surface
 *
 * It has the limits: ScreenSpaceError in pixels, or MaximumError in world units. Derived classes
 * define the surface.
 *
 * @sa vtkHeightErrorDepthTagMetric vtkMicroMeshErrorDepthTagMetric
 */
#ifndef vtkFaceErrorDepthTagMetric_h
#define vtkFaceErrorDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkFaceErrorDepthTagMetric : public vtkDepthTagMetric
{
public:
  vtkAbstractTypeMacro(vtkFaceErrorDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the largest deviation in pixels, 0.001 to 1e6. The default is 1. It is used if MaximumError
   * is 0. Values out of range are rejected with an error.
   */
  void SetScreenSpaceError(double pixels);
  vtkGetMacro(ScreenSpaceError, double);
  //@}

  //@{
  /**
   * Set the largest deviation in world units. With 0, the default, ScreenSpaceError is used.
   * Negative and non-finite values are rejected with an error.
   */
  void SetMaximumError(double length);
  vtkGetMacro(MaximumError, double);
  //@}

  //@{
  /**
   * Set whether edges with one face always have MaximumLevel, so that meshes with a common border
   * match. Off by default. Blocks of a mapper and pieces of a distributed mesh do not need it.
   */
  vtkSetMacro(MaximumLevelOnBorder, bool);
  vtkGetMacro(MaximumLevelOnBorder, bool);
  vtkBooleanMacro(MaximumLevelOnBorder, bool);
  //@}

  bool IsViewDependent() override { return this->MaximumError == 0.0; }
  bool IsPlacementDependent() override { return true; }
  bool IsAbsolute() override { return true; }

protected:
  vtkFaceErrorDepthTagMetric();
  ~vtkFaceErrorDepthTagMetric() override;

  double ScreenSpaceError = 1.0;
  double MaximumError = 0.0;
  bool MaximumLevelOnBorder = false;

private:
  vtkFaceErrorDepthTagMetric(const vtkFaceErrorDepthTagMetric&) = delete;
  void operator=(const vtkFaceErrorDepthTagMetric&) = delete;
};

#endif
