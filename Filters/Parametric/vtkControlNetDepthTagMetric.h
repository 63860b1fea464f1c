// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkControlNetDepthTagMetric
 * @brief   refine patches according to the curvature of their control nets
 *
 * This is the patch curvature of Nellmeldin 2013 ("Desarrollo de algoritmos de teselacion
 * adaptativa en GPU"). The control net consists of quadrilaterals, or of triangles for triangular
 * patches, each with a normal. The curvature of a patch is the largest angle between the normals of
 * two adjacent elements. With low = MinimumAngle and high = MaximumAngle, the depth-tag is
 *
 *     level = MaximumLevel * (angle - low) / (high - low)
 *
 * clamped to the range from 0 to MaximumLevel. Flat patches, and patches of degree 1 in both
 * directions, have level 0. The normal of a quadrilateral is the cross product of its diagonals.
 * Elements without area are ignored.
 *
 * The metric requires a mesh of vtkPatchSurfaceFilter. Another mesh, or a MinimumAngle above
 * MaximumAngle, is an error. An edge or point has the largest level of its patches. The metric does
 * not depend on the view.
 *
 * @sa vtkPatchErrorDepthTagMetric vtkCurvatureDepthTagMetric
 */
#ifndef vtkControlNetDepthTagMetric_h
#define vtkControlNetDepthTagMetric_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSPARAMETRIC_EXPORT vtkControlNetDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkControlNetDepthTagMetric* New();
  vtkTypeMacro(vtkControlNetDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the angle in degrees up to which the level is 0; 0 to 180, default 0. Another value is an
   * error and changes nothing.
   */
  void SetMinimumAngle(double degrees);
  vtkGetMacro(MinimumAngle, double);
  //@}

  //@{
  /**
   * Set the angle in degrees from which on the level is MaximumLevel; 0 to 180, default 90. Another
   * value is an error and changes nothing.
   */
  void SetMaximumAngle(double degrees);
  vtkGetMacro(MaximumAngle, double);
  //@}

  bool IsViewDependent() override { return false; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkControlNetDepthTagMetric();
  ~vtkControlNetDepthTagMetric() override;

  double MinimumAngle = 0.0;
  double MaximumAngle = 90.0;

private:
  vtkControlNetDepthTagMetric(const vtkControlNetDepthTagMetric&) = delete;
  void operator=(const vtkControlNetDepthTagMetric&) = delete;
};

#endif
