// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCombinedDepthTagMetric
 * @brief   a vtkCompositeDepthTagMetric of up to three metrics, for ParaView's properties
 *
 * ParaView sets each metric and each weight by a property. Computing tags without a metric is an
 * error.
 *
 * @sa vtkCompositeDepthTagMetric
 */
#ifndef vtkCombinedDepthTagMetric_h
#define vtkCombinedDepthTagMetric_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkCompositeDepthTagMetric.h"
#include "vtkSmartPointer.h" // for members

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkCombinedDepthTagMetric
  : public vtkCompositeDepthTagMetric
{
public:
  static vtkCombinedDepthTagMetric* New();
  vtkTypeMacro(vtkCombinedDepthTagMetric, vtkCompositeDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the metrics. The default is nullptr, which is no metric.
   */
  void SetFirst(vtkDepthTagMetric* metric) { this->SetPart(0, metric); }
  void SetSecond(vtkDepthTagMetric* metric) { this->SetPart(1, metric); }
  void SetThird(vtkDepthTagMetric* metric) { this->SetPart(2, metric); }
  //@}

  //@{
  /**
   * Set the weights of the metrics, from 0 to 1e6, default 1. A value out of range is an error and
   * changes nothing.
   */
  void SetFirstWeight(double weight) { this->SetWeight(0, weight); }
  double GetFirstWeight() { return this->Weights[0]; }
  void SetSecondWeight(double weight) { this->SetWeight(1, weight); }
  double GetSecondWeight() { return this->Weights[1]; }
  void SetThirdWeight(double weight) { this->SetWeight(2, weight); }
  double GetThirdWeight() { return this->Weights[2]; }
  //@}

protected:
  vtkCombinedDepthTagMetric();
  ~vtkCombinedDepthTagMetric() override;

private:
  vtkCombinedDepthTagMetric(const vtkCombinedDepthTagMetric&) = delete;
  void operator=(const vtkCombinedDepthTagMetric&) = delete;

  void SetPart(int index, vtkDepthTagMetric* metric);
  void SetWeight(int index, double weight);
  void Combine();

  vtkSmartPointer<vtkDepthTagMetric> Parts[3];
  double Weights[3] = { 1.0, 1.0, 1.0 };
};

#endif
