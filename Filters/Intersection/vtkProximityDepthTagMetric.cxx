// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProximityDepthTagMetric.h"

#include "Boxes/BoxTree.h"
#include "Checks/SettingChecks.h"
#include "Levels/TriangleTags.h"
#include "Mesh/NearestBox.h"
#include "Mesh/SurfaceTriangles.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "View/RefinementView.h"
#include "View/WorldView.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkProximityDepthTagMetric);

namespace
{
using glm::dvec3;

constexpr double LevelInside = 5.0;
constexpr double MaximumSegmentsOutside = 24.0;

double GetLevel(double share)
{
  if (share == 0.0)
  {
    return LevelInside;
  }
  return share > 1.0 ? 0.0
                     : std::log2(MaximumSegmentsOutside - (MaximumSegmentsOutside - 1.0) * share);
}

class ProximityEvaluator : public relevo::MetricEvaluator
{
public:
  ProximityEvaluator(
    vtkProximityDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    this->ComputeLevels(view, maximumLevel);
    relevo::TagPointsByTriangles(*this->GetMesh().GetTriangles(), this->Levels.data(), tags);
    return true;
  }

  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    this->ComputeLevels(view, maximumLevel);
    relevo::TagEdgesByTriangles(*this->GetMesh().GetEdges(), this->Levels.data(), tags);
    return true;
  }

private:
  void BuildTree();
  void ComputeLevels(const relevo::RefinementView& view, int maximumLevel);

  vtkSmartPointer<vtkProximityDepthTagMetric> Metric;
  relevo::DoubleBoxTree Tree;
  vtkMTimeType TreeTime = 0;
  std::vector<float> Levels; // one per triangle
};

void ProximityEvaluator::BuildTree()
{
  if (this->TreeTime == this->Metric->GetMTime())
  {
    return;
  }
  std::vector<relevo::DoubleBox> boxes(static_cast<std::size_t>(this->Metric->GetNumberOfBoxes()));
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    double bounds[6];
    this->Metric->GetBox(static_cast<int>(i), bounds);
    boxes[i].Low = { { bounds[0], bounds[2], bounds[4] } };
    boxes[i].High = { { bounds[1], bounds[3], bounds[5] } };
  }
  this->Tree.Build(boxes);
  this->TreeTime = this->Metric->GetMTime();
}

void ProximityEvaluator::ComputeLevels(const relevo::RefinementView& view, int maximumLevel)
{
  this->BuildTree();
  const relevo::SurfaceTriangles& surface = *this->GetMesh().GetTriangles();
  const auto& triangles = surface.GetTriangles();
  const relevo::Placement placement(view);
  const double distance = this->Metric->GetDistance();
  this->Levels.resize(triangles.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        dvec3 centroid(0.0);
        for (vtkIdType corner : triangles[t])
        {
          dvec3 point;
          surface.GetPoint(corner, &point[0]);
          centroid += point / 3.0;
        }
        const dvec3 x = placement.GetPoint(centroid);
        const double level = GetLevel(relevo::GetBoxDistance(this->Tree, &x[0], distance));
        this->Levels[t] = static_cast<float>(std::min(level, static_cast<double>(maximumLevel)));
      }
    });
}

vtkSmartPointer<vtkLookupTable> MakeTable()
{
  constexpr int numberOfColors = 256;
  const double red[3] = { 0.85, 0.1, 0.1 };
  const double nearest[3] = { 1.0, 0.45, 0.0 };
  const double farthest[3] = { 1.0, 0.85, 0.55 };
  const double blue[3] = { 0.2, 0.35, 0.85 };
  const double highest = std::log2(MaximumSegmentsOutside);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(numberOfColors);
  table->SetTableRange(0.0, LevelInside);
  for (int i = 0; i < numberOfColors; ++i)
  {
    // The lowest of the levels that have this colour.
    const double level = LevelInside * i / numberOfColors;
    const double t = level / highest;
    const double* fixed = i == 0 ? blue : (t > 1.0 ? red : nullptr);
    double color[3];
    for (int c = 0; c < 3; ++c)
    {
      color[c] = fixed ? fixed[c] : (1.0 - t) * farthest[c] + t * nearest[c];
    }
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  return table;
}
}

vtkProximityDepthTagMetric::vtkProximityDepthTagMetric() = default;
vtkProximityDepthTagMetric::~vtkProximityDepthTagMetric() = default;

void vtkProximityDepthTagMetric::AddBox(const double bounds[6])
{
  bool isBox = true;
  for (int i = 0; i < 6; i += 2)
  {
    isBox = isBox && std::isfinite(bounds[i]) && std::isfinite(bounds[i + 1]) &&
      bounds[i] <= bounds[i + 1];
  }
  if (!isBox)
  {
    std::ostringstream text;
    for (int i = 0; i < 6; ++i)
    {
      text << (i == 0 ? "" : ", ") << bounds[i];
    }
    vtkErrorMacro(
      "A box must be finite, with minima not above their maxima, got (" << text.str() << ").");
    return;
  }
  this->Boxes.push_back({ { bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5] } });
  this->Modified();
}

void vtkProximityDepthTagMetric::RemoveAllBoxes()
{
  if (!this->Boxes.empty())
  {
    this->Boxes.clear();
    this->Modified();
  }
}

int vtkProximityDepthTagMetric::GetNumberOfBoxes()
{
  return static_cast<int>(this->Boxes.size());
}

void vtkProximityDepthTagMetric::GetBox(int index, double bounds[6])
{
  if (index < 0 || index >= this->GetNumberOfBoxes())
  {
    vtkErrorMacro("There is no box " << index << ": the number of boxes is "
                                     << this->GetNumberOfBoxes() << ".");
    return;
  }
  std::copy(this->Boxes[index].begin(), this->Boxes[index].end(), bounds);
}

void vtkProximityDepthTagMetric::SetDistance(double distance)
{
  relevo::SetInRange(this, "Distance", this->Distance, distance, 0.0, relevo::LargestDouble);
}

vtkLookupTable* vtkProximityDepthTagMetric::GetLookupTable()
{
  if (!this->LookupTable)
  {
    this->LookupTable = MakeTable();
  }
  return this->LookupTable;
}

std::unique_ptr<relevo::MetricEvaluator> vtkProximityDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<ProximityEvaluator>(this, mesh);
}

void vtkProximityDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBoxes: " << this->Boxes.size() << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
}
