// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContourTags
 * @brief   tags of edges by how near they are to the contour of a surface
 *
 * The criterion CONTOUR of vtkSilhouetteDepthTagMetric. A triangle's cosine at any of its edges is
 * the height of the eye over its plane, the same for all three, over the eye's distance from the
 * edge. So a height is computed per triangle, and little is left per edge.
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
  /// ComputeTags() of an evaluator whose GetShader() gives parameters 0 to 8 and, as 9.x, the
  /// cosine at which levels end.
  bool TagPoints(
    MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel, vtkFloatArray* tags);
  /// ComputeEdgeTags().
  bool TagEdges(
    MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel, vtkFloatArray* tags);

private:
  void UpdateNormals(MetricMesh& mesh, const RefinementView& view);
  void ComputeOffsets(MetricMesh& mesh);
  void ComputeHeights(MetricMesh& mesh);
  void MeasureEdges(const SurfaceEdges& edges, vtkFloatArray* measures) const;

  MetricShader Shader;
  std::vector<vec3> Offsets; // of points from the eye, in the world's axes
  std::vector<vec3> Normals; // of triangles, of unit length in the world
  Dependencies NormalDependencies;
  std::vector<float> Heights; // of the eye over triangles
  vtkNew<vtkFloatArray> EdgeTags;
};
}

#endif
