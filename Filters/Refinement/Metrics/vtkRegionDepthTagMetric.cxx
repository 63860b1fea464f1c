// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRegionDepthTagMetric.h"

#include "Checks/SettingChecks.h"
#include "Levels/LevelFunctions.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/SurfaceShape.h"
#include "View/RefinementView.h"
#include "View/WorldView.h"
#include "vtkFloatArray.h"
#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace
{
using glm::dvec3;

constexpr double AutomaticFallOff = 0.1; // relative to the bounding box's diagonal

// Returns NaN if the distance is not known.
double GetDistance(vtkImplicitFunction* function, dvec3 x)
{
  const double value = function->FunctionValue(&x[0]);
  if (value <= 0.0)
  {
    return 0.0;
  }
  dvec3 gradient(0.0);
  function->FunctionGradient(&x[0], &gradient[0]);
  return value / glm::length(gradient);
}

// The region of a metric, which computes levels from the distance of points.
class Region
{
public:
  Region(vtkRegionDepthTagMetric* metric, std::mutex& functionMutex, relevo::MetricMesh& mesh,
    const relevo::RefinementView& view)
    : ToWorld(view)
    , Function(metric->GetImplicitFunction())
    , FunctionMutex(functionMutex)
    , Center(metric->GetCenter()[0], metric->GetCenter()[1], metric->GetCenter()[2])
    , Radius(metric->GetRadius())
    , FallOff(metric->GetFallOff() > 0.0
          ? metric->GetFallOff()
          : AutomaticFallOff * this->ToWorld.GetDiagonal(relevo::GetShape(mesh).GetCornerBox()))
  {
  }

  float GetLevel(const dvec3& point, int maximumLevel) const
  {
    const dvec3 x = this->ToWorld.GetPoint(point);
    double distance = vtkMath::Nan();
    if (std::isfinite(glm::dot(x, dvec3(1.0))))
    {
      distance = this->Function ? GetDistance(this->Function, x)
                                : std::max(glm::distance(x, this->Center) - this->Radius, 0.0);
    }
    // Distances are in units of FallOff, so that they are in the range of floats.
    return relevo::regionLevel(
      static_cast<float>(distance > 0.0 ? std::min(distance / this->FallOff, 2.0) : distance), 1.0f,
      maximumLevel);
  }

  // Calls f(begin, end) for ranges of n items. Only one thread at a time evaluates a VTK function,
  // because some functions write members during evaluation.
  template <typename Work>
  void For(vtkIdType n, Work&& f) const
  {
    if (this->Function)
    {
      const std::lock_guard<std::mutex> lock(this->FunctionMutex);
      f(0, n);
    }
    else
    {
      vtkSMPTools::For(0, n, f);
    }
  }

private:
  relevo::Placement ToWorld;
  vtkImplicitFunction* Function;
  std::mutex& FunctionMutex;
  dvec3 Center;
  double Radius;
  double FallOff;
};

class RegionEvaluator : public relevo::MetricEvaluator
{
public:
  RegionEvaluator(vtkRegionDepthTagMetric* metric, std::mutex& functionMutex,
    const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
    , FunctionMutex(functionMutex)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;
  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

private:
  vtkSmartPointer<vtkRegionDepthTagMetric> Metric;
  std::mutex& FunctionMutex; // of the metric
};

bool RegionEvaluator::ComputeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->Metric->GetImplicitFunction() && this->Metric->GetRadius() == 0.0)
  {
    vtkErrorWithObjectMacro(this->Metric.Get(),
      "There is no region: call SetImplicitFunction(), or SetCenter() and SetRadius().");
    return false;
  }
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(numberOfPoints);
  if (numberOfPoints == 0)
  {
    return true;
  }
  const Region region(this->Metric, this->FunctionMutex, this->GetMesh(), view);
  region.For(numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        dvec3 x;
        mesh->GetPoints()->GetPoint(point, &x[0]);
        tags->SetValue(point, region.GetLevel(x, maximumLevel));
      }
    });
  tags->Modified();
  return true;
}

bool RegionEvaluator::ComputeEdgeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  vtkNew<vtkFloatArray> pointTags;
  if (!this->ComputeTags(view, maximumLevel, pointTags))
  {
    return false;
  }
  const relevo::SurfaceEdges& edges = *this->GetMesh().GetEdges();
  const Region region(this->Metric, this->FunctionMutex, this->GetMesh(), view);
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(edges.GetNumberOfEdges());
  region.For(edges.GetNumberOfEdges(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType edge = begin; edge < end; ++edge)
      {
        const int* places = edges.GetEdges()[edge].MergedPoints;
        dvec3 ends[2];
        edges.GetTriangles().GetPoint(places[0], &ends[0][0]);
        edges.GetTriangles().GetPoint(places[1], &ends[1][0]);
        const dvec3 middle = 0.5 * ends[0] + 0.5 * ends[1];
        tags->SetValue(edge,
          std::max({ pointTags->GetValue(places[0]), region.GetLevel(middle, maximumLevel),
            pointTags->GetValue(places[1]) }));
      }
    });
  tags->Modified();
  return true;
}
}

vtkStandardNewMacro(vtkRegionDepthTagMetric);

vtkRegionDepthTagMetric::vtkRegionDepthTagMetric() = default;
vtkRegionDepthTagMetric::~vtkRegionDepthTagMetric() = default;

vtkCxxSetSmartPointerMacro(vtkRegionDepthTagMetric, ImplicitFunction, vtkImplicitFunction);

vtkImplicitFunction* vtkRegionDepthTagMetric::GetImplicitFunction()
{
  return this->ImplicitFunction;
}

void vtkRegionDepthTagMetric::SetCenter(double x, double y, double z)
{
  relevo::SetVector<3>(
    this, "Center", this->Center, { x, y, z }, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkRegionDepthTagMetric::SetRadius(double radius)
{
  relevo::SetInRange(this, "Radius", this->Radius, radius, 0.0, static_cast<double>(VTK_FLOAT_MAX));
}

void vtkRegionDepthTagMetric::SetFallOff(double distance)
{
  relevo::SetInRange(
    this, "FallOff", this->FallOff, distance, 0.0, static_cast<double>(VTK_FLOAT_MAX));
}

vtkMTimeType vtkRegionDepthTagMetric::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

std::unique_ptr<relevo::MetricEvaluator> vtkRegionDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<RegionEvaluator>(this, this->FunctionMutex, mesh);
}

void vtkRegionDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "Center: (" << this->Center[0] << ", " << this->Center[1] << ", "
     << this->Center[2] << ")\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "FallOff: " << this->FallOff << "\n";
}
