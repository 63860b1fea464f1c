// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScreenEdgeDepthTagMetric
 * @brief   refines edges until their segments are a few pixels long
 *
 * With d the length of an edge on the screen, in pixels, the depth-tag of a point is
 *
 *     level = log2(max(1, d / ReferenceLength))
 *
 * of the longest edge at the point, and at most MaximumLevel. That is the tessellation level
 * T = max(1, d / L_ref) of Nellmeldin 2013 ("Desarrollo de algoritmos de teselacion adaptativa en
 * GPU", eq. 2) as the level of 2^level = T segments. An edge's own level, the rounded mean of its
 * two points' tags, thus leaves it segments of at most sqrt(2) ReferenceLength on average, as far
 * as MaximumLevel allows. By the rule PER_EDGE the level is that of the edge's own d: the segments
 * are as long with fewer triangles.
 *
 * Lengths are those of the straight coarse edges (the diagonals of the triangle fans of polygons
 * included), projected by the camera to a viewport of the given size, also beyond its border. With
 * a perspective camera edges are cut at the near clipping plane first: what lies before it, or
 * behind the eye, has no length. With a parallel one nothing is cut. A point of no triangle has
 * level 0.
 *
 * With SetMeasureToSphereDiameter() d is the diameter, on the screen, of the sphere that has the
 * edge as a diameter: |b - a| / |m| times the pixels of a unit at a distance of 1, with m from the
 * eye to the edge's middle (with a parallel camera, the edge's length in pixels if it were seen
 * from the side). An edge seen end-on, above which displaced or curved points may rise, then gets
 * its segments, which matters most by the rule PER_EDGE; and no edge beside or behind the eye is
 * endless, which matters for budgets.
 *
 * The metric depends on the view. Errors when tags are computed: no camera, one with no direction
 * (its position is its focal point, or its view-up is along the view), a viewport without pixels.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkDistanceDepthTagMetric
 */
#ifndef vtkScreenEdgeDepthTagMetric_h
#define vtkScreenEdgeDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkScreenEdgeDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkScreenEdgeDepthTagMetric* New();
  vtkTypeMacro(vtkScreenEdgeDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Wanted length of a segment in pixels, 0.01 to 1e6; default 10. Another value is an error and
   * changes nothing.
   */
  void SetReferenceLength(double pixels);
  vtkGetMacro(ReferenceLength, double);
  //@}

  /**
   * What is measured of an edge.
   */
  enum Measures
  {
    PROJECTED_LENGTH = 0,
    SPHERE_DIAMETER = 1
  };

  //@{
  /**
   * PROJECTED_LENGTH (0, the default), the length of the edge's picture, or SPHERE_DIAMETER (1),
   * which does not depend on the edge's direction. Another value is an error and changes nothing.
   */
  void SetMeasure(int measure);
  vtkGetMacro(Measure, int);
  void SetMeasureToProjectedLength() { this->SetMeasure(PROJECTED_LENGTH); }
  void SetMeasureToSphereDiameter() { this->SetMeasure(SPHERE_DIAMETER); }
  //@}

  bool IsViewDependent() override { return true; }
  bool IsAbsolute() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkScreenEdgeDepthTagMetric();
  ~vtkScreenEdgeDepthTagMetric() override;

  double ReferenceLength = 10.0;
  int Measure = PROJECTED_LENGTH;

private:
  vtkScreenEdgeDepthTagMetric(const vtkScreenEdgeDepthTagMetric&) = delete;
  void operator=(const vtkScreenEdgeDepthTagMetric&) = delete;
};

#endif
