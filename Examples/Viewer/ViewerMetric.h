// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the metric that the options ask for
 */
#ifndef ViewerMetric_h
#define ViewerMetric_h

#include "vtkSmartPointer.h"

class vtkDepthTagMetric;
class vtkPolyData;
class ViewerMessages;
struct ViewerOptions;

/**
 * A metric for a mesh whose points, moved onto the terrain, are those of `relief`. `relief` gets
 * the array that the metric needs. Its errors go to `messages`.
 */
vtkSmartPointer<vtkDepthTagMetric> MakeMetric(
  const ViewerOptions& options, vtkPolyData* relief, ViewerMessages& messages);

#endif
