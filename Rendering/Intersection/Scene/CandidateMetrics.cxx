// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/CandidateMetrics.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCompositeDepthTagMetric.h"

#include <algorithm>

namespace relevo
{
namespace
{
vtkProximityDepthTagMetric* FindProximity(vtkDepthTagMetric* metric)
{
  vtkProximityDepthTagMetric* found = vtkProximityDepthTagMetric::SafeDownCast(metric);
  if (auto composite = vtkCompositeDepthTagMetric::SafeDownCast(metric))
  {
    for (int i = 0; i < composite->GetNumberOfMetrics() && !found; ++i)
    {
      found = FindProximity(composite->GetMetric(i));
    }
  }
  return found;
}

bool HasBoxes(vtkProximityDepthTagMetric* metric, const std::vector<Bounds>& boxes)
{
  if (metric->GetNumberOfBoxes() != static_cast<int>(boxes.size()))
  {
    return false;
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    Bounds box;
    metric->GetBox(static_cast<int>(i), box.data());
    if (box != boxes[i])
    {
      return false;
    }
  }
  return true;
}
}

void CandidateMetrics::Begin(double distance)
{
  this->Distance = distance;
  for (const auto& metric : this->Made)
  {
    if (metric)
    {
      metric->SetDistance(distance);
    }
  }
  this->Metrics.clear();
  this->Before.swap(this->Boxes);
  this->Boxes.clear();
}

void CandidateMetrics::AddActor(vtkActor* actor)
{
  vtkAdaptiveRefinement* recipe = FindRecipe(actor);
  if (!recipe)
  {
    return;
  }
  Metric metric = FindProximity(recipe->GetMetric());
  if (!recipe->GetMetric())
  {
    metric = Metric::New();
    metric->SetDistance(this->Distance);
    recipe->SetMetric(metric);
    this->Made.emplace_back(metric);
  }
  if (metric)
  {
    this->Metrics[actor] = metric;
    this->Boxes[metric];
  }
}

void CandidateMetrics::AddBox(vtkActor* actor, const Bounds& box)
{
  const auto found = this->Metrics.find(actor);
  if (found == this->Metrics.end())
  {
    return;
  }
  std::vector<Bounds>& boxes = this->Boxes[found->second];
  // The box is added once if both actors have the same metric.
  if (boxes.empty() || boxes.back() != box)
  {
    boxes.push_back(box);
  }
}

void CandidateMetrics::End()
{
  for (const auto& item : this->Before)
  {
    if (this->Boxes.count(item.first) == 0)
    {
      item.first->RemoveAllBoxes();
    }
  }
  this->Before.clear();
  for (const auto& item : this->Boxes)
  {
    if (!HasBoxes(item.first, item.second))
    {
      item.first->RemoveAllBoxes();
      for (const Bounds& box : item.second)
      {
        item.first->AddBox(box.data());
      }
    }
  }
  this->Made.erase(std::remove_if(this->Made.begin(), this->Made.end(),
                     [](const auto& metric) { return !metric; }),
    this->Made.end());
}
}
