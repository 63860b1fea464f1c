// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScreenEdgeDepthTagMetric
 * @brief   refine edges until their segments are a few pixels long
 *
 * With d the length in pixels of the longest edge at a point, projected to the screen, the
 * depth-tag of the point is
 *
 *     level = log2(max(1, d / ReferenceLength))
 *
 * and at most MaximumLevel. This is the tessellation level T = max(1, d / L_ref) of Nellmeldin 2013
 * ("Desarrollo de algoritmos de teselacion adaptativa en GPU", eq. 2), as a level with 2^level = T
 * segments. The level of an edge is the rounded mean of its two points' tags. Its segments are
 * therefore at most sqrt(2) ReferenceLength long on average, if MaximumLevel allows. With the rule
 * PER_EDGE, the level uses the d of the edge itself, which takes fewer triangles for segments of
 * the same length.
 *
 * Lengths are those of straight coarse edges, including the diagonals of the triangle fans of
 * polygons. The camera projects them to a viewport of the given size, also outside its border. With
 * a perspective camera, edges are first clipped at the near plane. With a parallel camera, edges
 * are not clipped. Points without triangles have level 0.
 *
 * With SetMeasureToSphereDiameter(), d is the projected diameter of the sphere around the edge: the
 * pixels of a unit length at distance 1, times |b - a| / |m|, with m the vector from the eye to the
 * edge's midpoint. With a parallel camera, it is the length in pixels of the edge seen from the
 * side. Edges seen end-on, where displaced or curved points may rise, are then refined too, which
 * matters most with the rule PER_EDGE. Edges beside or behind the eye have a finite d, which
 * matters for triangle budgets.
 *
 * The metric depends on the view. Computing tags fails with an error if there is no camera, if the
 * camera has no direction (its position is its focal point, or its view-up is along the view), or
 * if the viewport has no pixels.
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
   * Set the requested length of a segment in pixels, 0.01 to 1e6. The default is 10. Values out of
   * range are rejected with an error.
   */
  void SetReferenceLength(double pixels);
  vtkGetMacro(ReferenceLength, double);
  //@}

  /**
   * How the length of an edge is measured.
   */
  enum Measures
  {
    PROJECTED_LENGTH = 0,
    SPHERE_DIAMETER = 1
  };

  //@{
  /**
   * Set how the length of an edge is measured: PROJECTED_LENGTH (0, the default), or
   * SPHERE_DIAMETER (1), which does not depend on the direction of the edge. Other values are
   * rejected with an error.
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
