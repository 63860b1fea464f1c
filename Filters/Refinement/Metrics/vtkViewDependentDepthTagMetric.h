// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentDepthTagMetric
 * @brief   refine curved parts, most where they are seen edge-on
 *
 * This metric follows the aim of the metric of Boubekeur 2010 ("A view-dependent adaptivity metric
 * for real time mesh tessellation"). Levels are low where the surface is flat or faces the eye, and
 * high where its normals spread and on its silhouette. The formula differs from the one printed in
 * Nellmeldin 2013 (eqs. 3 to 9), which has the unit 1 over length and is lowest on silhouettes.
 * This one has no unit and rises with both. With these values at a point, in world coordinates,
 *
 *     n       the unit mean of the normals of the triangles that meet there, weighted by area
 *     spread  the largest angle between n and one of these normals
 *     edgeOn  1 - |n . v|, v the unit vector to the eye: 0 seen from the front or back, 1 edge-on
 *     w       EdgeOnWeight
 *
 * the depth-tag is
 *
 *     level = MaximumLevel * min(1, spread / MaximumSpread * (1 - w + w * edgeOn))
 *
 * A flat surface has level 0 from every direction. A surface that is bent by MaximumSpread has
 * MaximumLevel on the silhouette, and (1 - w) of it where it faces the eye. With the rule PER_EDGE,
 * an edge has the larger level of its two ends.
 *
 * Adjacent triangles must have the same winding. Coincident points are merged. With a parallel
 * camera, v is the same everywhere. A point at the eye is treated as seen edge-on. If the normals
 * at a point cancel out, the spread is 180 degrees and the point is treated as seen edge-on.
 * Triangles without area have no normal. Points without other triangles have level 0.
 *
 * The metric depends on the view. Computing tags fails with an error if there is no camera or if
 * its position is its focal point.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkSilhouetteDepthTagMetric
 */
#ifndef vtkViewDependentDepthTagMetric_h
#define vtkViewDependentDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkViewDependentDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkViewDependentDepthTagMetric* New();
  vtkTypeMacro(vtkViewDependentDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the spread of normals at and above which a silhouette has MaximumLevel, in degrees, 0.01 to
   * 180. The default is 30. Values out of range are rejected with an error.
   */
  void SetMaximumSpread(double degrees);
  vtkGetMacro(MaximumSpread, double);
  //@}

  //@{
  /**
   * Set how much the level depends on the viewing angle, from 0 (not at all) to 1 (surfaces that
   * face the eye have level 0). The default is 0.5. Values out of range are rejected with an error.
   */
  void SetEdgeOnWeight(double weight);
  vtkGetMacro(EdgeOnWeight, double);
  //@}

  bool IsViewDependent() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkViewDependentDepthTagMetric();
  ~vtkViewDependentDepthTagMetric() override;

  double MaximumSpread = 30.0;
  double EdgeOnWeight = 0.5;

private:
  vtkViewDependentDepthTagMetric(const vtkViewDependentDepthTagMetric&) = delete;
  void operator=(const vtkViewDependentDepthTagMetric&) = delete;
};

#endif
