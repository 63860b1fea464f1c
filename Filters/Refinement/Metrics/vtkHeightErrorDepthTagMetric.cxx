// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightErrorDepthTagMetric.h"

#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/DisplacedSurface.h"
#include "Metrics/LevelSearch.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Patterns/PatternFamily.h"
#include "Patterns/PatternLibrary.h"
#include "View/PixelScale.h"
#include "View/RefinementView.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double SmallestHeightError = 0.001; // pixels
constexpr double LargestHeightError = 1e6;

class HeightErrorEvaluator : public relevo::MetricEvaluator
{
public:
  HeightErrorEvaluator(
    vtkHeightErrorDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;
  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

private:
  bool Search(const relevo::RefinementView& view, bool isPerEdge);
  void Update(const relevo::RefinementView& view, bool isPerEdge);
  bool FindLimits(const relevo::RefinementView& view);
  bool Fail(const std::string& error);

  vtkSmartPointer<vtkHeightErrorDepthTagMetric> Metric;
  relevo::Dependencies FaceDependencies;
  relevo::Dependencies SearchDependencies;
  std::shared_ptr<const relevo::PatternFamily> Patterns;
  std::unique_ptr<relevo::DisplacedFaces> Faces; // nullptr if the mesh cannot be displaced
  relevo::LevelSearch Levels;
  std::vector<double> Limits; // one per face, in units of the mesh
};

bool HeightErrorEvaluator::Fail(const std::string& error)
{
  vtkErrorWithObjectMacro(this->Metric.Get(), << error << ".");
  return false;
}

void HeightErrorEvaluator::Update(const relevo::RefinementView& view, bool isPerEdge)
{
  this->Patterns = view.Patterns;
  if (!this->Patterns)
  {
    static const relevo::PatternLibrary library;
    this->Patterns = library.GetFamily(relevo::PatternLibrary::POWERS_OF_TWO);
  }
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  relevo::Dependencies now =
    relevo::Dependencies::On(this->GetMesh().GetTime(), this->Patterns->GetMTime());
  now.AddObject(mesh);
  view.Displaced->AddTo(now);
  if (this->FaceDependencies.Update(now))
  {
    this->Faces = view.Displaced->MakeFaces(mesh, this->GetMesh().GetWhole(), this->Patterns);
    this->SearchDependencies.Clear();
  }
  now.Add(isPerEdge);
  if (this->Faces && this->SearchDependencies.Update(now))
  {
    if (isPerEdge)
    {
      this->Levels.UseEdges(*this->Faces, *this->GetMesh().GetEdges());
    }
    else
    {
      this->Levels.UsePoints(*this->Faces, static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    }
  }
}

bool HeightErrorEvaluator::FindLimits(const relevo::RefinementView& view)
{
  relevo::PixelScale scale(view);
  const int numberOfFaces = this->Faces ? this->Faces->GetNumberOfFaces() : 0;
  const double length = this->Metric->GetMaximumError();
  if (length > 0.0)
  {
    const double stretch = scale.GetMaximumStretch();
    this->Limits.assign(
      static_cast<std::size_t>(numberOfFaces), stretch > 0.0 ? length / stretch : VTK_DOUBLE_MAX);
    return true;
  }
  std::string error;
  if (!scale.Check(view, error))
  {
    return this->Fail(error);
  }
  this->Limits.resize(static_cast<std::size_t>(numberOfFaces));
  vtkSMPTools::For(0, numberOfFaces,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int f = static_cast<int>(begin); f < end; ++f)
      {
        this->Limits[f] =
          this->Metric->GetScreenSpaceError() / scale.GetPixels(this->Faces->GetBox(f));
      }
    });
  return true;
}

bool HeightErrorEvaluator::Search(const relevo::RefinementView& view, bool isPerEdge)
{
  if (!view.Displaced)
  {
    return this->Fail("There is no height map to measure: set a vtkDisplacement with a height map "
                      "for the vtkAdaptiveRefinement");
  }
  this->Update(view, isPerEdge);
  if (!this->FindLimits(view))
  {
    return false;
  }
  if (this->Faces)
  {
    this->Levels.SetFixedBorder(
      this->Metric->GetMaximumLevelOnBorder() || view.IsPart || this->GetMesh().GetWhole());
    this->Levels.Run(
      *this->Faces, *this->Patterns, this->Limits, view.Displaced->GetMaximumLevel());
  }
  return true;
}

bool HeightErrorEvaluator::ComputeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->Search(view, false))
  {
    return false;
  }
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(this->GetMesh().GetPolyData()->GetNumberOfPoints());
  const relevo::SurfaceTriangles& surface = *this->GetMesh().GetTriangles();
  vtkSMPTools::For(0, tags->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const float tag =
          this->Faces ? this->Levels.GetTag(static_cast<int>(surface.GetMergedPoint(point))) : 0.0f;
        tags->SetValue(point, std::min(tag, static_cast<float>(maximumLevel)));
      }
    });
  tags->Modified();
  return true;
}

bool HeightErrorEvaluator::ComputeEdgeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->Search(view, true))
  {
    return false;
  }
  relevo::TagEdges(*this->GetMesh().GetEdges(), tags,
    [&](int edge)
    {
      const float tag = this->Faces ? this->Levels.GetTag(edge) : 0.0f;
      return std::min(tag, static_cast<float>(maximumLevel));
    });
  return true;
}
}

vtkStandardNewMacro(vtkHeightErrorDepthTagMetric);

vtkHeightErrorDepthTagMetric::vtkHeightErrorDepthTagMetric() = default;
vtkHeightErrorDepthTagMetric::~vtkHeightErrorDepthTagMetric() = default;

void vtkHeightErrorDepthTagMetric::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(this, "ScreenSpaceError", this->ScreenSpaceError, pixels, SmallestHeightError,
    LargestHeightError);
}

void vtkHeightErrorDepthTagMetric::SetMaximumError(double length)
{
  relevo::SetInRange(this, "MaximumError", this->MaximumError, length, 0.0, relevo::LargestDouble);
}

std::unique_ptr<relevo::MetricEvaluator> vtkHeightErrorDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<HeightErrorEvaluator>(this, mesh);
}

void vtkHeightErrorDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "MaximumLevelOnBorder: " << (this->MaximumLevelOnBorder ? "on" : "off") << "\n";
}
