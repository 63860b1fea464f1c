// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompositeDepthTagMetric.h"

#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Levels/LevelFunctions.h"
#include "Mathematics/RefinementMathematics.h"
#include "Metrics/DepthTags.h"
#include "Metrics/DisplacedSurface.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "View/RefinementView.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
constexpr double LargestWeight = 1e6;

// One of the metrics, evaluated for a mesh.
class Part
{
public:
  // Sets the metric, which may differ from the last one.
  void SetMetric(vtkDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
  {
    if (!this->Evaluator || this->Evaluator->GetMetric() != metric)
    {
      this->Evaluator = relevo::MakeEvaluator(metric, mesh);
      this->TagDependencies.Clear();
    }
  }

  // Computes the tags if they are out of date.
  bool Update(
    const relevo::RefinementView& view, int maximumLevel, bool perEdge, std::string& error)
  {
    vtkDepthTagMetric* metric = this->Evaluator->GetMetric();
    relevo::Dependencies dependencies = relevo::Dependencies::On(perEdge, maximumLevel);
    dependencies.AddObject(metric);
    dependencies.AddObject(this->Evaluator->GetMesh().GetPolyData());
    dependencies.Add(this->Evaluator->GetMesh().GetTime());
    if (metric->IsPlacementDependent() && view.ModelToWorld)
    {
      const double* matrix = view.ModelToWorld->GetData();
      std::for_each(matrix, matrix + 16, [&](double value) { dependencies.Add(value); });
    }
    if (metric->IsDisplacementDependent() && view.Displaced)
    {
      view.Displaced->AddTo(dependencies);
    }
    const bool changed = this->TagDependencies.Update(dependencies);
    if ((changed || metric->IsViewDependent()) &&
      !relevo::ComputeDepthTags(*this->Evaluator, view, maximumLevel, perEdge, this->Tags, error))
    {
      this->TagDependencies.Clear();
      return false;
    }
    return true;
  }

  vtkFloatArray* GetTags() const { return this->Tags; }
  relevo::MetricEvaluator& GetEvaluator() { return *this->Evaluator; }

private:
  std::unique_ptr<relevo::MetricEvaluator> Evaluator;
  vtkSmartPointer<vtkFloatArray> Tags = vtkSmartPointer<vtkFloatArray>::New();
  relevo::Dependencies TagDependencies; // except the view
};

class CompositeEvaluator : public relevo::MetricEvaluator
{
public:
  CompositeEvaluator(
    vtkCompositeDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
    , Mesh(mesh)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->UpdateParts(view, maximumLevel, false) && this->Combine(maximumLevel, tags);
  }

  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->UpdateParts(view, maximumLevel, true) && this->Combine(maximumLevel, tags);
  }

  void ShareNumbers(const relevo::RefinementView& view, const relevo::PieceReduction& pieces,
    relevo::GlobalSurfaceInfo& whole) override
  {
    this->UpdateMetrics();
    for (Part& part : this->Parts)
    {
      part.GetEvaluator().ShareNumbers(view, pieces, whole);
    }
  }

private:
  void UpdateMetrics();
  bool UpdateParts(const relevo::RefinementView& view, int maximumLevel, bool perEdge);
  bool Combine(int maximumLevel, vtkFloatArray* tags);
  template <typename Function>
  void CombineParts(float start, vtkFloatArray* tags, Function&& f);

  vtkSmartPointer<vtkCompositeDepthTagMetric> Metric;
  std::shared_ptr<relevo::MetricMesh> Mesh; // shared by all parts
  std::vector<Part> Parts;
};

void CompositeEvaluator::UpdateMetrics()
{
  this->Parts.resize(this->Metric->GetNumberOfMetrics());
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    this->Parts[i].SetMetric(this->Metric->GetMetric(static_cast<int>(i)), this->Mesh);
  }
}

bool CompositeEvaluator::UpdateParts(
  const relevo::RefinementView& view, int maximumLevel, bool perEdge)
{
  const int numberOfParts = this->Metric->GetNumberOfMetrics();
  if (numberOfParts == 0)
  {
    vtkErrorWithObjectMacro(
      this->Metric.Get(), "There are no metrics to combine: call AddMetric().");
    return false;
  }
  this->UpdateMetrics();
  for (int i = 0; i < numberOfParts; ++i)
  {
    std::string error;
    if (!this->Parts[i].Update(view, maximumLevel, perEdge, error))
    {
      vtkErrorWithObjectMacro(this->Metric.Get(), "Metric " << i << ": " << error << ".");
      return false;
    }
  }
  return true;
}

template <typename Function>
void CompositeEvaluator::CombineParts(float start, vtkFloatArray* tags, Function&& f)
{
  float* levels = tags->GetPointer(0);
  vtkSMPTools::For(0, tags->GetNumberOfValues(),
    [&, levels](vtkIdType begin, vtkIdType end)
    {
      std::fill(levels + begin, levels + end, start);
      for (std::size_t part = 0; part < this->Parts.size(); ++part)
      {
        const float* tag = this->Parts[part].GetTags()->GetPointer(0);
        const float weight = static_cast<float>(this->Metric->GetWeight(static_cast<int>(part)));
        for (vtkIdType i = begin; i < end; ++i)
        {
          levels[i] = f(levels[i], tag[i], weight);
        }
      }
    });
}

