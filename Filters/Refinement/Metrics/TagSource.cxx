// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/TagSource.h"

#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "vtkDepthTagMetric.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace relevo
{
TagSource::TagSource()
  : Mesh(new MetricMesh)
{
}

TagSource::~TagSource() = default;

MetricMesh& TagSource::GetMesh(vtkPolyData* mesh)
{
  this->Mesh->Update(mesh);
  return *this->Mesh;
}

MetricEvaluator& TagSource::GetEvaluator(vtkDepthTagMetric* metric, vtkPolyData* mesh)
{
  this->Mesh->Update(mesh);
  if (this->Metric != metric)
  {
    this->Metric = metric;
    this->Evaluator = MakeEvaluator(metric, this->Mesh);
  }
  return *this->Evaluator;
}

TagSources::TagSources() = default;
TagSources::~TagSources() = default;

const std::shared_ptr<TagSource>& TagSources::Find(vtkPolyData* mesh)
{
  const auto isGone = [](const auto& source) { return !source.first; };
  this->Sources.erase(
    std::remove_if(this->Sources.begin(), this->Sources.end(), isGone), this->Sources.end());
  auto found = std::find_if(this->Sources.begin(), this->Sources.end(),
    [mesh](const auto& source) { return source.first == mesh; });
  if (found == this->Sources.end())
  {
    found = this->Sources.insert(found, { mesh, std::make_shared<TagSource>() });
  }
  return found->second;
}
}
