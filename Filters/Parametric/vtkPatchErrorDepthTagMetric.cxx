// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatchErrorDepthTagMetric.h"

#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Mesh/PatchArrays.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/PatchDeviations.h"
#include "Metrics/PatternExtents.h"
#include "Metrics/SegmentSearch.h"
#include "View/PixelScale.h"
#include "View/RefinementView.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

namespace
{
constexpr double SmallestError = 0.001; // pixels
constexpr double LargestError = 1e6;

class PatchErrorEvaluator : public relevo::MetricEvaluator
{
public:
  PatchErrorEvaluator(
    vtkPatchErrorDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;
  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

private:
  bool Prepare(const relevo::RefinementView& view, relevo::PixelScale& scale);
  bool Update();
  bool Fail(const std::string& error);
  double GetLimit(const relevo::PixelScale& scale, const relevo::PointBox& box) const
  {
    return this->Metric->GetScreenSpaceError() / scale.GetPixels(box);
  }
  void LevelEdges(const relevo::PixelScale& scale, int maximumLevel, vtkFloatArray* levels);
  void LevelCurves(const relevo::PixelScale& scale, int maximumLevel, vtkFloatArray* tags);

  vtkSmartPointer<vtkPatchErrorDepthTagMetric> Metric;
  relevo::PatchDeviations Deviations;
  relevo::Dependencies DeviationDependencies;
  std::shared_ptr<const relevo::PatternExtents> Patterns;
  std::vector<double> Limits; // one per face, in units of the mesh
  vtkNew<vtkFloatArray> EdgeLevels;
};

bool PatchErrorEvaluator::Fail(const std::string& error)
{
  vtkErrorWithObjectMacro(this->Metric.Get(), << error << ".");
  return false;
}

// Updates the view-independent data of the mesh.
bool PatchErrorEvaluator::Update()
{
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  relevo::Dependencies now = relevo::PatchArrays::GetDependencies(mesh);
  now.Add(this->GetMesh().GetTime());
  now.AddObject(mesh->GetPointData()->GetRationalWeights());
  if (!this->DeviationDependencies.Update(now))
  {
    return true;
  }
  this->Deviations = relevo::PatchDeviations();
  std::string error;
  const bool hasFaces = relevo::PatchArrays::AreOn(mesh) || mesh->GetNumberOfPolys() > 0 ||
    mesh->GetNumberOfStrips() > 0;
  if ((hasFaces && !this->Deviations.BuildFaces(this->GetMesh(), error)) ||
    !this->Deviations.BuildCurves(mesh, error))
  {
    this->DeviationDependencies.Clear();
    return this->Fail("Cannot measure the patches: " + error);
  }
  return true;
}

bool PatchErrorEvaluator::Prepare(const relevo::RefinementView& view, relevo::PixelScale& scale)
{
  std::string error;
  if (!scale.Check(view, error))
  {
    return this->Fail(error);
  }
  this->Patterns = relevo::PatternExtents::Find(view.Patterns);
  return this->Update();
}

void PatchErrorEvaluator::LevelEdges(
  const relevo::PixelScale& scale, int maximumLevel, vtkFloatArray* levels)
{
  const std::vector<relevo::FaceDeviation>& faces = this->Deviations.GetFaces();
  this->Limits.resize(faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        this->Limits[f] = this->GetLimit(scale, faces[f].Box);
      }
    });
  levels->SetNumberOfComponents(1);
  levels->SetNumberOfTuples(this->GetMesh().GetEdges()->GetNumberOfEdges());
  levels->Fill(0.0);
  if (!faces.empty())
  {
    relevo::FindEdgeLevels(
      this->Deviations, *this->Patterns, this->Limits, maximumLevel, levels->GetPointer(0));
  }
  levels->Modified();
}

void PatchErrorEvaluator::LevelCurves(
  const relevo::PixelScale& scale, int maximumLevel, vtkFloatArray* tags)
{
  const std::vector<relevo::CurveDeviation>& curves = this->Deviations.GetCurves();
  std::vector<float> levels(curves.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(curves.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float level = relevo::FindCurveLevel(
          *this->Patterns, curves[i].Chord, this->GetLimit(scale, curves[i].Box));
        levels[i] = std::min(level, static_cast<float>(maximumLevel));
      }
    });
  vtkNew<vtkIdList> ids;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    this->GetMesh().GetPolyData()->GetLines()->GetCellAtId(curves[i].Line, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      float& tag = *tags->GetPointer(ids->GetId(k));
      tag = std::max(tag, levels[i]);
    }
  }
}

bool PatchErrorEvaluator::ComputeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  relevo::PixelScale scale(view);
  if (!this->Prepare(view, scale))
  {
    return false;
  }
  this->LevelEdges(scale, maximumLevel, this->EdgeLevels);
  this->GetMesh().GetEdges()->TagPoints(this->EdgeLevels->GetPointer(0), tags);
  this->LevelCurves(scale, maximumLevel, tags);
  tags->Modified();
  return true;
}

bool PatchErrorEvaluator::ComputeEdgeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  relevo::PixelScale scale(view);
  if (!this->Prepare(view, scale))
  {
    return false;
  }
  this->LevelEdges(scale, maximumLevel, tags);
  return true;
}
}

vtkStandardNewMacro(vtkPatchErrorDepthTagMetric);

vtkPatchErrorDepthTagMetric::vtkPatchErrorDepthTagMetric() = default;
vtkPatchErrorDepthTagMetric::~vtkPatchErrorDepthTagMetric() = default;

void vtkPatchErrorDepthTagMetric::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(
    this, "ScreenSpaceError", this->ScreenSpaceError, pixels, SmallestError, LargestError);
}

std::unique_ptr<relevo::MetricEvaluator> vtkPatchErrorDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<PatchErrorEvaluator>(this, mesh);
}

void vtkPatchErrorDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
}
