// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/ViewSelection.h"

#include "Core/RefinementView.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <utility>

namespace relevo
{
namespace
{
// What there is to see, not when the camera was last touched.
void AppendView(Dependencies& dependencies, const RefinementView& view)
{
  for (int length : view.ViewportSize)
  {
    dependencies.push_back(static_cast<vtkMTimeType>(length));
  }
  vtkCamera* camera = view.Camera;
  const double aspect =
    static_cast<double>(view.ViewportSize[0]) / std::max(view.ViewportSize[1], 1);
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  for (int i = 0; i < 16; ++i)
  {
    AppendBits(dependencies, matrix->GetData()[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    AppendBits(dependencies, camera->GetPosition()[i]);
    AppendBits(dependencies, camera->GetFocalPoint()[i]);
    AppendBits(dependencies, camera->GetViewUp()[i]);
  }
  AppendBits(dependencies, camera->GetParallelProjection());
}

Dependencies GetTagDependencies(const SelectionInput& input, const RefinementView& view)
{
  vtkAdaptiveRefinement* recipe = input.Recipe;
  Dependencies dependencies;
  vtkDepthTagMetric* metric = GetMetricInUse(recipe, input.Input);
  AppendObject(dependencies, metric);
  dependencies.push_back(static_cast<vtkMTimeType>(recipe->GetMaximumLevel()));
  dependencies.push_back(input.MeshTime);
  dependencies.push_back(static_cast<vtkMTimeType>(input.HighestTag));
  dependencies.push_back(std::hash<std::string>()(recipe->GetDepthTagArrayName()));
  dependencies.push_back(static_cast<vtkMTimeType>(recipe->GetLevelRule()));
  if (metric && metric->IsPlacementDependent())
  {
    for (int i = 0; view.ModelToWorld && i < 16; ++i)
    {
      AppendBits(dependencies, view.ModelToWorld->GetData()[i]);
    }
  }
  if (metric && metric->IsViewDependent())
  {
    AppendView(dependencies, view);
  }
  return dependencies;
}
}

void AppendBits(Dependencies& dependencies, double value)
{
  static_assert(sizeof(vtkMTimeType) == sizeof(double), "a double's bits fit a time stamp");
  vtkMTimeType bits;
  std::memcpy(&bits, &value, sizeof(bits));
  dependencies.push_back(bits);
}

void Append(Dependencies& dependencies, const void* object, vtkMTimeType time)
{
  dependencies.push_back(static_cast<vtkMTimeType>(reinterpret_cast<size_t>(object)));
  dependencies.push_back(time);
}

bool ViewSelection::UpdateTags(
  const SelectionInput& input, const RefinementView& view, bool onGPU, std::string& error)
{
  Dependencies dependencies = GetTagDependencies(input, view);
  dependencies.push_back(onGPU ? 1 : 0);
  if (dependencies == this->TagDependencies)
  {
    return this->Valid;
  }
  this->TagDependencies = dependencies;
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
  Dependencies dependencies = { family->GetMTime(), this->TagsTime };
  AppendBits(dependencies, sum);
  dependencies.push_back(onGPU ? 1 : 0);
  if (dependencies == this->LevelDependencies)
  {
    return false;
  }
  this->LevelDependencies = dependencies;
  this->LevelsTime.Modified();
  this->NumberOfTriangles = -1;
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
    this->NumberOfTriangles = -1;
  }
}

void ViewSelection::Assign(
  const PatternFamily& family, std::vector<unsigned int> entries, std::vector<float> morphTags)
{
  this->Selection.Assign(family, std::move(entries), std::move(morphTags));
  this->NumberOfTriangles = -1;
}

bool ViewSelection::SeesTheSame(const CullingInput& culling) const
{
  if (!culling.Culling || !this->LastView)
  {
    return !culling.Culling && !this->LastView;
  }
  return *this->LastView == *culling.View && this->LastCullingTime == culling.CullingTime &&
    this->LastHidesBackFaces == culling.HidesBackFaces;
}

void ViewSelection::UpdateGroups(const CullingInput& culling)
{
  const bool sameLevels = this->GroupsTime > this->LevelsTime;
  const bool sameView = this->SeesTheSame(culling);
  if (sameLevels && sameView)
  {
    return;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  if (!sameView)
  {
    this->LastHidden.swap(this->Hidden);
    const int last = this->NumberOfHiddenFaces;
    this->NumberOfHiddenFaces = culling.Culling
      ? culling.Culling->FindHidden(*culling.View, culling.HidesBackFaces, this->Hidden)
      : 0;
    this->LastView.reset(culling.Culling ? new CullingView(*culling.View) : nullptr);
    this->LastCullingTime = culling.CullingTime;
    this->LastHidesBackFaces = culling.HidesBackFaces;
    if (sameLevels && this->NumberOfHiddenFaces == last &&
      (last == 0 || this->Hidden == this->LastHidden))
    {
      return;
    }
  }
  this->Selection.Group(this->NumberOfHiddenFaces > 0 ? this->Hidden.data() : nullptr);
  this->GroupsTime.Modified();
  this->GroupsSeconds = vtkTimerLog::GetUniversalTime() - start;
}

vtkIdType ViewSelection::GetNumberOfTriangles()
{
  if (this->NumberOfTriangles < 0 && this->Valid)
  {
    // Fragments over no-data are discarded; what the filter leaves out is counted when asked for.
    this->NumberOfTriangles = this->Selection.GetNumberOfTriangles() -
      CountHoles(*this->Mesh, this->Selection, this->Holes);
  }
  return std::max<vtkIdType>(this->NumberOfTriangles, 0);
}
}
