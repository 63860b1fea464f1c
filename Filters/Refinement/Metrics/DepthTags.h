// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads depth-tags from an array or a metric and checks them
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
 * Copy an array of depth-tags to `tags`, which has room for one per point. Returns false and sets
 * `error` if it is not numeric, does not have one component and one tuple per point, or contains
 * NaN. Values are only limited so that the mean of any two is finite.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool TakeDepthTags(
  vtkAbstractArray* array, vtkIdType numberOfPoints, float* tags, std::string& error);

/**
 * Compute the depth-tags of the points of an evaluator's mesh, or of its edges (`perEdge`). Returns
 * false and sets `error` if the metric fails, returns the wrong number of tags or returns NaN.
 * Values are limited as in TakeDepthTags().
 */
RELEVOFILTERSREFINEMENT_EXPORT bool ComputeDepthTags(MetricEvaluator& evaluator,
  const RefinementView& view, int maximumLevel, bool perEdge, vtkFloatArray* tags,
  std::string& error);

/// The error if a metric returned false after reporting an error.
std::string GetNoTagsError(vtkDepthTagMetric* metric);

/**
 * Set the tag of each edge to the mean of the tags of its two merged points, each with the largest
 * tag of its coincident points. Modifies the tags of points. Returns false after reporting an error
 * of the metric if there is not one tag per point.
 */
bool TagEdgesByPoints(vtkDepthTagMetric* metric, const SurfaceEdges& edges,
  vtkFloatArray* pointTags, vtkFloatArray* tags);
}

#endif
