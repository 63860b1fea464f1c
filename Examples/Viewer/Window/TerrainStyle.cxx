// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/TerrainStyle.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(TerrainStyle);

//------------------------------------------------------------------------------
void TerrainStyle::OnChar()
{
  // VTK's key 3 switches to red and blue stereo.
  if (this->Interactor->GetKeyCode() != '3')
  {
    this->Superclass::OnChar();
  }
}

//------------------------------------------------------------------------------
void TerrainStyle::OnLeftButtonDown()
{
  if (this->Interactor->GetShiftKey())
  {
    this->OnMiddleButtonDown();
  }
  else
  {
    this->Superclass::OnLeftButtonDown();
  }
}

//------------------------------------------------------------------------------
void TerrainStyle::OnLeftButtonUp()
{
  this->OnMiddleButtonUp();
  this->Superclass::OnLeftButtonUp();
}

//------------------------------------------------------------------------------
void TerrainStyle::OnMouseWheelForward()
{
  this->DollyBy(1.1);
}

//------------------------------------------------------------------------------
void TerrainStyle::OnMouseWheelBackward()
{
  this->DollyBy(1.0 / 1.1);
}

//------------------------------------------------------------------------------
void TerrainStyle::DollyBy(double factor)
{
  this->FindPokedRenderer(
    this->Interactor->GetEventPosition()[0], this->Interactor->GetEventPosition()[1]);
  if (this->CurrentRenderer)
  {
    this->CurrentRenderer->GetActiveCamera()->Dolly(factor);
    this->CurrentRenderer->ResetCameraClippingRange();
    this->Interactor->Render();
  }
}
