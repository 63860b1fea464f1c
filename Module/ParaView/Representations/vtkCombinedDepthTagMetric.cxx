// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCombinedDepthTagMetric.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCombinedDepthTagMetric);

vtkCombinedDepthTagMetric::vtkCombinedDepthTagMetric() = default;
vtkCombinedDepthTagMetric::~vtkCombinedDepthTagMetric() = default;

void vtkCombinedDepthTagMetric::SetPart(int index, vtkDepthTagMetric* metric)
{
  if (this->Parts[index] != metric)
  {
    this->Parts[index] = metric;
    this->Combine();
  }
}

void vtkCombinedDepthTagMetric::SetWeight(int index, double weight)
{
  if (!(weight >= 0.0 && weight <= 1e6))
  {
    vtkErrorMacro("Weights must be in [0, 1e6], got " << weight << ".");
    return;
  }
  if (this->Weights[index] != weight)
  {
    this->Weights[index] = weight;
    this->Combine();
  }
}

void vtkCombinedDepthTagMetric::Combine()
{
  this->RemoveAllMetrics();
  for (int i = 0; i < 3; ++i)
  {
    if (this->Parts[i])
    {
      this->AddMetric(this->Parts[i], this->Weights[i]);
    }
  }
}

void vtkCombinedDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (int i = 0; i < 3; ++i)
  {
    os << indent << "Part " << i << ": " << this->Parts[i].Get() << ", weight " << this->Weights[i]
       << "\n";
  }
}
