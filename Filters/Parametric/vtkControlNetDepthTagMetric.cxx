// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkControlNetDepthTagMetric.h"

#include "Core/RefinementMathematics.h"
#include "Core/SettingChecks.h"
#include "Mesh/PatchArrays.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/NetAngles.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

namespace relevo
{
#include "glsl/Metrics/relevoMetrics.glsl"
}

namespace
{
class ControlNetEvaluator : public relevo::MetricEvaluator
{
public:
  ControlNetEvaluator(
    vtkControlNetDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    if (!this->ComputeEdgeTags(view, maximumLevel, this->EdgeLevels))
    {
      return false;
    }
    this->GetMesh().GetEdges()->TagPoints(this->EdgeLevels->GetPointer(0), tags);
    return true;
  }

  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

private:
  bool Update();

  vtkSmartPointer<vtkControlNetDepthTagMetric> Metric;
  std::vector<float> Angles; // of patches, in degrees
  relevo::PatchArrays Patches;
  relevo::Dependencies AngleDependencies;
  vtkNew<vtkFloatArray> EdgeLevels;
};

bool ControlNetEvaluator::Update()
{
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  if (!this->AngleDependencies.Update(relevo::PatchArrays::GetDependencies(mesh)))
  {
    return true;
  }
  std::string error;
  if (!this->Patches.Take(mesh, error))
  {
    this->AngleDependencies.Clear();
    vtkErrorWithObjectMacro(
      this->Metric.Get(), "There are no control nets to measure. " << error << ".");
    return false;
  }
  this->Angles.resize(static_cast<std::size_t>(this->Patches.GetNumberOfPatches()));
  vtkSMPTools::For(0, this->Patches.GetNumberOfPatches(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int i = static_cast<int>(begin); i < end; ++i)
      {
        this->Angles[i] =
          static_cast<float>(relevo::ComputeNetAngle(this->Patches, this->Patches.GetPatch(i)));
      }
    });
  return true;
}

bool ControlNetEvaluator::ComputeEdgeTags(
  const relevo::RefinementView&, int maximumLevel, vtkFloatArray* tags)
{
  const auto low = static_cast<float>(this->Metric->GetMinimumAngle());
  const auto high = static_cast<float>(this->Metric->GetMaximumAngle());
  if (low > high)
  {
    vtkErrorWithObjectMacro(
      this->Metric.Get(), "MinimumAngle " << low << " is above MaximumAngle " << high << ".");
    return false;
  }
  if (!this->Update())
  {
    return false;
  }
  const relevo::SurfaceEdges& edges = *this->GetMesh().GetEdges();
  relevo::TagEdges(edges, tags,
    [&](int edge)
    {
      float angle = 0.0f;
      edges.ForEachSides(edge,
        [&](int i)
        {
          for (int t : edges.GetSides()[i].Triangles)
          {
            const vtkIdType cell = t < 0 ? 0 : edges.GetTriangles().GetCell(t);
            angle = t < 0 ? angle : std::max(angle, this->Angles[this->Patches.GetPatchId(cell)]);
          }
        });
      return relevo::rangeLevel(angle, low, high, maximumLevel);
    });
  return true;
}
}

vtkStandardNewMacro(vtkControlNetDepthTagMetric);

vtkControlNetDepthTagMetric::vtkControlNetDepthTagMetric() = default;
vtkControlNetDepthTagMetric::~vtkControlNetDepthTagMetric() = default;

void vtkControlNetDepthTagMetric::SetMinimumAngle(double degrees)
{
  relevo::SetInRange(this, "MinimumAngle", this->MinimumAngle, degrees, 0.0, 180.0);
}

void vtkControlNetDepthTagMetric::SetMaximumAngle(double degrees)
{
  relevo::SetInRange(this, "MaximumAngle", this->MaximumAngle, degrees, 0.0, 180.0);
}

std::unique_ptr<relevo::MetricEvaluator> vtkControlNetDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<ControlNetEvaluator>(this, mesh);
}

void vtkControlNetDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
  os << indent << "MaximumAngle: " << this->MaximumAngle << "\n";
}
