// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/ViewSelection.h"

#include "Evaluation/HoleCount.h"
#include "Evaluation/SampledSurface.h"
#include "Mesh/RefinementMesh.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <string>
#include <utility>

namespace relevo
{
namespace
{
Dependencies GetTagDependencies(const SelectionInput& input, const RefinementView& view, bool onGPU)
{
  vtkAdaptiveRefinement* recipe = input.Recipe;
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input.Input);
  Dependencies dependencies = Dependencies::On(recipe->GetMaximumLevel(), input.MeshTime,
    input.WholeTime, input.HighestTag, std::string(recipe->GetDepthTagArrayName()),
    recipe->GetLevelRule(), onGPU, GetPatternFamily(recipe, input.Input)->GetMTime(), view.IsPart);
  dependencies.AddObject(metric);
  view.AddTo(
    dependencies, metric && metric->IsPlacementDependent(), metric && metric->IsViewDependent());
  if (metric && metric->IsDisplacementDependent())
  {
    if (const auto surface = SampledSurface::Make(recipe))
    {
      surface->AddTo(dependencies);
    }
  }
  return dependencies;
}
}

bool ViewSelection::UpdateTags(
  const SelectionInput& input, const RefinementView& view, bool onGPU, std::string& error)
{
  if (!this->TagDependencies.Update(GetTagDependencies(input, view, onGPU)))
  {
    return this->Valid;
  }
  this->TagsTime.Modified();

  const double start = vtkTimerLog::GetUniversalTime();
  if (this->TagsMeshTime != input.MeshTime)
  {
    this->TagsMeshTime = input.MeshTime;
    this->Tags.Reset();
  }
  this->Valid = onGPU
    ? this->Tags.ComputeOrDescribe(input.Recipe, input.Input, *input.Mesh, view, error)
    : this->Tags.Compute(input.Recipe, input.Input, *input.Mesh, view, input.HighestTag, error);
  this->TagsSeconds = vtkTimerLog::GetUniversalTime() - start;
  return this->Valid;
}

bool ViewSelection::UpdateLevels(const SelectionInput& input, double offset, bool onGPU)
{
  this->Mesh = input.Mesh;
  const auto family = GetPatternFamily(input.Recipe, input.Input);
  const double sum = input.Recipe->GetLevelOffset() + offset;
  if (!this->LevelDependencies.Update(
        Dependencies::On(family->GetMTime(), this->TagsTime, sum, onGPU)))
  {
    return false;
  }
  this->LevelsTime.Modified();
  this->AreTrianglesCounted = false;
  const double start = vtkTimerLog::GetUniversalTime();
  if (onGPU)
  {
    this->Selection = PatternSelection(); // until it is read back
  }
  else
  {
    this->Selection.Select(
      *input.Mesh, this->Tags, *family, input.Recipe->GetMaximumLevel(), static_cast<float>(sum));
  }
  this->LevelsSeconds = vtkTimerLog::GetUniversalTime() - start;
  return true;
}

const RefinementMesh& ViewSelection::GetMesh() const
{
  static const RefinementMesh none;
  return this->Mesh ? *this->Mesh : none;
}

void ViewSelection::SetHoles(const HeightValidity& holes, vtkMTimeType time)
{
  if (this->HolesTime != time)
  {
    this->HolesTime = time;
    this->Holes = holes;
    this->AreTrianglesCounted = false;
  }
}

void ViewSelection::Assign(const PatternFamily& family, std::vector<unsigned int> entries,
  std::vector<float> morphTags, std::vector<unsigned char> hidden)
{
  this->Selection.Assign(family, std::move(entries), std::move(morphTags));
  this->Hidden = std::move(hidden);
  this->NumberOfHiddenFaces =
    static_cast<int>(this->Hidden.size() - std::count(this->Hidden.begin(), this->Hidden.end(), 0));
  this->SightDependencies.Clear(); // the CPU may cull other faces exactly on the border
  this->AreTrianglesCounted = false;
}

void ViewSelection::UpdateSight(const CullingInput& culling)
{
  Dependencies sight = Dependencies::On(culling.Culling != nullptr);
  if (culling.Culling)
  {
    sight.Add(culling.CullingTime);
    sight.Add(culling.Culling->HidesBackFaces(*culling.View, culling.HidesBackFaces));
    culling.View->AddTo(sight);
  }
  if (!this->SightDependencies.Update(sight))
  {
    return;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->LastHidden.swap(this->Hidden);
  const int last = this->NumberOfHiddenFaces;
  this->NumberOfHiddenFaces = culling.Culling
    ? culling.Culling->FindHidden(*culling.View, culling.HidesBackFaces, this->Hidden)
    : 0;
  if (this->NumberOfHiddenFaces != last || (last > 0 && this->Hidden != this->LastHidden))
  {
    this->SightTime.Modified();
    this->AreTrianglesCounted = false;
  }
  this->SightSeconds = vtkTimerLog::GetUniversalTime() - start;
}

void ViewSelection::UpdateGroups(const CullingInput& culling)
{
  this->UpdateSight(culling);
  if (!this->GroupDependencies.Update(Dependencies::On(this->LevelsTime, this->SightTime)))
  {
    return;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->Selection.Group(this->GetHidden());
  this->GroupsTime.Modified();
  this->GroupsSeconds = vtkTimerLog::GetUniversalTime() - start;
}

FaceSums ViewSelection::CountTriangles()
{
  if (!this->AreTrianglesCounted && this->Valid)
  {
    this->AreTrianglesCounted = true;
    this->NumbersOfTriangles = this->SumOverFaces([this](int face)
      { return this->Selection.GetFacePattern(face).Pattern->GetNumberOfTriangles(); });
    // Fragments over no data are discarded; the triangles that the filter omits are counted on
    // demand.
    const vtkIdType holes = CountHoles(*this->Mesh, this->Selection, this->Holes);
    const vtkIdType drawnHoles = this->GetHidden()
      ? CountHoles(*this->Mesh, this->Selection, this->Holes, this->GetHidden())
      : holes;
    this->NumbersOfTriangles.Drawn -= drawnHoles;
    this->NumbersOfTriangles.Culled -= holes - drawnHoles;
  }
  return this->Valid ? this->NumbersOfTriangles : FaceSums();
}
}
