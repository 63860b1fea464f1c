// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMicroMeshErrorDepthTagMetric
 * @brief   refine a micro-mesh to an error in pixels or world units
 *
 * The input must be the output of vtkMicroMeshFilter, and the surface of the recipe a
 * vtkMicroMeshSurface. The metric chooses levels for which no point of a drawn triangle deviates
 * too much from the stored surface, which has all displacements. The deviation is the distance to
 * the point of the surface with the same weights; the distance to the nearest point is not larger.
 * The limit is ScreenSpaceError in pixels, or MaximumError in world units. The drawn surface is
 * then within the limit plus the error of vtkMicroMeshFilter of the dense mesh. Where MaximumLevel
 * of the recipe is too low for the limit, edges have MaximumLevel.
 *
 * vtkMicroMeshFilter stores the largest deviation of each face at each level. For faces with
 * different levels of edges, the metric measures the pattern at points of the grid, and where sides
 * of triangles cross lines of the grid. This is exact up to rounding. It caches the results.
 *
 * All edges start with one segment. While a face deviates too much, the edges that deviate get more
 * segments, or else the edges of the face with the fewest. An edge therefore has one level in all
 * its faces. With LevelRule PER_EDGE this takes fewer triangles. With PER_VERTEX the points get
 * higher tags instead, and the limit also holds.
 *
 * A length covers at most as many pixels as in vtkHeightErrorDepthTagMetric, for the bounding box
 * of each displaced face. If the camera is inside of the box, edges have MaximumLevel where the
 * face has displacements.
 *
 * With geomorphing, half a level is added, so that vertices are in their final position.
 * LevelOffset, triangle budgets, time budgets and a vtkDisplacement change the result, so that the
 * limit no longer holds. It holds for METHOD_ARKFPI and METHOD_ARK of vtkAdaptiveRefinementMapper
 * and for vtkAdaptiveRefinementFilter. The other methods generate other triangles.
 *
 * The blocks of a composite data set in a mapper match, because edges with one face have
 * MaximumLevel there. For a filter and for separate meshes with a common border, call
 * MaximumLevelOnBorderOn().
 *
 * The metric depends on the view, unless MaximumError is set. It reports an error if the mesh is
 * not a micro-mesh, or if it depends on the view and there is no camera or the viewport is empty.
 *
 * @sa vtkMicroMeshFilter vtkMicroMeshSurface vtkHeightErrorDepthTagMetric
 */
#ifndef vtkMicroMeshErrorDepthTagMetric_h
#define vtkMicroMeshErrorDepthTagMetric_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro
#include "vtkFaceErrorDepthTagMetric.h"

class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshErrorDepthTagMetric
  : public vtkFaceErrorDepthTagMetric
{
public:
  static vtkMicroMeshErrorDepthTagMetric* New();
  vtkTypeMacro(vtkMicroMeshErrorDepthTagMetric, vtkFaceErrorDepthTagMetric);

#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkMicroMeshErrorDepthTagMetric();
  ~vtkMicroMeshErrorDepthTagMetric() override;

private:
  vtkMicroMeshErrorDepthTagMetric(const vtkMicroMeshErrorDepthTagMetric&) = delete;
  void operator=(const vtkMicroMeshErrorDepthTagMetric&) = delete;
};

#endif
