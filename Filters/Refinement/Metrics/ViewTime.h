// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   when what a metric sees of the world last changed
 */
#ifndef ViewTime_h
#define ViewTime_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkMTimeType

class vtkDepthTagMetric;

namespace relevo
{
struct RefinementView;

/// The latest change of the camera and of the mesh's place, where the metric's tags depend on them;
/// without a metric none does.
RELEVOFILTERSREFINEMENT_EXPORT vtkMTimeType GetViewTime(
  vtkDepthTagMetric* metric, const RefinementView& view);
}

#endif
