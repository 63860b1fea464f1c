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
 * two points' tags, thus leaves it segments of at most sqrt(2) ReferenceLength on the mean over
 * its length, as long as MaximumLevel allows. By the rule PER_EDGE the level is that of the edge's
 * own d: the segments are as long with fewer triangles.
 *
 * Lengths are those of the straight coarse edges (the diagonals of the triangle fans of polygons
 * included), projected by the camera to a viewport of the given size, also beyond its border. With
 * a perspective camera edges are cut at the near clipping plane first: what lies before it, or
 * behind the eye, has no length. With a parallel one nothing is cut. A point of no triangle has
 * level 0.
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

#include <memory> // for std::unique_ptr

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

  bool IsViewDependent() override { return true; }
  bool IsAbsolute() override { return true; }
  bool ComputeTags(vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel,
    vtkFloatArray* tags) override;
#ifndef __VTK_WRAP__
  bool ComputeEdgeTags(vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel,
    const relevo::SurfaceEdges& edges, vtkFloatArray* tags) override;
  bool GetShader(vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel,
    const double origin[3], relevo::MetricShader& shader) override;
#endif

protected:
  vtkScreenEdgeDepthTagMetric();
  ~vtkScreenEdgeDepthTagMetric() override;

  double ReferenceLength = 10.0;

private:
  vtkScreenEdgeDepthTagMetric(const vtkScreenEdgeDepthTagMetric&) = delete;
  void operator=(const vtkScreenEdgeDepthTagMetric&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
