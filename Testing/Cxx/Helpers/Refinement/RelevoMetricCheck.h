// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of depth-tag metrics share.
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

// The tags, or none when the metric gave none.
std::vector<float> TagsOf(vtkDepthTagMetric* metric, vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel);

// The tags of edges, or none when the metric gave none.
std::vector<float> EdgeTagsOf(vtkDepthTagMetric* metric, vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel, const relevo::SurfaceEdges& edges);

// A metric as mappers and filters ask it, which keep its evaluator.
class KeptMetric
{
public:
  explicit KeptMetric(vtkDepthTagMetric* metric);

  // The tags, or none when the metric gave none.
  std::vector<float> GetTags(
    vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel);
  std::vector<float> GetEdgeTags(
    vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel);

private:
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  relevo::MetricCache Source;
};

// A camera at (0, 0, 2) that looks at the origin: 90 degrees and 400 pixels of height, there 100
// pixels for a unit.
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

// Around the unit sphere, sometimes within it.
void PlaceAtRandom(vtkCamera* camera, std::mt19937& random);

// Every broken mesh and camera gives levels or an error, and hangs nowhere.
bool SurvivesOddMeshes(vtkDepthTagMetric* metric);

#endif
