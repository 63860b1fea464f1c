// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoMetricCheck.h"

#include "Metrics/MetricEvaluator.h"

#include <limits>

namespace
{
// The tags, or none if they could not be computed.
std::vector<float> Take(bool computed, vtkFloatArray* tags)
{
  const float* values = tags->GetPointer(0);
  return std::vector<float>(values, values + (computed ? tags->GetNumberOfTuples() : 0));
}
}

std::vector<float> TagsOf(vtkDepthTagMetric* metric, vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel)
{
  vtkNew<vtkFloatArray> tags;
  return Take(metric->ComputeTags(mesh, view, maximumLevel, tags), tags);
}

std::vector<float> EdgeTagsOf(vtkDepthTagMetric* metric, vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel, const relevo::SurfaceEdges& edges)
{
  vtkNew<vtkFloatArray> tags;
  return Take(metric->ComputeEdgeTags(mesh, view, maximumLevel, edges, tags), tags);
}

KeptMetric::KeptMetric(vtkDepthTagMetric* metric)
  : Metric(metric)
{
}

std::vector<float> KeptMetric::GetTags(
  vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel)
{
  vtkNew<vtkFloatArray> tags;
  relevo::MetricEvaluator& evaluator = this->Source.GetEvaluator(this->Metric, mesh);
  return Take(evaluator.ComputeTags(view, maximumLevel, tags), tags);
}

std::vector<float> KeptMetric::GetEdgeTags(
  vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel)
{
  vtkNew<vtkFloatArray> tags;
  relevo::MetricEvaluator& evaluator = this->Source.GetEvaluator(this->Metric, mesh);
  return Take(evaluator.ComputeEdgeTags(view, maximumLevel, tags), tags);
}

FrontView::FrontView()
{
  this->Camera->SetPosition(0, 0, 2);
  this->Camera->SetFocalPoint(0, 0, 0);
  this->Camera->SetViewUp(0, 1, 0);
  this->Camera->SetViewAngle(90);
  this->Camera->SetClippingRange(0.1, 100.0);
  this->View.Camera = this->Camera;
  this->View.ViewportSize[0] = 640;
  this->View.ViewportSize[1] = 400;
}

bool AreLevels(const std::vector<float>& tags, vtkIdType number, int maximumLevel)
{
  bool good = static_cast<vtkIdType>(tags.size()) == number;
  for (float tag : tags)
  {
    good = good && tag >= 0.0f && tag <= static_cast<float>(maximumLevel);
  }
  return good;
}

double Random(std::mt19937& random)
{
  return random() / 2147483648.0 - 1.0;
}

void PlaceAtRandom(vtkCamera* camera, std::mt19937& random)
{
  camera->SetPosition(3 * Random(random), 3 * Random(random), 3 * Random(random));
  camera->SetFocalPoint(Random(random), Random(random), Random(random));
  camera->SetViewUp(Random(random), Random(random), Random(random));
  camera->SetClippingRange(0.01, 20.0);
  camera->SetParallelProjection(random() % 2);
}

bool SurvivesOddMeshes(vtkDepthTagMetric* metric)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<RelevoMeshes::Mesh> meshes{ RelevoMeshes::Make(), RelevoMeshes::Mixed(),
    RelevoMeshes::NonManifold(), RelevoMeshes::Moebius(), RelevoMeshes::Slivers(),
    RelevoMeshes::Strips(), RelevoMeshes::Cone() };
  meshes.push_back(RelevoMeshes::FromTriangles(
    { { { nan, 0, 0 } }, { { 1, infinity, 0 } }, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } },
      { { 0, 0, 0 } }, { { 1e300, 1e300, 0 } } },
    { { { 0, 1, 2 } }, { { 2, 3, 4 } }, { { 2, 5, 3 } }, { { 2, 3, 6 } }, { { 2, 3, 99 } } }));
  meshes.push_back(RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } }, { { 0, 2, 1 } } }));
  std::mt19937 random(3);
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
  view.Camera = camera;
  for (vtkPolyData* mesh : meshes)
  {
    const relevo::SurfaceEdges edges(mesh);
    for (int i = 0; i < 20; ++i)
    {
      PlaceAtRandom(camera, random);
      if (i % 2 && mesh->GetNumberOfPoints() > 2)
      {
        camera->SetPosition(mesh->GetPoint(2)); // the eye at a vertex
      }
      if (!AreLevels(TagsOf(metric, mesh, view, 5), mesh->GetNumberOfPoints(), 5) ||
        !AreLevels(EdgeTagsOf(metric, mesh, view, 5, edges), edges.GetNumberOfEdges(), 5))
      {
        return false;
      }
    }
  }
  return true;
}
