// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContourTags
 * @brief   tags of edges by how near they are to the contour of a surface
 *
 * The criterion CONTOUR of vtkSilhouetteDepthTagMetric. A triangle's cosine at any of its edges is
 * the height of the eye over its plane, the same for all three, over the eye's distance from the
 * edge. So a height is computed per triangle, and little is left per edge.
 *
 * Private to the module's own sources.
 */
#ifndef ContourTags_h
#define ContourTags_h

#include "Core/LocalPoints.h"
#include "Mesh/SurfaceEdges.h"
#include "Mesh/SurfaceNormals.h"
#include "Metrics/MetricShader.h"
#include "vtkNew.h"

#include <vector> // for members

class vtkDepthTagMetric;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
class ContourTags
{
public:
  /// ComputeTags() of a metric whose GetShader() gives parameters 0 to 8 and, as 9.x, the cosine
  /// at which levels end.
  bool TagPoints(vtkDepthTagMetric* metric, vtkPolyData* mesh, const RefinementView& view,
    int maximumLevel, vtkFloatArray* tags);
  /// ComputeEdgeTags().
  bool TagEdges(vtkDepthTagMetric* metric, vtkPolyData* mesh, const RefinementView& view,
    int maximumLevel, const SurfaceEdges& edges, vtkFloatArray* tags);

private:
  void UpdateNormals(vtkPolyData* mesh, const RefinementView& view);
  void ComputeOffsets();
  void ComputeHeights();
  void MeasureEdges(const SurfaceEdges& edges, vtkFloatArray* measures) const;

  LocalPoints Points;
  MetricShader Shader;
  SurfaceNormals Surface;
  dmat3 NormalToWorld{ 0.0 };
  std::vector<vec3> Offsets;  // of points from the eye, in the world's axes
  std::vector<vec3> Normals;  // of triangles, of unit length in the world
  std::vector<float> Heights; // of the eye over triangles
  SurfaceEdges Edges;
  vtkNew<vtkFloatArray> EdgeTags;
};
}

#endif
