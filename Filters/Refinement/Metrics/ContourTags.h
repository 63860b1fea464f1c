// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContourTags
 * @brief   tags of edges from their distance to the contour of a surface
 *
 * This implements the criterion CONTOUR of vtkSilhouetteDepthTagMetric. The cosine of a triangle at
 * one of its edges is the height of the eye above its plane, the same for all three edges, divided
 * by the eye's distance from the edge. The height is computed once per triangle, which leaves
 * little work per edge.
 */
#ifndef ContourTags_h
#define ContourTags_h

#include "Changes/Dependencies.h"
#include "Mathematics/RefinementMathematics.h"
#include "Metrics/MetricShader.h"
#include "vtkNew.h"

#include <vector> // for members

class vtkFloatArray;

namespace relevo
{
struct RefinementView;
class MetricEvaluator;
class MetricMesh;
class SurfaceEdges;
class ContourTags
{
public:
  /// Implements ComputeTags() of an evaluator whose GetShader() sets parameters 0 to 8 and, in 9.x,
  /// the cosine at which levels reach 0.
  bool TagPoints(
    MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel, vtkFloatArray* tags);
  /// Implements ComputeEdgeTags().
  bool TagEdges(
    MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel, vtkFloatArray* tags);

private:
  void UpdateNormals(MetricMesh& mesh, const RefinementView& view);
  void ComputeOffsets(MetricMesh& mesh);
  void ComputeHeights(MetricMesh& mesh);
  void MeasureEdges(const SurfaceEdges& edges, vtkFloatArray* measures) const;

  MetricShader Shader;
  std::vector<vec3> Offsets; // from the eye to points, along the world's axes
  std::vector<vec3> Normals; // unit normals of triangles in world coordinates
  Dependencies NormalDependencies;
  std::vector<float> Heights; // of the eye above triangles
  vtkNew<vtkFloatArray> EdgeTags;
};
}

#endif
