// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the metric of the options
 */
#ifndef ViewerMetric_h
#define ViewerMetric_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDepthTagMetric;
class vtkPolyData;
struct ViewerOptions;

/**
 * Creates a metric for `mesh`. Field variation uses the point array `array`. Throws ViewerError if
 * the metric needs an array and there is none.
 */
vtkSmartPointer<vtkDepthTagMetric> MakeMetric(
  const ViewerOptions& options, vtkPolyData* mesh, const std::string& arrayName);

#endif
