// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewBounds.h"

#include "vtkAbstractMapper3D.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkProp3D.h"

namespace relevo
{
void MeasureBounds(vtkAbstractMapper3D* mapper, double bounds[6])
{
  const int display = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  mapper->GetBounds(bounds);
  vtkObject::SetGlobalWarningDisplay(display);
}

void GiveBounds(vtkInformation* inInfo, vtkPVDataRepresentation* representation,
  const double bounds[6], vtkProp3D* prop)
{
  vtkNew<vtkMatrix4x4> matrix;
  prop->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, representation, bounds, matrix);
}
}
