// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/CurveSelection.h"

#include "Curves/CurveMesh.h"
#include "View/CullingView.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

namespace relevo
{
#include "glsl/relevoCulling.glsl"

namespace
{
// The tolerance relative to the coordinates, because boxes and planes are stored as floats.
constexpr double Tolerance = 1e-6;
}

void CurveSelection::SetCurves(vtkPointSet* input, const CurveMesh& curves)
{
  this->Input = input;
  this->Curves = &curves;
  this->Tags.Reset();
  this->CurvesTime.Modified();
}

void CurveSelection::SetReaches(const std::vector<double>& reaches, const dvec3& origin)
{
  const CurveMesh& curves = *this->Curves;
  this->BoxesTime.Modified();
  this->Boxes.resize(2 * curves.GetCurves().size());
  vtkSMPTools::For(0, curves.GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        const CurveMesh::Curve& curve = curves.GetCurves()[c];
        dvec3 low(std::numeric_limits<double>::max());
        dvec3 high(std::numeric_limits<double>::lowest());
        double reach = 0.0;
        for (vtkIdType i = curve.FirstPoint; i <= curve.FirstPoint + curve.Degree; ++i)
        {
          const dvec3 point = dvec3(curves.GetPoints()[i]) - origin;
          low = min(low, point);
          high = max(high, point);
          reach = std::max(reach, std::abs(reaches[reaches.size() == 1 ? 0 : i]));
        }
        this->Boxes[2 * c] = vec3(0.5 * (low + high));
        this->Boxes[2 * c + 1] =
          vec3(0.5 * (high - low) + reach + Tolerance * max(abs(low), abs(high)));
      }
    });
}

bool CurveSelection::UpdateSegments(
  vtkAdaptiveRefinement* recipe, const RefinementView& view, std::string& error)
{
  Dependencies dependencies = Dependencies::On(this->CurvesTime);
  dependencies.AddObject(recipe);
  vtkDepthTagMetric* metric = recipe->GetMetric();
  view.AddTo(
    dependencies, metric && metric->IsPlacementDependent(), metric && metric->IsViewDependent());
  if (this->TagDependencies.Update(dependencies))
  {
    this->SegmentsTime.Modified();
    ++this->NumberOfEvaluations;
    this->Error.clear();
    this->Tags.Compute(recipe, this->Input, *this->Curves, view, this->Error);
  }
  error = this->Error;
  return this->Error.empty();
}

void CurveSelection::UpdateHidden(const CullingView* view)
{
  Dependencies sight = Dependencies::On(this->BoxesTime);
  if (view)
  {
    view->AddTo(sight);
  }
  if (!this->SightDependencies.Update(sight))
  {
    return;
  }
  const bool isCulled = view && view->Valid;
  this->Hidden.assign(isCulled ? this->Curves->GetCurves().size() : 0, 0);
  if (!isCulled)
  {
    return;
  }
  vec4 planes[CullingView::NumberOfPlanes];
  for (int i = 0; i < CullingView::NumberOfPlanes; ++i)
  {
    const float* plane = view->Planes[i];
    planes[i] = vec4(plane[0], plane[1], plane[2], plane[3]);
  }
  vtkSMPTools::For(0, this->Curves->GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        bool out = false;
        for (const vec4& plane : planes)
        {
          out = out || isBoxBeyond(this->Boxes[2 * c], this->Boxes[2 * c + 1], plane);
        }
        this->Hidden[c] = out ? 1 : 0;
      }
    });
}

void CurveSelection::MakeGroups()
{
  const std::vector<int>& all = this->Tags.GetSegments();
  const int most = all.empty() ? 0 : *std::max_element(all.begin(), all.end());
  std::vector<int> places(static_cast<size_t>(most) + 2, 0);
  const auto isShown = [this](size_t c) { return this->Hidden.empty() || !this->Hidden[c]; };
  for (size_t c = 0; c < all.size(); ++c)
  {
    places[all[c] + 1] += isShown(c) ? 1 : 0;
  }
  this->Groups.clear();
  for (int segments = 1; segments <= most; ++segments)
  {
    const int count = places[segments + 1];
    places[segments + 1] += places[segments];
    if (count > 0)
    {
      this->Groups.push_back({ segments, places[segments], count });
    }
  }
  this->Members.resize(static_cast<size_t>(places.back()));
  for (size_t c = 0; c < all.size(); ++c)
  {
    if (isShown(c))
    {
      this->Members[places[all[c]]++] = static_cast<unsigned int>(c);
    }
  }
}

bool CurveSelection::Update(vtkAdaptiveRefinement* recipe, const RefinementView& view,
  const CullingView* culling, std::string& error)
{
  if (!this->UpdateSegments(recipe, view, error))
  {
    return false;
  }
  this->UpdateHidden(culling);
  Dependencies made = this->SightDependencies;
  made.Add(this->SegmentsTime);
  if (this->GroupDependencies.Update(made))
  {
    this->MakeGroups();
    this->GroupsTime.Modified();
  }
  return true;
}

vtkIdType CurveSelection::CountDrawnSegments(int most) const
{
  vtkIdType count = 0;
  for (const Group& group : this->Groups)
  {
    count += static_cast<vtkIdType>(group.Count) * std::min(group.Segments, most);
  }
  return count;
}

vtkIdType CurveSelection::CountHiddenSegments(int most) const
{
  vtkIdType count = -this->CountDrawnSegments(most);
  for (int segments : this->Tags.GetSegments())
  {
    count += std::min(segments, most);
  }
  return count;
}
}
