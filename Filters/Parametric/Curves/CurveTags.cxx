// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveTags.h"

#include "Curves/CurveMesh.h"
#include "Levels/EdgeLevels.h"
#include "Mathematics/RefinementMathematics.h"
#include "Patterns/SegmentSteps.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Sets the tag of each curve to getTag(curve), in parallel.
template <typename GetTag>
void SetTags(const CurveMesh& mesh, std::vector<float>& tags, const GetTag& getTag)
{
  tags.resize(mesh.GetCurves().size());
  vtkSMPTools::For(0, mesh.GetNumberOfCurves(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        tags[c] = getTag(mesh.GetCurves()[c]);
      }
    });
}
}

CurveTags::CurveTags() = default;
CurveTags::~CurveTags() = default;

void CurveTags::Reset()
{
  this->Polygons = nullptr;
  this->OfPoints.Reset();
}

bool CurveTags::Compute(vtkAdaptiveRefinement* recipe, vtkPointSet* input, const CurveMesh& mesh,
  const RefinementView& view, std::string& error)
{
  const auto getPolygons = [&]
  {
    if (!this->Polygons)
    {
      this->Polygons = mesh.NewControlPolygons();
    }
    return this->Polygons.Get();
  };
  if (!this->OfPoints.Compute(recipe, input, getPolygons, view, error))
  {
    return false;
  }
  if (this->OfPoints.GetKind() != PointTags::OF_METRIC)
  {
    this->Polygons = nullptr;
  }
  this->TakeTags(mesh, static_cast<float>(recipe->GetMaximumLevel()));
  this->ChooseSegments(recipe);
  return true;
}

void CurveTags::TakeTags(const CurveMesh& mesh, float highest)
{
  const float* tags = this->OfPoints.GetValues();
  switch (this->OfPoints.GetKind())
  {
    case PointTags::OF_ARRAY:
      SetTags(mesh, this->Tags,
        [&, nodes = mesh.GetNodes().data()](const CurveMesh::Curve& curve) {
          return meanTag(
            tags[nodes[curve.FirstPoint]], tags[nodes[curve.FirstPoint + curve.Degree]]);
        });
      break;
    case PointTags::OF_METRIC:
      SetTags(mesh, this->Tags,
        [=](const CurveMesh::Curve& curve)
        {
          const float* first = tags + curve.FirstPoint;
          return *std::max_element(first, first + curve.Degree + 1);
        });
      break;
    default:
      SetTags(mesh, this->Tags, [=](const CurveMesh::Curve&) { return highest; });
  }
}

void CurveTags::ChooseSegments(vtkAdaptiveRefinement* recipe)
{
  const bool wholeNumbers = recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
  const SegmentSteps steps = SegmentSteps::Make(wholeNumbers);
  const float offset = static_cast<float>(recipe->GetLevelOffset());
  const int highest = recipe->GetMaximumLevel();
  this->Segments.resize(this->Tags.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Tags.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType c = begin; c < end; ++c)
      {
        float& tag = this->Tags[c];
        tag = clampTag(tag, offset, highest);
        this->Segments[c] =
          steps.GetSegments(wholeNumbers ? SegmentSteps::GetWholeNumberStep(tag) : levelOfTag(tag));
      }
    });
}
}
