// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   when what a metric sees of the world last changed
 */
#ifndef ViewTime_h
#define ViewTime_h

#include "Changes/LatestTime.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkMatrix4x4.h"

namespace relevo
{
/// The latest change of the camera and of the mesh's place, where the metric's tags depend on them;
/// without a metric none does.
inline vtkMTimeType GetViewTime(vtkDepthTagMetric* metric, const RefinementView& view)
{
  const bool ofCamera = metric && metric->IsViewDependent();
  const bool ofPlace = metric && metric->IsPlacementDependent();
  return GetLatestTime(
    0, { ofCamera ? view.Camera : nullptr, ofPlace ? view.ModelToWorld : nullptr });
}
}

#endif
