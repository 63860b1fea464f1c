// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ReducedProjection.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace relevo
{
ReducedProjection::ReducedProjection(vtkPVRenderView* view)
{
  vtkRenderer* ren = view->GetRenderer();
  const bool isInteractive = ren->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0;
  const int factor = isInteractive ? view->GetInteractiveRenderImageReductionFactor()
                                   : view->GetStillRenderImageReductionFactor();
  if (factor <= 1)
  {
    return;
  }
  this->Camera = ren->GetActiveCamera();
  this->Explicit = this->Camera->GetExplicitProjectionTransformMatrix();
  this->UsesExplicit = this->Camera->GetUseExplicitProjectionTransformMatrix();
  vtkNew<vtkMatrix4x4> toCorner;
  for (int i = 0; i < 2; ++i)
  {
    const int size = std::max(1, ren->GetRenderWindow()->GetActualSize()[i]);
    const double share = static_cast<double>(std::max(1, size / factor)) / size;
    toCorner->SetElement(i, i, share);
    toCorner->SetElement(i, 3, share - 1.0);
  }
  vtkNew<vtkMatrix4x4> projection;
  vtkMatrix4x4::Multiply4x4(toCorner,
    this->Camera->GetProjectionTransformMatrix(ren->GetTiledAspectRatio(), -1, 1), projection);
  this->Camera->SetExplicitProjectionTransformMatrix(projection);
  this->Camera->UseExplicitProjectionTransformMatrixOn();
}

ReducedProjection::~ReducedProjection()
{
  if (this->Camera)
  {
    this->Camera->SetUseExplicitProjectionTransformMatrix(this->UsesExplicit);
    this->Camera->SetExplicitProjectionTransformMatrix(this->Explicit);
  }
}
}
