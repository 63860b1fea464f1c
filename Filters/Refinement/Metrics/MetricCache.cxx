// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MetricCache.h"

#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkPolyData.h"

#include <iterator>
#include <utility>

namespace relevo
{
MetricCache::MetricCache()
{
  this->Clear();
}

MetricCache::~MetricCache() = default;

void MetricCache::SetWhole(std::shared_ptr<const GlobalSurfaceInfo> whole)
{
  if (whole && this->Whole && *whole == *this->Whole)
  {
    return;
  }
  this->Whole = std::move(whole);
  this->Mesh->SetWhole(this->Whole);
}

MetricMesh& MetricCache::GetMesh(vtkPolyData* mesh)
{
  this->Mesh->Update(mesh);
  return *this->Mesh;
}

MetricEvaluator& MetricCache::GetEvaluator(vtkDepthTagMetric* metric, vtkPolyData* mesh)
{
  this->Mesh->Update(mesh);
  if (!this->Evaluator || this->Evaluator->GetMetric() != metric)
  {
    this->Evaluator = MakeEvaluator(metric, this->Mesh);
  }
  return *this->Evaluator;
}

void MetricCache::Clear()
{
  this->Evaluator.reset();
  this->Mesh = std::make_shared<MetricMesh>();
  this->Mesh->SetWhole(this->Whole);
}

TagSources::TagSources() = default;
TagSources::~TagSources() = default;

const std::shared_ptr<MetricCache>& TagSources::Find(vtkAlgorithm* filter, vtkPolyData* mesh)
{
  // This time is equal for all blocks of an update and changes with the next update.
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive());
  const vtkMTimeType update = pipeline ? pipeline->GetPipelineMTime() : 0;
  const bool isNext = update != this->Update;
  if (isNext)
  {
    this->LastUpdate = this->Update;
    this->Update = update;
  }
  if (isNext || this->Sources.count(mesh) == 0)
  {
    this->DropUnused();
  }
  Entry& entry = this->Sources[mesh];
  if (!entry.Source)
  {
    entry.Source = std::make_shared<MetricCache>();
  }
  entry.Mesh = mesh;
  entry.Update = update;
  return entry.Source;
}

void TagSources::DropUnused()
{
  for (auto source = this->Sources.begin(); source != this->Sources.end();)
  {
    const Entry& entry = source->second;
    const bool isUsed =
      entry.Mesh && (entry.Update == this->Update || entry.Update == this->LastUpdate);
    source = isUsed ? std::next(source) : this->Sources.erase(source);
  }
}
}
