// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth-tag metrics of every kind, with the ways to measure that differ most.
#ifndef RelevoAllMetrics_h
#define RelevoAllMetrics_h

#include "vtkDepthTagMetric.h"
#include "vtkSmartPointer.h"

#include <vector>

// All but vtkCompositeDepthTagMetric; the variation is that of the array of this name.
std::vector<vtkSmartPointer<vtkDepthTagMetric>> RelevoMakeAllMetrics(const char* arrayName);

// A composite of them: the sum of their levels, each with the same weight.
vtkSmartPointer<vtkDepthTagMetric> RelevoMakeSum(
  const std::vector<vtkSmartPointer<vtkDepthTagMetric>>& metrics, double weight);

#endif
