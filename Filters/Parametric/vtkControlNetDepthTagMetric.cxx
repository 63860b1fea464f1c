// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkControlNetDepthTagMetric.h"

#include "Checks/SettingChecks.h"
#include "Levels/LevelFunctions.h"
#include "Levels/TriangleTags.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/PatchArrays.h"
#include "Mesh/SurfaceEdges.h"
#include "Mesh/SurfaceTriangles.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/NetAngles.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

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
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;
  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

private:
  bool Update();
  bool ComputeLevels(int maximumLevel);

  vtkSmartPointer<vtkControlNetDepthTagMetric> Metric;
  std::vector<float> Angles; // one per patch, in degrees
  relevo::PatchArrays Patches;
  relevo::Dependencies AngleDependencies;
  std::vector<float> Levels; // one per triangle
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
      this->Metric.Get(), "Cannot measure the control nets: " << error << ".");
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

bool ControlNetEvaluator::ComputeLevels(int maximumLevel)
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
  const relevo::SurfaceTriangles& surface = *this->GetMesh().GetTriangles();
  this->Levels.resize(surface.GetTriangles().size());
  for (std::size_t t = 0; t < this->Levels.size(); ++t)
  {
    const vtkIdType cell = surface.GetCell(static_cast<vtkIdType>(t));
    this->Levels[t] =
      relevo::rangeLevel(this->Angles[this->Patches.GetPatchId(cell)], low, high, maximumLevel);
  }
  return true;
}

bool ControlNetEvaluator::ComputeTags(
  const relevo::RefinementView&, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->ComputeLevels(maximumLevel))
  {
    return false;
  }
  relevo::TagPointsByTriangles(*this->GetMesh().GetTriangles(), this->Levels.data(), tags);
  return true;
}

bool ControlNetEvaluator::ComputeEdgeTags(
  const relevo::RefinementView&, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->ComputeLevels(maximumLevel))
  {
    return false;
  }
  relevo::TagEdgesByTriangles(*this->GetMesh().GetEdges(), this->Levels.data(), tags);
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
