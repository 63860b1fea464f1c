// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompositeDepthTagMetric.h"

#include "Core/RefinementMathematics.h"
#include "Core/RefinementView.h"
#include "Core/SettingChecks.h"
#include "Core/WorldView.h"
#include "Mesh/SurfaceEdges.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

namespace
{
constexpr double LargestWeight = 1e6;

// What the tags of a metric that does not depend on the view were computed from.
struct Source
{
  bool OfEdges = false;
  vtkMTimeType MetricTime = 0;
  vtkPolyData* Mesh = nullptr;
  vtkMTimeType MeshTime = 0;
  int MaximumLevel = 0;
  glm::dmat4 ModelToWorld{ 1.0 };

  bool operator==(const Source& other) const
  {
    return this->OfEdges == other.OfEdges && this->MetricTime == other.MetricTime &&
      this->Mesh == other.Mesh && this->MeshTime == other.MeshTime &&
      this->MaximumLevel == other.MaximumLevel && this->ModelToWorld == other.ModelToWorld;
  }
};

struct Part
{
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  double Weight = 1.0;
  vtkSmartPointer<vtkFloatArray> Tags = vtkSmartPointer<vtkFloatArray>::New();
  Source Of{};
  bool Valid = false;

  // The tags of edges, or those of points without edges.
  bool Update(vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel,
    const relevo::SurfaceEdges* edges)
  {
    const Source source{ edges != nullptr, this->Metric->GetMTime(), mesh, mesh->GetMTime(),
      maximumLevel, relevo::MakeMatrix(view.ModelToWorld) };
    if (!this->Valid || this->Metric->IsViewDependent() || !(source == this->Of))
    {
      this->Valid = edges
        ? this->Metric->ComputeEdgeTags(mesh, view, maximumLevel, *edges, this->Tags) &&
          this->Tags->GetNumberOfValues() == edges->GetNumberOfEdges()
        : this->Metric->ComputeTags(mesh, view, maximumLevel, this->Tags) &&
          this->Tags->GetNumberOfValues() == mesh->GetNumberOfPoints();
      this->Of = source;
    }
    return this->Valid;
  }
};

// Takes f(level, tag of the part, weight) of all parts, one after the other, from `start` on.
template <typename Function>
void CombineParts(const std::vector<Part>& parts, float start, vtkFloatArray* tags, Function&& f)
{
  float* levels = tags->GetPointer(0);
  vtkSMPTools::For(0, tags->GetNumberOfValues(),
    [&, levels](vtkIdType begin, vtkIdType end)
    {
      std::fill(levels + begin, levels + end, start);
      for (const Part& part : parts)
      {
        const float* tag = part.Tags->GetPointer(0);
        const float weight = static_cast<float>(part.Weight);
        for (vtkIdType i = begin; i < end; ++i)
        {
          levels[i] = f(levels[i], tag[i], weight);
        }
      }
    });
}
}

struct vtkCompositeDepthTagMetric::vtkInternals
{
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
    vtkErrorMacro("There is no metric to add.");
    return;
  }
  if (!relevo::CheckRange(this, "Weight", weight, 0.0, LargestWeight))
  {
    return;
  }
  auto* composite = vtkCompositeDepthTagMetric::SafeDownCast(metric);
  if (composite && (composite == this || composite->Contains(this)))
  {
    vtkErrorMacro("The metric cannot be added: it would contain itself.");
    return;
  }
  Part part;
  part.Metric = metric;
  part.Weight = weight;
  this->Internals->Parts.push_back(part);
  this->Modified();
}

bool vtkCompositeDepthTagMetric::Contains(vtkDepthTagMetric* metric)
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [metric](const Part& part)
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
  for (const Part& part : this->Internals->Parts)
  {
    time = std::max(time, part.Metric->GetMTime());
  }
  return time;
}

bool vtkCompositeDepthTagMetric::IsViewDependent()
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [](const Part& part) { return part.Metric->IsViewDependent(); });
}

bool vtkCompositeDepthTagMetric::IsPlacementDependent()
{
  return std::any_of(this->Internals->Parts.begin(), this->Internals->Parts.end(),
    [](const Part& part) { return part.Metric->IsPlacementDependent(); });
}

bool vtkCompositeDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  return this->Combine(mesh, view, maximumLevel, nullptr, tags);
}

bool vtkCompositeDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh,
  const relevo::RefinementView& view, int maximumLevel, const relevo::SurfaceEdges& edges,
  vtkFloatArray* tags)
{
  return this->Combine(mesh, view, maximumLevel, &edges, tags);
}

bool vtkCompositeDepthTagMetric::Combine(vtkPolyData* mesh, const relevo::RefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges* edges, vtkFloatArray* tags)
{
  std::vector<Part>& parts = this->Internals->Parts;
  if (parts.empty())
  {
    vtkErrorMacro("There are no metrics to combine: call AddMetric.");
    return false;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (!parts[i].Update(mesh, view, maximumLevel, edges))
    {
      vtkErrorMacro("Metric " << i << ", a " << parts[i].Metric->GetClassName()
                              << ", gave no tags for this mesh and view: see its own error.");
      return false;
    }
  }

  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(parts[0].Tags->GetNumberOfTuples());
  switch (this->Mode)
  {
    case SUM:
      CombineParts(parts, 0.0f, tags,
        [=](float level, float part, float weight)
        { return relevo::summedLevel(level, part, weight, maximumLevel); });
      break;
    case PRODUCT:
      CombineParts(parts, static_cast<float>(maximumLevel), tags,
        [=](float level, float part, float weight)
        { return relevo::multipliedLevel(level, part, weight, maximumLevel); });
      break;
    default:
      CombineParts(parts, 0.0f, tags,
        [=](float level, float part, float weight)
        { return relevo::largestLevel(level, part, weight, maximumLevel); });
  }
  tags->Modified();
  return true;
}

void vtkCompositeDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetModeAsString() << "\n";
  os << indent << "NumberOfMetrics: " << this->GetNumberOfMetrics() << "\n";
  for (const Part& part : this->Internals->Parts)
  {
    os << indent << "Metric: " << part.Metric.Get() << ", weight " << part.Weight << "\n";
  }
}
