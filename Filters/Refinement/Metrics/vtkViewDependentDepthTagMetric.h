// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentDepthTagMetric
 * @brief   refines curved parts, most where they are seen edge-on
 *
 * Has the aim of the metric of Boubekeur 2010 ("A view-dependent adaptivity metric for real time
 * mesh tessellation"): low levels where the surface is flat or faces the eye, high ones where its
 * normals spread and where it is part of the silhouette. Its formula as printed in Nellmeldin 2013
 * (eqs. 3 to 9) is 1 over a length and lowest on silhouettes; this one has no unit and rises with
 * both. With, at a point, in world coordinates,
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
 * so that a flat surface has level 0 from everywhere, and one that is bent by MaximumSpread has
 * MaximumLevel on the silhouette and (1 - w) of it where it faces the eye. By the rule PER_EDGE an
 * edge has the larger of the levels of its two ends.
 *
 * Neighbouring triangles are taken to wind alike; points at the same coordinates are one point.
 * With a parallel camera v is the same everywhere. A point at the eye itself counts as seen
 * edge-on. Where normals cancel out the spread is 180 degrees, seen edge-on. Triangles of no area
 * have no normal; a point of no other triangle has level 0.
 *
 * The metric depends on the view: no camera, or one whose position is its focal point, is an error
 * when tags are computed.
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
   * Spread of normals, in degrees, from which on a silhouette has MaximumLevel; 0.01 to 180,
   * default 30. Another value is an error and changes nothing.
   */
  void SetMaximumSpread(double degrees);
  vtkGetMacro(MaximumSpread, double);
  //@}

  //@{
  /**
   * How much the level depends on being seen edge-on: from 0, not at all, to 1, where what faces
   * the eye has level 0; default 0.5. Another value is an error and changes nothing.
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
