// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/ViewTime.h"

#include "Changes/LatestTime.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkMatrix4x4.h"

namespace relevo
{
vtkMTimeType GetViewTime(vtkDepthTagMetric* metric, const RefinementView& view)
{
  const bool ofCamera = metric && metric->IsViewDependent();
  const bool ofPlace = metric && metric->IsPlacementDependent();
  return GetLatestTime(
    0, { ofCamera ? view.Camera : nullptr, ofPlace ? view.ModelToWorld : nullptr });
}
}
