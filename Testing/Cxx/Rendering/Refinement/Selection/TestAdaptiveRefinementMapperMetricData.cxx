// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a metric's shader gets its current data: changes of evaluator or data take effect,
// and a wrong size is an error.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "Compute/RefinementComputeProgram.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MetricShader.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
constexpr int MaximumLevel = 3;

// The shader takes levels from the data. The CPU uses the highest level everywhere, which shows who
// evaluates.
class DataMetric : public vtkDepthTagMetric
{
public:
  static DataMetric* New() { VTK_STANDARD_NEW_BODY(DataMetric); }
  vtkTypeMacro(DataMetric, vtkDepthTagMetric);

  bool IsViewDependent() override { return false; }
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;

  void SetLevel(float level, vtkIdType numberOfPoints)
  {
    this->Data =
      std::make_shared<std::vector<float>>(4 * static_cast<std::size_t>(numberOfPoints), level);
    this->Modified();
  }

  std::shared_ptr<const std::vector<float>> Data;
};

class DataEvaluator : public relevo::MetricEvaluator
{
public:
  DataEvaluator(DataMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(const relevo::RefinementView&, int maximumLevel, vtkFloatArray* tags) override
  {
    tags->SetNumberOfTuples(this->GetMesh().GetPolyData()->GetNumberOfPoints());
    tags->FillValue(static_cast<float>(maximumLevel));
    return true;
  }

  bool GetShader(
    const relevo::RefinementView&, int, const double[3], relevo::MetricShader& shader) override
  {
    shader.Source = R"(
vec4 metricValue(vec3 x, vec4 datum)
{
  return datum;
}
float metricPointMeasure(vec4 value)
{
  return value.x;
}
float metricEdgeMeasure(vec4 a, vec4 b)
{
  return 0.5 * (a.x + b.x);
}
float metricTag(float measure)
{
  return measure;
}
)";
    shader.Data = this->Metric->Data;
    return true;
  }

private:
  DataMetric* Metric;
};

std::unique_ptr<relevo::MetricEvaluator> DataMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<DataEvaluator>(this, mesh);
}

void TestRule(RelevoCheck& check, RelevoScene& scene, int rule)
{
  auto sphere = RelevoMeshes::Sphere(7, 6); // only triangles
  const vtkIdType points = sphere->GetNumberOfPoints();
  const vtkIdType faces = sphere->GetNumberOfPolys();
  vtkNew<DataMetric> metric;
  metric->SetLevel(1.0f, points);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(MaximumLevel);
  recipe->SetLevelRule(rule);
  recipe->SetMetric(metric);
  vtkActor* actor = scene.Add(sphere, recipe);
  auto* mapper = vtkAdaptiveRefinementMapper::SafeDownCast(actor->GetMapper());
  mapper->SetSelectionDeviceToGPU();
  mapper->FrustumCullingOff();
  scene.ResetCameras();
  const auto count = [&]
  {
    scene.Render();
    return mapper->GetNumberOfDrawnTriangles();
  };
  CHECK_EQUAL(count(), 4 * faces);
  metric->SetLevel(2.0f, points);
  CHECK_EQUAL(count(), 16 * faces);
  metric->SetLevel(1.0f, points);
  CHECK_EQUAL(count(), 4 * faces);

  vtkNew<DataMetric> other;
  other->SetLevel(0.0f, points);
  recipe->SetMetric(other);
  CHECK_EQUAL(count(), faces);
  recipe->SetMetric(metric);
  CHECK_EQUAL(count(), 4 * faces);

  RelevoErrors errors(mapper);
  metric->SetLevel(1.0f, points - 1);
  CHECK_EQUAL(count(), 64 * faces);
  CHECK(errors.Said("Selection on the GPU failed: the metric's shader has data of " +
    std::to_string(4 * (points - 1)) + " floats, but " + std::to_string(4 * points)));
  scene.Renderer->RemoveActor(actor);
}
}

int TestAdaptiveRefinementMapperMetricData(int, char*[])
{
  RelevoCheck check;
  for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
  {
    CHECK_CASE(rule);
    RelevoScene scene(RelevoScene::Refining);
    scene.Render();
    if (!relevo::RefinementComputeProgram::IsSupported())
    {
      std::cout << "The context has no OpenGL 4.3: skipped." << std::endl;
      return 125;
    }
    TestRule(check, scene, rule);
  }
  return check.GetResult();
}
