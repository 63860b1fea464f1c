// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefMetric
 * @brief   evaluates a metric on the displaced terrain
 *
 * The coarse mesh of a terrain is flat, because heights are in the displacement. This class
 * evaluates curvature, silhouette and lengths on the screen on the same mesh with displaced points.
 */
#ifndef ReliefMetric_h
#define ReliefMetric_h

#include "vtkDepthTagMetric.h"
#include "vtkPolyData.h"     // for members
#include "vtkSmartPointer.h" // for members

class ReliefMetric : public vtkDepthTagMetric
{
public:
  static ReliefMetric* New();
  vtkTypeMacro(ReliefMetric, vtkDepthTagMetric);

  void SetMetric(vtkDepthTagMetric* metric);
  vtkDepthTagMetric* GetMetric() { return this->Metric; }

  /// Sets the displaced mesh, with the points and cells of the mesh to refine.
  void SetRelief(vtkPolyData* relief);
  vtkPolyData* GetRelief() { return this->Relief; }

  bool IsViewDependent() override { return this->Metric->IsViewDependent(); }
  bool IsPlacementDependent() override { return this->Metric->IsPlacementDependent(); }
  bool IsDisplacementDependent() override { return this->Metric->IsDisplacementDependent(); }
  bool IsAbsolute() override { return this->Metric->IsAbsolute(); }
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
  vtkMTimeType GetMTime() override;

private:
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  vtkSmartPointer<vtkPolyData> Relief;
};

#endif
