// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCompositeDepthTagMetric
 * @brief   combine several depth-tag metrics
 *
 * The depth-tag of a point depends on Mode. With l_i the level of metric i at the point and w_i its
 * weight, it is
 *
 *     MAXIMUM (default)    max_i  w_i l_i
 *     SUM                  sum_i  w_i l_i
 *     PRODUCT              MaximumLevel * product_i  (l_i / MaximumLevel)^w_i
 *
 * clamped to [0, MaximumLevel]. With the rule PER_EDGE, the levels of the edge are combined in the
 * same way. The maximum refines wherever one of the metrics requests it. The product refines only
 * where all metrics do. A weight of 0 disables a metric.
 *
 * The metric depends on the view if one of its metrics does. Tags of the other metrics are cached
 * until the metric, the mesh, the actor's matrix or MaximumLevel changes.
 *
 * Computing tags fails with an error if there are no metrics or if one of them fails.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkDepthTagMetric
 */
#ifndef vtkCompositeDepthTagMetric_h
#define vtkCompositeDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

#include <memory> // for std::unique_ptr

class RELEVOFILTERSREFINEMENT_EXPORT vtkCompositeDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkCompositeDepthTagMetric* New();
  vtkTypeMacro(vtkCompositeDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How levels are combined.
   */
  enum Modes
  {
    MAXIMUM = 0,
    SUM = 1,
    PRODUCT = 2
  };

  //@{
  /**
   * Set how levels are combined: MAXIMUM (0, the default), SUM (1) or PRODUCT (2). Other values are
   * rejected with an error.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  void SetModeToMaximum() { this->SetMode(MAXIMUM); }
  void SetModeToSum() { this->SetMode(SUM); }
  void SetModeToProduct() { this->SetMode(PRODUCT); }
  //@}

  /**
   * Return the mode as "Maximum", "Sum" or "Product".
   */
  const char* GetModeAsString();

  /**
   * Add a metric with a weight from 0 to 1e6. The default weight is 1. A null metric, this metric,
   * a metric that contains this metric, and weights out of range are rejected with an error.
   */
  void AddMetric(vtkDepthTagMetric* metric, double weight = 1.0);

  /**
   * Remove all metrics.
   */
  void RemoveAllMetrics();

  /**
   * Return the number of metrics.
   */
  int GetNumberOfMetrics();

  /**
   * Return the metric at `index`, counted from 0, or nullptr (None in Python) if there is none.
   */
  vtkDepthTagMetric* GetMetric(int index);

  /**
   * Return the weight of the metric at `index`, counted from 0, or 0 if there is none.
   */
  double GetWeight(int index);

  /**
   * Return the time of the latest change of this metric or the metrics it contains.
   */
  vtkMTimeType GetMTime() override;

  bool IsViewDependent() override;
  bool IsPlacementDependent() override;
  bool IsDisplacementDependent() override;
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkCompositeDepthTagMetric();
  ~vtkCompositeDepthTagMetric() override;

  int Mode = MAXIMUM;

private:
  vtkCompositeDepthTagMetric(const vtkCompositeDepthTagMetric&) = delete;
  void operator=(const vtkCompositeDepthTagMetric&) = delete;

  bool Contains(vtkDepthTagMetric* metric);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
