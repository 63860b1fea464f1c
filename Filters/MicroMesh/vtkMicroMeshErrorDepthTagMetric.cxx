// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshErrorDepthTagMetric.h"

#include "Checks/SettingChecks.h"
#include "Data/MicroMeshArrays.h"
#include "Metrics/FaceErrorEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MicroFaces.h"
#include "Patterns/PatternFamily.h"
#include "View/RefinementView.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

namespace
{
constexpr double SmallestMicroError = 0.001; // pixels
constexpr double LargestMicroError = 1e6;
constexpr int HighestLevelOfPatterns = 7;

class MicroErrorEvaluator : public relevo::FaceErrorEvaluator
{
public:
  MicroErrorEvaluator(
    vtkMicroMeshErrorDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FaceErrorEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

protected:
  Limit GetLimit() const override
  {
    return { this->Metric->GetScreenSpaceError(), this->Metric->GetMaximumError(),
      this->Metric->GetMaximumLevelOnBorder() };
  }

  // With the level of the finest grid on all edges, the surface is drawn exactly.
  int GetHighestLevel(const relevo::RefinementView& view, int maximumLevel) const override
  {
    const int finest = relevo::FindFinestLevel(this->GetMesh().GetPolyData());
    // Vertices are in their final positions half a level above theirs.
    const int morphing = view.Patterns && view.Patterns->IsMorphing() ? 1 : 0;
    return std::min({ maximumLevel, finest + morphing, HighestLevelOfPatterns });
  }

  std::unique_ptr<relevo::DisplacedFaces> MakeFaces(const relevo::RefinementView&,
    const std::shared_ptr<const relevo::PatternFamily>& patterns, int maximumLevel,
    std::string& error) override
  {
    if (this->GetMesh().GetPolyData()->GetNumberOfPolys() == 0)
    {
      return nullptr;
    }
    auto faces = std::make_unique<relevo::MicroFaces>(patterns, maximumLevel);
    if (!faces->Take(this->GetMesh(), error))
    {
      return nullptr;
    }
    return faces;
  }

private:
  vtkSmartPointer<vtkMicroMeshErrorDepthTagMetric> Metric;
};
}

vtkStandardNewMacro(vtkMicroMeshErrorDepthTagMetric);

vtkMicroMeshErrorDepthTagMetric::vtkMicroMeshErrorDepthTagMetric() = default;
vtkMicroMeshErrorDepthTagMetric::~vtkMicroMeshErrorDepthTagMetric() = default;

void vtkMicroMeshErrorDepthTagMetric::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(this, "ScreenSpaceError", this->ScreenSpaceError, pixels, SmallestMicroError,
    LargestMicroError);
}

void vtkMicroMeshErrorDepthTagMetric::SetMaximumError(double length)
{
  relevo::SetInRange(this, "MaximumError", this->MaximumError, length, 0.0, relevo::LargestDouble);
}

std::unique_ptr<relevo::MetricEvaluator> vtkMicroMeshErrorDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<MicroErrorEvaluator>(this, mesh);
}

void vtkMicroMeshErrorDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "MaximumLevelOnBorder: " << (this->MaximumLevelOnBorder ? "on" : "off") << "\n";
}
