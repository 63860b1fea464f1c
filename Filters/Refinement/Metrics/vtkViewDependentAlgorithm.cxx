// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewDependentAlgorithm.h"

#include "Checks/SettingChecks.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

vtkViewDependentAlgorithm::vtkViewDependentAlgorithm() = default;
vtkViewDependentAlgorithm::~vtkViewDependentAlgorithm() = default;

vtkCxxSetSmartPointerMacro(vtkViewDependentAlgorithm, Camera, vtkCamera);

vtkCamera* vtkViewDependentAlgorithm::GetCamera()
{
  return this->Camera;
}

vtkCxxSetSmartPointerMacro(vtkViewDependentAlgorithm, ModelToWorld, vtkMatrix4x4);

vtkMatrix4x4* vtkViewDependentAlgorithm::GetModelToWorld()
{
  return this->ModelToWorld;
}

void vtkViewDependentAlgorithm::SetViewportSize(int width, int height)
{
  relevo::SetPixelSize(this, "ViewportSize", this->ViewportSize, width, height);
}

relevo::RefinementView vtkViewDependentAlgorithm::MakeView() const
{
  return { this->Camera, this->ModelToWorld, { this->ViewportSize[0], this->ViewportSize[1] } };
}

void vtkViewDependentAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ModelToWorld: " << this->ModelToWorld.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n";
}
