// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the time when the view of a metric last changed
 */
#ifndef ViewTime_h
#define ViewTime_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkMTimeType

class vtkDepthTagMetric;

namespace relevo
{
struct RefinementView;

/// Return the latest change of the camera and the mesh's placement, if the metric's tags depend on
/// them. Without a metric, nothing depends on them.
RELEVOFILTERSREFINEMENT_EXPORT vtkMTimeType GetViewTime(
  vtkDepthTagMetric* metric, const RefinementView& view);
}

#endif
