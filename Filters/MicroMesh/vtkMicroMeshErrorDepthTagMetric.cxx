// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshErrorDepthTagMetric.h"

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
constexpr int HighestLevelOfPatterns = 7;

class MicroErrorEvaluator : public relevo::FaceErrorEvaluator
{
public:
  MicroErrorEvaluator(
    vtkMicroMeshErrorDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FaceErrorEvaluator(metric, mesh)
  {
  }

protected:
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
};
}

vtkStandardNewMacro(vtkMicroMeshErrorDepthTagMetric);

vtkMicroMeshErrorDepthTagMetric::vtkMicroMeshErrorDepthTagMetric() = default;
vtkMicroMeshErrorDepthTagMetric::~vtkMicroMeshErrorDepthTagMetric() = default;

std::unique_ptr<relevo::MetricEvaluator> vtkMicroMeshErrorDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<MicroErrorEvaluator>(this, mesh);
}
