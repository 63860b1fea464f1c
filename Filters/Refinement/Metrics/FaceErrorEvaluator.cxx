// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/FaceErrorEvaluator.h"

#include "Changes/Dependencies.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/LevelSearch.h"
#include "Metrics/MetricMesh.h"
#include "Patterns/PatternFamily.h"
#include "Patterns/PatternLibrary.h"
#include "View/PixelScale.h"
#include "View/RefinementView.h"
#include "vtkFaceErrorDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace relevo
{
struct FaceErrorEvaluator::State
{
  Dependencies FaceDependencies;
  Dependencies SearchDependencies;
  std::shared_ptr<const PatternFamily> Patterns;
  std::unique_ptr<DisplacedFaces> Faces; // nullptr if there is nothing to measure
  LevelSearch Levels;
  std::vector<double> Limits; // one per face, in units of the mesh
};

FaceErrorEvaluator::FaceErrorEvaluator(
  vtkFaceErrorDepthTagMetric* metric, std::shared_ptr<MetricMesh> mesh)
  : MetricEvaluator(metric, std::move(mesh))
  , Metric(metric)
  , Kept(std::make_unique<State>())
{
}

FaceErrorEvaluator::~FaceErrorEvaluator() = default;

bool FaceErrorEvaluator::Fail(const std::string& error)
{
  vtkErrorWithObjectMacro(this->GetMetric(), << error << ".");
  return false;
}

bool FaceErrorEvaluator::Update(const RefinementView& view, int maximumLevel, bool isPerEdge)
{
  this->Kept->Patterns = view.Patterns;
  if (!this->Kept->Patterns)
  {
    static const PatternLibrary library;
    this->Kept->Patterns = library.GetFamily(PatternLibrary::POWERS_OF_TWO);
  }
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  Dependencies now = Dependencies::On(this->GetMesh().GetTime(), this->Kept->Patterns->GetMTime());
  now.AddObject(mesh);
  now.Add(maximumLevel);
  this->AddTo(view, now);
  if (this->Kept->FaceDependencies.Update(now))
  {
    std::string error;
    this->Kept->Faces = this->MakeFaces(view, this->Kept->Patterns, maximumLevel, error);
    this->Kept->SearchDependencies.Clear();
    if (!error.empty())
    {
      this->Kept->FaceDependencies.Clear();
      return this->Fail(error);
    }
  }
  now.Add(isPerEdge);
  if (this->Kept->Faces && this->Kept->SearchDependencies.Update(now))
  {
    if (isPerEdge)
    {
      this->Kept->Levels.UseEdges(*this->Kept->Faces, *this->GetMesh().GetEdges());
    }
    else
    {
      this->Kept->Levels.UsePoints(
        *this->Kept->Faces, static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    }
  }
  return true;
}

bool FaceErrorEvaluator::FindLimits(const RefinementView& view)
{
  PixelScale scale(view);
  const int numberOfFaces = this->Kept->Faces ? this->Kept->Faces->GetNumberOfFaces() : 0;
  const double length = this->Metric->GetMaximumError();
  const double pixels = this->Metric->GetScreenSpaceError();
  if (length > 0.0)
  {
    const double stretch = scale.GetMaximumStretch();
    this->Kept->Limits.assign(
      static_cast<std::size_t>(numberOfFaces), stretch > 0.0 ? length / stretch : VTK_DOUBLE_MAX);
    return true;
  }
  std::string error;
  if (!scale.Check(view, error))
  {
    return this->Fail(error);
  }
  this->Kept->Limits.resize(static_cast<std::size_t>(numberOfFaces));
  vtkSMPTools::For(0, numberOfFaces,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int f = static_cast<int>(begin); f < end; ++f)
      {
        this->Kept->Limits[f] = pixels / scale.GetPixels(this->Kept->Faces->GetBox(f));
      }
    });
  return true;
}

bool FaceErrorEvaluator::Search(const RefinementView& view, int maximumLevel, bool isPerEdge)
{
  const std::string error = this->FindError(view);
  if (!error.empty())
  {
    return this->Fail(error);
  }
  const int highestLevel = this->GetHighestLevel(view, maximumLevel);
  if (!this->Update(view, maximumLevel, isPerEdge) || !this->FindLimits(view))
  {
    return false;
  }
  if (this->Kept->Faces)
  {
    this->Kept->Levels.SetFixedBorder(
      this->Metric->GetMaximumLevelOnBorder() || view.IsPart || this->GetMesh().GetWhole());
    this->Kept->Levels.Run(
      *this->Kept->Faces, *this->Kept->Patterns, this->Kept->Limits, highestLevel);
  }
  return true;
}

bool FaceErrorEvaluator::ComputeTags(
  const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->Search(view, maximumLevel, false))
  {
    return false;
  }
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(this->GetMesh().GetPolyData()->GetNumberOfPoints());
  const SurfaceTriangles& surface = *this->GetMesh().GetTriangles();
  vtkSMPTools::For(0, tags->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const float tag = this->Kept->Faces
          ? this->Kept->Levels.GetTag(static_cast<int>(surface.GetMergedPoint(point)))
          : 0.0f;
        tags->SetValue(point, std::min(tag, static_cast<float>(maximumLevel)));
      }
    });
  tags->Modified();
  return true;
}

bool FaceErrorEvaluator::ComputeEdgeTags(
  const RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->Search(view, maximumLevel, true))
  {
    return false;
  }
  TagEdges(*this->GetMesh().GetEdges(), tags,
    [&](int edge)
    {
      const float tag = this->Kept->Faces ? this->Kept->Levels.GetTag(edge) : 0.0f;
      return std::min(tag, static_cast<float>(maximumLevel));
    });
  return true;
}
}
