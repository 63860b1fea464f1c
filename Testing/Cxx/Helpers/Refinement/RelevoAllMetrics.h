// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth-tag metrics of every kind, in their most different modes.
#ifndef RelevoAllMetrics_h
#define RelevoAllMetrics_h

#include "vtkDepthTagMetric.h"
#include "vtkSmartPointer.h"

#include <vector>

// All metrics except vtkCompositeDepthTagMetric. Field variation uses the array of this name.
std::vector<vtkSmartPointer<vtkDepthTagMetric>> RelevoMakeAllMetrics(const char* arrayName);

// A composite that sums their levels with equal weights.
vtkSmartPointer<vtkDepthTagMetric> RelevoMakeSum(
  const std::vector<vtkSmartPointer<vtkDepthTagMetric>>& metrics, double weight);

#endif
