// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewRanks.h"

#include "vtkInformation.h"
#include "vtkPVRenderView.h"

namespace relevo
{
namespace
{
bool IsDistributed(vtkPVRenderView* view, bool hasLevelOfDetail)
{
  return hasLevelOfDetail ? view->GetUseDistributedRenderingForLODRender()
                          : view->GetUseDistributedRenderingForRender();
}
}

bool IsDrawnByRanks(vtkPVRenderView* view)
{
  return IsDistributed(view, view->GetUsedLODForLastRender());
}

bool IsDrawnByRanks(vtkPVRenderView* view, vtkInformation* inInfo)
{
  return IsDistributed(view, inInfo->Has(vtkPVRenderView::USE_LOD()) != 0);
}
}
