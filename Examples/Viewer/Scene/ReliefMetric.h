// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefMetric
 * @brief   a metric that looks at a terrain as it is displaced
 *
 * The coarse mesh of a terrain is flat, for its relief is in the displacement. Curvature, outline
 * and lengths on the screen are those of the same mesh with its points on the relief.
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

  /// The relief, with the points and cells of the mesh that will be refined.
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
