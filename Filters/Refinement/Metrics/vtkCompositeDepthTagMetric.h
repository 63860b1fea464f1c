// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCompositeDepthTagMetric
 * @brief   several depth-tag metrics as one
 *
 * With l_i the level of the i-th metric at a point and w_i its weight, the depth-tag is by Mode
 *
 *     MAXIMUM (default)    max_i  w_i l_i
 *     SUM                  sum_i  w_i l_i
 *     PRODUCT              MaximumLevel * product_i  (l_i / MaximumLevel)^w_i
 *
 * clamped to [0, MaximumLevel]; by the rule PER_EDGE, that of an edge from the levels that the
 * metrics give it. The maximum refines what any of the metrics asks for, the product only what all
 * ask for; a weight of 0 leaves a metric out.
 *
 * It depends on the view if any of its metrics does. What refines a mesh keeps the tags of those
 * that do not while neither the metric, the mesh, the actor's matrix nor MaximumLevel changes.
 *
 * Errors when tags are computed: no metrics; a metric that fails, after its own error.
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
   * How levels are combined: MAXIMUM (0, the default), SUM (1) or PRODUCT (2). Another value is an
   * error and changes nothing.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  void SetModeToMaximum() { this->SetMode(MAXIMUM); }
  void SetModeToSum() { this->SetMode(SUM); }
  void SetModeToProduct() { this->SetMode(PRODUCT); }
  //@}

  /**
   * "Maximum", "Sum" or "Product".
   */
  const char* GetModeAsString();

  /**
   * Add a metric, with a weight from 0 to 1e6, default 1. No metric, this metric itself, one that
   * contains it, or another weight is an error and adds nothing.
   */
  void AddMetric(vtkDepthTagMetric* metric, double weight = 1.0);

  /**
   * Remove all metrics.
   */
  void RemoveAllMetrics();

  /**
   * How many metrics have been added.
   */
  int GetNumberOfMetrics();

  /**
   * The metric added as number `index`, counted from 0; None (nullptr) if there is none.
   */
  vtkDepthTagMetric* GetMetric(int index);

  /**
   * The weight of the metric added as number `index`, counted from 0; 0 if there is none.
   */
  double GetWeight(int index);

  /**
   * Includes the times of the metrics.
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
