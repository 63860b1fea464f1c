// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoAllMetrics.h"

#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkNew.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

std::vector<vtkSmartPointer<vtkDepthTagMetric>> RelevoMakeAllMetrics(const char* arrayName)
{
  vtkNew<vtkDistanceDepthTagMetric> distance;
  vtkNew<vtkDistanceDepthTagMetric> pixels;
  pixels->SetReferenceLength(5.0);
  vtkNew<vtkDistanceDepthTagMetric> centroids;
  centroids->SetMeasureToCentroids();
  vtkNew<vtkScreenEdgeDepthTagMetric> screen;
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
  vtkNew<vtkSilhouetteDepthTagMetric> contour;
  contour->SetCriterionToContour();
  vtkNew<vtkViewDependentDepthTagMetric> viewDependent;
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  vtkNew<vtkFieldVariationDepthTagMetric> field;
  field->SetArrayName(arrayName);
  vtkNew<vtkRegionDepthTagMetric> region;
  region->SetRadius(0.4);
  return { distance.Get(), pixels.Get(), centroids.Get(), screen.Get(), silhouette.Get(),
    contour.Get(), viewDependent.Get(), curvature.Get(), field.Get(), region.Get() };
}

vtkSmartPointer<vtkDepthTagMetric> RelevoMakeSum(
  const std::vector<vtkSmartPointer<vtkDepthTagMetric>>& metrics, double weight)
{
  vtkNew<vtkCompositeDepthTagMetric> sum;
  sum->SetModeToSum();
  for (vtkDepthTagMetric* metric : metrics)
  {
    sum->AddMetric(metric, weight);
  }
  return sum.Get();
}
