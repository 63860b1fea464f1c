// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightErrorDepthTagMetric
 * @brief   refine a displaced surface to an error in pixels or world units
 *
 * The recipe must have a vtkDisplacement with a height map. The metric chooses levels for which no
 * point of a drawn triangle deviates too much from the surface that is displaced by the full height
 * map. The deviation is the distance to the point of the surface with the same position on the
 * coarse face, so for terrain it is vertical. The distance to the nearest point of the surface is
 * not larger. The limit is ScreenSpaceError in pixels, or MaximumError in world units. Where
 * MaximumLevel of the recipe is too low for the limit, edges have MaximumLevel.
 *
 * A height map is bilinear between the centres of its texels. On a flat coarse face with one
 * direction of displacement, the metric measures the largest deviation of a pattern exactly: it
 * visits each texel, each crossing of a triangle's side with a line between texels, and the extreme
 * between two crossings. On other faces, it also visits the points of a lattice, and adds a bound
 * for the curvature between them. It measures the patterns in use, also those whose edges have
 * different levels, and caches the results per face.
 *
 * All edges start with one segment. While a face deviates too much, the edges that deviate get more
 * segments, or else the edges of the face with the fewest. An edge therefore has one level in all
 * its faces. With LevelRule PER_EDGE this takes fewer triangles. With PER_VERTEX the points get
 * higher tags instead, and the limit also holds.
 *
 * One unit of length covers at most h / (2 tan(a / 2) z cos t) pixels, as in
 * vtkPatchErrorDepthTagMetric, for the bounding box of each displaced face. With a parallel camera,
 * the number is h / (2 ParallelScale). If the camera is inside of the box of a face that is not
 * plane, its edges have MaximumLevel. The largest scale factor of the actor's matrix is included.
 *
 * Cells with missing samples are not measured. If NoDataPolicy of the displacement is HOLE, a
 * triangle that is removed although it contains data deviates by the length of its longest side, so
 * that the rims of holes are refined to the size of a texel. At a texture seam, a step between the
 * heights of both sides is ignored.
 *
 * With geomorphing, half a level is added, so that the vertices are in their final position.
 * LevelOffset, triangle budgets and time budgets change the levels, so that the limit no longer
 * holds. It holds for METHOD_ARKFPI and METHOD_ARK of vtkAdaptiveRefinementMapper and for
 * vtkAdaptiveRefinementFilter. The other methods generate other triangles.
 *
 * The blocks of a composite data set in a mapper and the pieces of a distributed mesh match,
 * because edges with one face have MaximumLevel there. For a filter and for separate meshes with a
 * common border, call MaximumLevelOnBorderOn().
 *
 * The metric depends on the view, unless MaximumError is set. It reports an error if the recipe has
 * no height map, or if it depends on the view and there is no camera or the viewport is empty.
 *
 * @sa vtkDisplacement vtkAdaptiveRefinement vtkPatchErrorDepthTagMetric
 */
#ifndef vtkHeightErrorDepthTagMetric_h
#define vtkHeightErrorDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkFaceErrorDepthTagMetric.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkHeightErrorDepthTagMetric
  : public vtkFaceErrorDepthTagMetric
{
public:
  static vtkHeightErrorDepthTagMetric* New();
  vtkTypeMacro(vtkHeightErrorDepthTagMetric, vtkFaceErrorDepthTagMetric);

  bool IsDisplacementDependent() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkHeightErrorDepthTagMetric();
  ~vtkHeightErrorDepthTagMetric() override;

private:
  vtkHeightErrorDepthTagMetric(const vtkHeightErrorDepthTagMetric&) = delete;
  void operator=(const vtkHeightErrorDepthTagMetric&) = delete;
};

#endif
