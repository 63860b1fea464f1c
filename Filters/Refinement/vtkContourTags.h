// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkContourTags
 * @brief   tags of edges by how near they are to the contour of a surface
 *
 * The criterion CONTOUR of vtkSilhouetteDepthTagMetric. A triangle's cosine at any of its edges is
 * the height of the eye over its plane, the same for all three, over the eye's distance from the
 * edge. So a height is computed per triangle, and little is left per edge.
 *
 * Private to the module's own sources.
 */
#ifndef vtkContourTags_h
#define vtkContourTags_h

#include "vtkLocalPoints.h"
#include "vtkMetricShader.h"
#include "vtkNew.h"
#include "vtkSurfaceEdges.h"
#include "vtkSurfaceNormals.h"

#include <vector> // for members

class vtkDepthTagMetric;
class vtkPolyData;
struct vtkRefinementView;

namespace relevo
{
class ContourTags
{
public:
  /// ComputeTags() of a metric whose GetShader() gives parameters 0 to 8 and, as 9.x, the cosine
  /// at which levels end.
  bool TagPoints(vtkDepthTagMetric* metric, vtkPolyData* mesh, const vtkRefinementView& view,
    int maximumLevel, vtkFloatArray* tags);
  /// ComputeEdgeTags().
  bool TagEdges(vtkDepthTagMetric* metric, vtkPolyData* mesh, const vtkRefinementView& view,
    int maximumLevel, const SurfaceEdges& edges, vtkFloatArray* tags);

private:
  void UpdateNormals(vtkPolyData* mesh, const vtkRefinementView& view);
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
