// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerMetric.h"

#include "ReliefMetric.h"
#include "ViewerMessages.h"
#include "ViewerOptions.h"

#include "vtkCurvatureDepthTagMetric.h"
#include "vtkCylinder.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <algorithm>

namespace
{
using Metric = vtkSmartPointer<vtkDepthTagMetric>;

Metric MakeDistance(const ViewerOptions& options)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(options.Reach.value_or(0.0));
  return metric.Get();
}

Metric MakeScreenEdge(const ViewerOptions& options)
{
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  metric->SetReferenceLength(options.Pixels.value_or(ViewerOptions::DefaultPixels));
  return metric.Get();
}

// Mean curvature, for the Gaussian one is blind to straight ridges and valleys.
Metric MakeCurvature()
{
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  metric->SetCurvatureTypeToMean();
  return metric.Get();
}

Metric MakeSilhouette(bool contour)
{
  vtkNew<vtkSilhouetteDepthTagMetric> metric;
  metric->SetCriterion(
    contour ? vtkSilhouetteDepthTagMetric::CONTOUR : vtkSilhouetteDepthTagMetric::NORMAL_ANGLE);
  return metric.Get();
}

// The field of a terrain is its height.
Metric MakeFieldVariation(vtkPolyData* relief)
{
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < relief->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(relief->GetPoint(i)[2]));
  }
  relief->GetPointData()->AddArray(heights);
  vtkNew<vtkFieldVariationDepthTagMetric> metric;
  metric->SetArrayName(heights->GetName());
  return metric.Get();
}

// Around a place, whatever the height; by default the terrain's middle.
Metric MakeRegion(const ViewerOptions& options, vtkPolyData* relief)
{
  double bounds[6];
  relief->GetBounds(bounds);
  const double size = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const std::array<double, 3> region = options.Region.value_or(std::array<double, 3>{
    { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.1 * size } });
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetAxis(0.0, 0.0, 1.0);
  cylinder->SetCenter(region[0], region[1], 0.0);
  cylinder->SetRadius(region[2]);
  vtkNew<vtkRegionDepthTagMetric> metric;
  metric->SetImplicitFunction(cylinder);
  metric->SetFallOff(2.0 * region[2]);
  return metric.Get();
}

Metric MakeOwnMetric(const ViewerOptions& options, vtkPolyData* relief)
{
  switch (options.Metric)
  {
    case ViewerOptions::MetricType::Distance:
      return MakeDistance(options);
    case ViewerOptions::MetricType::ScreenEdge:
      return MakeScreenEdge(options);
    case ViewerOptions::MetricType::Curvature:
      return MakeCurvature();
    case ViewerOptions::MetricType::Silhouette:
      return MakeSilhouette(false);
    case ViewerOptions::MetricType::Contour:
      return MakeSilhouette(true);
    case ViewerOptions::MetricType::ViewDependent:
      return Metric::Take(vtkViewDependentDepthTagMetric::New());
    case ViewerOptions::MetricType::Field:
      return MakeFieldVariation(relief);
    case ViewerOptions::MetricType::Region:
      return MakeRegion(options, relief);
  }
  return nullptr;
}
}

Metric MakeMetric(const ViewerOptions& options, vtkPolyData* relief, ViewerMessages& messages)
{
  const Metric own = MakeOwnMetric(options, relief);
  messages.Observe(own);
  vtkNew<ReliefMetric> metric;
  metric->SetMetric(own);
  metric->SetRelief(relief);
  return metric.Get();
}
