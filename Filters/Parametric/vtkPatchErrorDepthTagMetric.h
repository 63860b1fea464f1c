// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchErrorDepthTagMetric
 * @brief   refines patches and curves until they deviate by less than a part of a pixel
 *
 * For the surfaces of vtkPatchSurfaceFilter, by vtkDepthTagMetric's rule PER_EDGE. The level of an
 * edge is log2 of a number of segments, one that the recipe's patterns have, such that no triangle
 * of the faces at it is farther from the patch than ScreenSpaceError, as long as MaximumLevel
 * allows; where patterns morph it is half a level more, for their vertices to have arrived. It is
 * a bound, also of rational patches. What is measured is the distance from a point of a triangle to
 * the point of the patch with the same parameters: that to the nearest point of the patch is no
 * larger.
 *
 * A bound of an edge's own curve C, cut into n equal segments, is
 *
 *     max |C''| / (8 n^2)
 *
 * and its number of segments at least the one by this. Inside, a triangle that spans the part r_c
 * of the weight of each of its face's corners c deviates by no more than
 *
 *     (F_0 r_0^2 + F_1 r_1^2 + F_2 r_2^2) / 8
 *
 * where F is such that for all directions d of the face's barycentric coordinates the second
 * derivative of the patch is no longer than F_0 d_0^2 + F_1 d_1^2 + F_2 d_2^2 (after Filip,
 * Magedson and Markot 1986, "Surface algorithms using bounds on derivatives", whose bound
 * (l_1^2 M_11 + 2 l_1 l_2 M_12 + l_2^2 M_22) / 8 is of right-angled triangles). Of the F that
 * satisfy this, one of least sum is taken. Derivatives are bounded by differences of control
 * points, of the face itself rather than of all of the patch; of rational ones S = A / w by
 *
 *     |S_de| <= (|A_de| + |w_d| |S_e| + |w_e| |S_d| + |w_de| max |S|) / min w
 *
 * on parts of the face, relative to the middle of each. The triangles are those of the pattern
 * itself: where its edges differ, they can be longer than 1 / n of the least n. So, from
 * the numbers of segments of the curves on, the least edges of faces that deviate too much get more
 * until none does.
 *
 * A length takes no more pixels than h / (2 tan(a / 2) z cos t) times as many, h being the height
 * of the viewport, a the camera's view angle, z the least depth of the control points of the face
 * along the direction of view, and t the largest angle from this direction at which they are seen
 * in the viewport; with a horizontal view angle the width counts. Where the eye is among the
 * control points edges have MaximumLevel. With a parallel camera h / (2 ParallelScale). The actor's
 * matrix counts, by the most that it stretches and the least.
 *
 * By the rule PER_VERTEX points have the largest level of the edges at them: edges are then as fine
 * as by PER_EDGE, but the insides are not looked at again. LevelOffset, and a number of triangles
 * or a time to keep to, move levels away from the bound; so does the tessellator, whose triangles
 * are others. Displacement is not measured.
 *
 * Curves: in a mesh with lines, each of 2 to 9 points, these are the control polygons of Bezier
 * curves, rational ones if there is an attribute RationalWeights (see vtkDataSetAttributes).
 * ComputeTags() gives each point the level of its curve, the largest of several.
 *
 * The metric depends on the view: no camera, one whose position is its focal point, and a viewport
 * without pixels are errors; so is a mesh of triangles that are no patches. A triangle or curve
 * with a point that is not finite, or with a weight of 0 or less, adds nothing: a level of 0.
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
   * The largest deviation, in pixels: 0.001 to 1e6, default 0.5. Another value is an error and
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
