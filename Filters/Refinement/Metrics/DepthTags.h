// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   depth-tags that an array or a metric gives, checked
 */
#ifndef DepthTags_h
#define DepthTags_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <string> // for errors

class vtkAbstractArray;
class vtkDepthTagMetric;
class vtkFloatArray;

namespace relevo
{
struct RefinementView;
class MetricEvaluator;
class SurfaceEdges;

/**
 * Copy an array of depth-tags into `tags`, which has room for one per point. Returns false and sets
 * `error` when it holds no numbers, has not exactly one component and one tuple per point, or
 * holds a NaN. Values are limited only so far that the mean of any two is finite.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool TakeDepthTags(
  vtkAbstractArray* array, vtkIdType numberOfPoints, float* tags, std::string& error);

/**
 * Compute the depth-tags of the points of an evaluator's mesh, or of its edges (`perEdge`). Returns
 * false and sets `error` when the metric gives none, another number, or a NaN. Values are limited
 * as by TakeDepthTags().
 */
RELEVOFILTERSREFINEMENT_EXPORT bool ComputeDepthTags(MetricEvaluator& evaluator,
  const RefinementView& view, int maximumLevel, bool perEdge, vtkFloatArray* tags,
  std::string& error);

/// The error where a metric returned false, after an ErrorEvent of its own.
std::string GetNoTagsError(vtkDepthTagMetric* metric);

/**
 * Give every edge the mean of the tags of its two places, the larger tags where points coincide.
 * The tags of points are united on the way. False, after an ErrorEvent of the metric that gave
 * them, if points have not one tag each.
 */
bool TagEdgesByPoints(vtkDepthTagMetric* metric, const SurfaceEdges& edges,
  vtkFloatArray* pointTags, vtkFloatArray* tags);
}

#endif
