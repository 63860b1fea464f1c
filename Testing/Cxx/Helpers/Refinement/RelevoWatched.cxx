// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoWatched.h"

#include "RelevoTestMeshes.h"

#include "Metrics/MetricMesh.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
class WatchedEvaluator : public relevo::MetricEvaluator
{
public:
  WatchedEvaluator(RelevoWatchedMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
    ++this->Metric->LivingEvaluators;
  }

  ~WatchedEvaluator() override { --this->Metric->LivingEvaluators; }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    ++this->Metric->Evaluations;
    vtkPolyData* mesh = this->GetMesh().GetPolyData();
    if (this->MeshTime != this->GetMesh().GetTime())
    {
      ++this->Metric->Preparations;
      this->MeshTime = this->GetMesh().GetTime();
      mesh->GetCenter(this->Center);
    }
    const double* eye = view.Camera->GetPosition();
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(eye, this->Center));
    tags->SetNumberOfComponents(1);
    tags->SetNumberOfTuples(mesh->GetNumberOfPoints());
    tags->FillComponent(0, std::max(maximumLevel - 0.2 * distance, 0.0));
    return true;
  }

private:
  vtkSmartPointer<RelevoWatchedMetric> Metric;
  vtkMTimeType MeshTime = 0;
  double Center[3] = { 0.0, 0.0, 0.0 };
};
}

RelevoWatchedFloats* RelevoWatchedFloats::New()
{
  VTK_STANDARD_NEW_BODY(RelevoWatchedFloats);
}

double* RelevoWatchedFloats::GetTuple(vtkIdType tuple)
{
  ++GetReads();
  return this->Superclass::GetTuple(tuple);
}

void RelevoWatchedFloats::GetTuple(vtkIdType tuple, double* values)
{
  ++GetReads();
  this->Superclass::GetTuple(tuple, values);
}

std::atomic<long>& RelevoWatchedFloats::GetReads()
{
  static std::atomic<long> reads(0);
  return reads;
}

RelevoWatchedMetric* RelevoWatchedMetric::New()
{
  VTK_STANDARD_NEW_BODY(RelevoWatchedMetric);
}

std::unique_ptr<relevo::MetricEvaluator> RelevoWatchedMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  ++this->Evaluators;
  return std::make_unique<WatchedEvaluator>(this, mesh);
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeWatchedBlocks(int side)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int i = 0; i < side * side; ++i)
  {
    auto block = RelevoMeshes::Sphere(7, 6);
    vtkNew<RelevoWatchedFloats> coordinates;
    coordinates->DeepCopy(block->GetPoints()->GetData());
    for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
    {
      coordinates->SetComponent(point, 0, coordinates->GetComponent(point, 0) + 1.2 * (i % side));
      coordinates->SetComponent(point, 1, coordinates->GetComponent(point, 1) + 1.2 * (i / side));
    }
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    block->SetPoints(points);
    blocks->SetBlock(static_cast<unsigned int>(i), block);
  }
  return blocks;
}
