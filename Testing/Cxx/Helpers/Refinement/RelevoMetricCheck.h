// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Helpers for the tests of depth-tag metrics.
#ifndef RelevoMetricCheck_h
#define RelevoMetricCheck_h

#include "RelevoTestMeshes.h"

#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricCache.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <random>
#include <vector>

// The tags, or none if the metric fails.
std::vector<float> TagsOf(vtkDepthTagMetric* metric, vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel);

// The tags of edges, or none if the metric fails.
std::vector<float> EdgeTagsOf(vtkDepthTagMetric* metric, vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel, const relevo::SurfaceEdges& edges);

// Evaluates a metric like mappers and filters do, with a cached evaluator.
class KeptMetric
{
public:
  explicit KeptMetric(vtkDepthTagMetric* metric);

  // The tags, or none if the metric fails.
  std::vector<float> GetTags(
    vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel);
  std::vector<float> GetEdgeTags(
    vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel);

private:
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  relevo::MetricCache Source;
};

// A camera at (0, 0, 2) that looks at the origin, with a view angle of 90 degrees and a height of
// 400 pixels: 100 pixels per unit at the origin.
struct FrontView
{
  FrontView();
  FrontView(const FrontView&) = delete;
  void operator=(const FrontView&) = delete;

  vtkNew<vtkCamera> Camera;
  relevo::RefinementView View;
};

bool AreLevels(const std::vector<float>& tags, vtkIdType number, int maximumLevel);

// In [-1, 1].
double Random(std::mt19937& random);

// Places the camera around the unit sphere, sometimes inside.
void PlaceAtRandom(vtkCamera* camera, std::mt19937& random);

// Whether every degenerate mesh and camera gives levels or an error without hanging.
bool SurvivesOddMeshes(vtkDepthTagMetric* metric);

#endif
