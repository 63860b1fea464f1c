// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/DepthTags.h"

#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Points/MergedPoints.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>

namespace relevo
{
namespace
{
constexpr double LargestTag = 1e38;

float LimitTag(double tag)
{
  return static_cast<float>(std::min(std::max(tag, -LargestTag), LargestTag));
}

bool AreFinite(const float* values, vtkIdType number)
{
  std::atomic<bool> finite(true);
  vtkSMPTools::For(0, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      bool all = true;
      for (vtkIdType i = begin; i < end; ++i)
      {
        all &= std::isfinite(values[i]);
      }
      if (!all)
      {
        finite = false;
      }
    });
  return finite;
}
}

bool TakeDepthTags(
  vtkAbstractArray* values, vtkIdType numberOfPoints, float* tags, std::string& error)
{
  const std::string name = values->GetName() ? values->GetName() : "";
  vtkDataArray* array = vtkDataArray::SafeDownCast(values);
  if (!array)
  {
    error = "point array \"" + name + "\" of depth-tags holds no numbers";
    return false;
  }
  std::ostringstream text;
  text << "point array \"" << name << "\" of depth-tags ";
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != numberOfPoints)
  {
    text << "has " << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components, but one value for each of " << numberOfPoints << " points is needed";
    error = text.str();
    return false;
  }
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    const double tag = array->GetComponent(point, 0);
    if (std::isnan(tag))
    {
      text << "is NaN at point " << point;
      error = text.str();
      return false;
    }
    tags[point] = LimitTag(tag);
  }
  return true;
}

bool ComputeDepthTags(MetricEvaluator& evaluator, const RefinementView& view, int maximumLevel,
  bool perEdge, vtkFloatArray* tags, std::string& error)
{
  tags->Reset();
  tags->SetNumberOfComponents(1);
  if (!(perEdge ? evaluator.ComputeEdgeTags(view, maximumLevel, tags)
                : evaluator.ComputeTags(view, maximumLevel, tags)))
  {
    error = GetNoTagsError(evaluator.GetMetric());
    return false;
  }
  MetricMesh& mesh = evaluator.GetMesh();
  const vtkIdType expected =
    perEdge ? mesh.GetEdges()->GetNumberOfEdges() : mesh.GetPolyData()->GetNumberOfPoints();
  std::ostringstream text;
  text << evaluator.GetMetric()->GetClassName();
  if (tags->GetNumberOfComponents() != 1 || tags->GetNumberOfTuples() != expected)
  {
    text << " returned " << tags->GetNumberOfValues() << " tags for " << expected
         << (perEdge ? " edges" : " points");
    error = text.str();
    return false;
  }
  float* values = tags->GetPointer(0);
  if (AreFinite(values, expected))
  {
    return true;
  }
  const float* nan = std::find_if(values, values + expected, [](float v) { return std::isnan(v); });
  if (nan != values + expected)
  {
    text << " returned a tag that is NaN at " << (perEdge ? "edge " : "point ") << nan - values;
    error = text.str();
    return false;
  }
  std::transform(values, values + expected, values, LimitTag);
  return true;
}

std::string GetNoTagsError(vtkDepthTagMetric* metric)
{
  return std::string(metric->GetClassName()) +
    " returned no depth-tags for this mesh and view; its own error gives the reason";
}

bool TagEdgesByPoints(vtkDepthTagMetric* metric, const SurfaceEdges& edges,
  vtkFloatArray* pointTags, vtkFloatArray* tags)
{
  const vtkIdType numberOfPoints = edges.GetTriangles().GetNumberOfPoints();
  if (pointTags->GetNumberOfValues() != numberOfPoints)
  {
    vtkErrorWithObjectMacro(metric,
      "ComputeTags() returned " << pointTags->GetNumberOfValues() << " tags for " << numberOfPoints
                                << " points.");
    return false;
  }
  float* values = pointTags->GetPointer(0);
  UniteTags(edges.GetTriangles().GetMergedPoints(), values);
  TagEdges(edges, tags,
    [&](int edge)
    {
      const int* mergedPoints = edges.GetEdges()[edge].MergedPoints;
      return 0.5f * (values[mergedPoints[0]] + values[mergedPoints[1]]);
    });
  return true;
}
}
