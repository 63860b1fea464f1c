// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerMetric.h"

#include "Options/ViewerOptions.h"
#include "Scene/ViewerFlow.h"
#include "Scene/ViewerPatches.h"
#include "Text/ViewerMessages.h"

#include "vtkControlNetDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkCylinder.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkHeightErrorDepthTagMetric.h"
#include "vtkImplicitFunction.h"
#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkSphere.h"
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
  if (options.IsMesh)
  {
    // A bulge above an edge that is seen end-on is fully visible.
    metric->SetMeasureToSphereDiameter();
  }
  return metric.Get();
}

// Uses the mean curvature, because the Gaussian curvature of straight ridges and valleys is 0.
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

Metric MakeFieldVariation(const ViewerOptions& options, const std::string& arrayName)
{
  if (arrayName.empty())
  {
    throw ViewerError(options.Input +
      (options.Array.empty()
          ? " has no active point array for --metric field; select one with --array NAME"
          : ": --metric field requires a point array, and '" + options.Array +
            "' is a cell array"));
  }
  vtkNew<vtkFieldVariationDepthTagMetric> metric;
  metric->SetArrayName(arrayName.c_str());
  return metric.Get();
}

Metric MakeHeightError(const ViewerOptions& options)
{
  vtkNew<vtkHeightErrorDepthTagMetric> metric;
  metric->SetScreenSpaceError(options.Error.value_or(metric->GetScreenSpaceError()));
  metric->SetMaximumError(options.Tolerance.value_or(0.0));
  return metric.Get();
}

Metric MakeMicroError(const ViewerOptions& options)
{
  vtkNew<vtkMicroMeshErrorDepthTagMetric> metric;
  metric->SetScreenSpaceError(options.Error.value_or(metric->GetScreenSpaceError()));
  return metric.Get();
}

// On a terrain, the region extends over all heights.
vtkSmartPointer<vtkImplicitFunction> MakeRegionFunction(
  const ViewerOptions& options, const double centre[3], double radius)
{
  if (options.IsMesh)
  {
    vtkNew<vtkSphere> sphere;
    sphere->SetCenter(centre[0], centre[1], centre[2]);
    sphere->SetRadius(radius);
    return sphere.Get();
  }
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetAxis(0.0, 0.0, 1.0);
  cylinder->SetCenter(centre[0], centre[1], 0.0);
  cylinder->SetRadius(radius);
  return cylinder.Get();
}

// The default centre is a terrain's centre, or a mesh's first point, which lies on its surface.
Metric MakeRegion(const ViewerOptions& options, vtkPolyData* mesh)
{
  double bounds[6];
  double centre[3];
  mesh->GetBounds(bounds);
  options.IsMesh ? mesh->GetPoint(0, centre) : mesh->GetCenter(centre);
  double radius = 0.1 * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  if (options.Region)
  {
    std::copy(options.Region->begin(), options.Region->end() - 1, centre);
    radius = options.Region->back();
  }
  vtkNew<vtkRegionDepthTagMetric> metric;
  metric->SetImplicitFunction(MakeRegionFunction(options, centre, radius));
  metric->SetFallOff(2.0 * radius);
  return metric.Get();
}
}

//------------------------------------------------------------------------------
Metric MakeMetric(const ViewerOptions& options, vtkPolyData* mesh, const std::string& arrayName)
{
  if (options.IsFlowMetric())
  {
    return MakeFlowMetric(options);
  }
  switch (options.GetMetric())
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
      return MakeFieldVariation(options, arrayName);
    case ViewerOptions::MetricType::Region:
      return MakeRegion(options, mesh);
    case ViewerOptions::MetricType::Error:
      return options.IsMicroMesh() ? MakeMicroError(options) : MakeErrorMetric(options);
    case ViewerOptions::MetricType::ControlNet:
      return Metric::Take(vtkControlNetDepthTagMetric::New());
    case ViewerOptions::MetricType::Height:
      return MakeHeightError(options);
  }
  return nullptr;
}
