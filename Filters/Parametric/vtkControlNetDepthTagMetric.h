// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkControlNetDepthTagMetric
 * @brief   refines patches whose control nets are bent
 *
 * The patch curvature of Nellmeldin 2013 ("Desarrollo de algoritmos de teselacion adaptativa en
 * GPU"): the control net is taken as quads, those of triangles as triangles, with a normal each; a
 * patch is as curved as the largest angle between normals of two that share a side. With this
 * angle, low = MinimumAngle and high = MaximumAngle the depth-tag is
 *
 *     level = MaximumLevel * (angle - low) / (high - low)
 *
 * clamped: 0 at the low angle and below, MaximumLevel at the high one and above, linear between.
 * Flat patches have level 0, also those that the degrees 1 leave one quad of. The normal of a quad
 * is the product of its diagonals; quads and triangles without area are left out.
 *
 * For the surfaces of vtkPatchSurfaceFilter; another mesh is an error, and so is MinimumAngle above
 * MaximumAngle. An edge, or a point, has the largest level of the patches that meet there. The
 * metric does not depend on the view.
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
   * Angle in degrees up to which the level is 0; 0 to 180, default 0. Another value is an error and
   * changes nothing.
   */
  void SetMinimumAngle(double degrees);
  vtkGetMacro(MinimumAngle, double);
  //@}

  //@{
  /**
   * Angle in degrees from which on the level is MaximumLevel; 0 to 180, default 90. Another value
   * is an error and changes nothing.
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
