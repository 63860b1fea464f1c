// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the metric that the options ask for
 */
#ifndef ViewerMetric_h
#define ViewerMetric_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDepthTagMetric;
class vtkPolyData;
struct ViewerOptions;

/**
 * A metric that looks at `mesh`; the array of points' numbers is that of the field. Throws
 * ViewerError where there is none though it is needed.
 */
vtkSmartPointer<vtkDepthTagMetric> MakeMetric(
  const ViewerOptions& options, vtkPolyData* mesh, const std::string& arrayName);

#endif
