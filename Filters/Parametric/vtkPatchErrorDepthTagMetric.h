// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchErrorDepthTagMetric
 * @brief   refine patches and curves to a screen-space error
 *
 * The metric requires a mesh of vtkPatchSurfaceFilter. With the rule PER_EDGE of vtkDepthTagMetric,
 * the level of an edge is log2 of the number of segments. It is chosen among those of the recipe's
 * patterns so that no triangle of the adjacent faces deviates from the patch by more than
 * ScreenSpaceError, unless MaximumLevel is reached. With geomorphing, half a level is added, so
 * that the vertices are in their final position. ScreenSpaceError is a bound, also for rational
 * patches. It limits the distance between points of triangle and patch with the same parameters.
 * The distance to the nearest point of the patch is not larger.
 *
 * For the curve C of an edge with n equal segments, the deviation is at most
 *
 *     max |C''| / (8 n^2)
 *
 * which gives a lower bound for n. Inside of a face, let r_c be the range, within a triangle, of
 * the barycentric coordinate of corner c. The deviation of the triangle is at most
 *
 *     (F_0 r_0^2 + F_1 r_1^2 + F_2 r_2^2) / 8
 *
 * if the second derivative of the patch in each direction d of barycentric coordinates is not
 * longer than F_0 d_0^2 + F_1 d_1^2 + F_2 d_2^2. This extends the bound (l_1^2 M_11 + 2 l_1 l_2
 * M_12 + l_2^2 M_22) / 8 for right-angled triangles of Filip, Magedson and Markot 1986, "Surface
 * algorithms using bounds on derivatives". The metric uses the F with the smallest sum. Derivatives
 * are bounded by differences of the control points of the face, not of the whole patch. For
 * rational patches S = A / w the bound is
 *
 *     |S_de| <= (|A_de| + |w_d| |S_e| + |w_e| |S_d| + |w_de| max |S|) / min w
 *
 * on sub-faces, relative to the middle of each. The triangles are those of the pattern. If the
 * levels of its edges differ, they can be longer than 1 / n for the smallest n. So, starting from
 * the numbers of segments of the curves, the edges with the fewest segments of faces that deviate
 * too much get more segments until no face does.
 *
 * One unit of length covers at most h / (2 tan(a / 2) z cos t) pixels, where h is the height of the
 * viewport, a the view angle of the camera, z the smallest depth of the control points of the face
 * along the viewing direction, and t their largest angle from this direction within the viewport.
 * With a horizontal view angle, h is the width. With a parallel camera, the number is h / (2
 * ParallelScale). If the camera is inside of the bounding box of the control points, edges have
 * MaximumLevel. The largest and the smallest scale factor of the actor's matrix are included.
 *
 * With the rule PER_VERTEX, points have the largest level of their edges. Edges are then at least
 * as fine as with PER_EDGE, but the interior is not checked. LevelOffset, triangle budgets and time
 * budgets change the levels, so that the bound no longer applies. It does not apply to the hardware
 * tessellator either, which generates other triangles. Displacement is not included.
 *
 * Curves: in a mesh with lines of 2 to 9 points, each line is the control polygon of a Bézier
 * curve, rational if the points have the attribute RationalWeights (see vtkDataSetAttributes).
 * ComputeTags() gives each point the largest level of its curves.
 *
 * The metric depends on the view. It reports an error if there is no camera, its position is its
 * focal point, the viewport is empty, or the triangles of the mesh are not patches. Triangles and
 * curves with a point that is not finite, or a weight that is not positive, have level 0.
 *
 * @sa vtkPatchSurfaceFilter vtkControlNetDepthTagMetric vtkScreenEdgeDepthTagMetric
 */
#ifndef vtkPatchErrorDepthTagMetric_h
#define vtkPatchErrorDepthTagMetric_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSPARAMETRIC_EXPORT vtkPatchErrorDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkPatchErrorDepthTagMetric* New();
  vtkTypeMacro(vtkPatchErrorDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the largest deviation in pixels, 0.001 to 1e6, default 0.5. Another value is an error and
   * changes nothing.
   */
  void SetScreenSpaceError(double pixels);
  vtkGetMacro(ScreenSpaceError, double);
  //@}

  bool IsViewDependent() override { return true; }
  bool IsAbsolute() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkPatchErrorDepthTagMetric();
  ~vtkPatchErrorDepthTagMetric() override;

  double ScreenSpaceError = 0.5;

private:
  vtkPatchErrorDepthTagMetric(const vtkPatchErrorDepthTagMetric&) = delete;
  void operator=(const vtkPatchErrorDepthTagMetric&) = delete;
};

#endif
