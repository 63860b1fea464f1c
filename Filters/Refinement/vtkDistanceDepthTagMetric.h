// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDistanceDepthTagMetric
 * @brief   refines what is near the camera
 *
 * With x the distance from the camera's position to a point, both in world coordinates (the
 * actor's matrix is applied to the point), the depth-tag is
 *
 *     level = MaximumLevel * (1 - x / MaximumDistance)
 *
 * and 0 where x exceeds MaximumDistance: MaximumLevel at the camera, linear between. That is the
 * tessellation level T = 64 - 63 x / d_max of Nellmeldin 2013 ("Desarrollo de algoritmos de
 * teselacion adaptativa en GPU", eq. 1), its range [1, 64] mapped linearly to [0, MaximumLevel].
 * As an edge has 2^level segments, its segments shorten geometrically towards the camera. By the
 * rule PER_EDGE an edge has the level of its end that is nearer to the camera.
 *
 * The metric depends on the view: without a camera it is an error. A point that is not finite gets
 * level 0.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkCurvatureDepthTagMetric
 */
#ifndef vtkDistanceDepthTagMetric_h
#define vtkDistanceDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

#include <memory> // for std::unique_ptr

class RELEVOFILTERSREFINEMENT_EXPORT vtkDistanceDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkDistanceDepthTagMetric* New();
  vtkTypeMacro(vtkDistanceDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Distance from the camera, in world units, from which on nothing is refined. 0, the default,
   * means automatic: three times the diagonal of the mesh's bounding box in world units, so that a
   * view of the whole mesh refines it moderately and a closer one more. A negative or infinite
   * value is an error and changes nothing.
   */
  void SetMaximumDistance(double distance);
  vtkGetMacro(MaximumDistance, double);
  //@}

  bool IsViewDependent() override { return true; }
  bool ComputeTags(vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel,
    vtkFloatArray* tags) override;
#ifndef __VTK_WRAP__
  bool ComputeEdgeTags(vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel,
    const relevo::SurfaceEdges& edges, vtkFloatArray* tags) override;
  bool GetShader(vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel,
    const double origin[3], relevo::MetricShader& shader) override;
#endif

protected:
  vtkDistanceDepthTagMetric();
  ~vtkDistanceDepthTagMetric() override;

  double MaximumDistance = 0.0;

private:
  vtkDistanceDepthTagMetric(const vtkDistanceDepthTagMetric&) = delete;
  void operator=(const vtkDistanceDepthTagMetric&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
