// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerPatches.h"

#include "Options/ViewerOptions.h"

#include "vtkAdaptivePatchMapper.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPolyData.h"

//------------------------------------------------------------------------------
bool HasPatches(vtkPolyData* mesh)
{
  return mesh->GetCellData()->HasArray("PatchIds") != 0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDepthTagMetric> MakeErrorMetric(const ViewerOptions& options)
{
  vtkNew<vtkPatchErrorDepthTagMetric> metric;
  metric->SetScreenSpaceError(options.Error.value_or(metric->GetScreenSpaceError()));
  return metric.Get();
}

//------------------------------------------------------------------------------
void ShowIsolines(
  const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper, const double range[2])
{
  auto* patches = vtkAdaptivePatchMapper::SafeDownCast(mapper);
  if (patches && options.Isolines > 0 && range[1] > range[0])
  {
    patches->SetIsolineSpacing((range[1] - range[0]) / options.Isolines);
  }
}

//------------------------------------------------------------------------------
void ShowPatchEdges(const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper)
{
  if (auto* patches = vtkAdaptivePatchMapper::SafeDownCast(mapper))
  {
    patches->SetPatchEdges(options.PatchEdges);
  }
}
