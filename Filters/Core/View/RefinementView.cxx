// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RefinementView.h"

#include "Changes/Dependencies.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <algorithm>

namespace relevo
{
void RefinementView::AddTo(Dependencies& dependencies, bool addsPlacement, bool addsCamera) const
{
  for (int i = 0; addsPlacement && this->ModelToWorld && i < 16; ++i)
  {
    dependencies.Add(this->ModelToWorld->GetData()[i]);
  }
  if (!addsCamera)
  {
    return;
  }
  for (int length : this->ViewportSize)
  {
    dependencies.Add(length);
  }
  vtkCamera* camera = this->Camera;
  const double aspect =
    static_cast<double>(this->ViewportSize[0]) / std::max(this->ViewportSize[1], 1);
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  for (int i = 0; i < 16; ++i)
  {
    dependencies.Add(matrix->GetData()[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    dependencies.Add(camera->GetPosition()[i]);
    dependencies.Add(camera->GetFocalPoint()[i]);
    dependencies.Add(camera->GetViewUp()[i]);
  }
  dependencies.Add(camera->GetParallelProjection());
}
}