bool CompositeEvaluator::Combine(int maximumLevel, vtkFloatArray* tags)
{
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(this->Parts[0].GetTags()->GetNumberOfTuples());
  switch (this->Metric->GetMode())
  {
    case vtkCompositeDepthTagMetric::SUM:
      this->CombineParts(0.0f, tags,
        [=](float level, float part, float weight)
        { return relevo::summedLevel(level, part, weight, maximumLevel); });
      break;
    case vtkCompositeDepthTagMetric::PRODUCT:
      this->CombineParts(static_cast<float>(maximumLevel), tags,
        [=](float level, float part, float weight)
        { return relevo::multipliedLevel(level, part, weight, maximumLevel); });
      break;
    default:
      this->CombineParts(0.0f, tags,
        [=](float level, float part, float weight)
        { return relevo::largestLevel(level, part, weight, maximumLevel); });
  }
  tags->Modified();
  return true;
}
}

struct vtkCompositeDepthTagMetric::vtkInternals
{
  struct Part
  {
    vtkSmartPointer<vtkDepthTagMetric> Metric;
    double Weight = 1.0;
  };
  std::vector<Part> Parts;
};

vtkStandardNewMacro(vtkCompositeDepthTagMetric);

vtkCompositeDepthTagMetric::vtkCompositeDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkCompositeDepthTagMetric::~vtkCompositeDepthTagMetric() = default;

void vtkCompositeDepthTagMetric::SetMode(int mode)
{
  relevo::SetChoice(this, "Mode", this->Mode, mode, { "MAXIMUM", "SUM", "PRODUCT" });
}

const char* vtkCompositeDepthTagMetric::GetModeAsString()
{
  return this->Mode == SUM ? "Sum" : this->Mode == PRODUCT ? "Product" : "Maximum";
}

void vtkCompositeDepthTagMetric::AddMetric(vtkDepthTagMetric* metric, double weight)
{
  if (!metric)
  {
    vtkErrorMacro("Cannot add the metric: it is null.");
    return;
  }
  if (!relevo::CheckRange(this, "Weight", weight, 0.0, LargestWeight))
  {
    return;
  }
  auto* composite = vtkCompositeDepthTagMetric::SafeDownCast(metric);
  if (composite && (composite == this || composite->Contains(this)))
  {
    vtkErrorMacro("Cannot add the metric: it would contain itself.");
    return;
  }
  this->Internals->Parts.push_back({ metric, weight });
  this->Modified();
}

bool vtkCompositeDepthTagMetric::Contains(vtkDepthTagMetric* metric)
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [metric](const vtkInternals::Part& part)
    {
      auto* composite = vtkCompositeDepthTagMetric::SafeDownCast(part.Metric);
      return part.Metric == metric || (composite && composite->Contains(metric));
    });
}

void vtkCompositeDepthTagMetric::RemoveAllMetrics()
{
  if (!this->Internals->Parts.empty())
  {
    this->Internals->Parts.clear();
    this->Modified();
  }
}

int vtkCompositeDepthTagMetric::GetNumberOfMetrics()
{
  return static_cast<int>(this->Internals->Parts.size());
}

vtkDepthTagMetric* vtkCompositeDepthTagMetric::GetMetric(int index)
{
  return index >= 0 && index < this->GetNumberOfMetrics()
    ? this->Internals->Parts[index].Metric.Get()
    : nullptr;
}

double vtkCompositeDepthTagMetric::GetWeight(int index)
{
  return index >= 0 && index < this->GetNumberOfMetrics() ? this->Internals->Parts[index].Weight
                                                          : 0.0;
}

vtkMTimeType vtkCompositeDepthTagMetric::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const vtkInternals::Part& part : this->Internals->Parts)
  {
    time = std::max(time, part.Metric->GetMTime());
  }
  return time;
}

bool vtkCompositeDepthTagMetric::IsViewDependent()
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [](const vtkInternals::Part& part) { return part.Metric->IsViewDependent(); });
}

bool vtkCompositeDepthTagMetric::IsPlacementDependent()
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [](const vtkInternals::Part& part) { return part.Metric->IsPlacementDependent(); });
}

bool vtkCompositeDepthTagMetric::IsDisplacementDependent()
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [](const vtkInternals::Part& part) { return part.Metric->IsDisplacementDependent(); });
}

std::unique_ptr<relevo::MetricEvaluator> vtkCompositeDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<CompositeEvaluator>(this, mesh);
}

void vtkCompositeDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetModeAsString() << "\n";
  os << indent << "NumberOfMetrics: " << this->GetNumberOfMetrics() << "\n";
  for (const vtkInternals::Part& part : this->Internals->Parts)
  {
    os << indent << "Metric: " << part.Metric.Get() << ", weight " << part.Weight << "\n";
  }
}
