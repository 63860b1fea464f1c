// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ReliefMetric.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(ReliefMetric);

void ReliefMetric::SetMetric(vtkDepthTagMetric* metric)
{
  this->Metric = metric;
  this->Modified();
}

void ReliefMetric::SetRelief(vtkPolyData* relief)
{
  this->Relief = relief;
  this->Modified();
}

bool ReliefMetric::ComputeTags(
  vtkPolyData*, const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  return this->Metric->ComputeTags(this->Relief, view, maximumLevel, tags);
}

bool ReliefMetric::ComputeEdgeTags(vtkPolyData*, const relevo::RefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges&, vtkFloatArray* tags)
{
  this->Edges.Update(this->Relief);
  return this->Metric->ComputeEdgeTags(this->Relief, view, maximumLevel, this->Edges, tags);
}

vtkMTimeType ReliefMetric::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Metric ? this->Metric->GetMTime() : 0,
    this->Relief ? this->Relief->GetMTime() : 0 });
}
