// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/MeshStyle.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

vtkStandardNewMacro(MeshStyle);

//------------------------------------------------------------------------------
void MeshStyle::OnChar()
{
  // VTK's key 3 switches to red and blue stereo.
  if (this->Interactor->GetKeyCode() != '3')
  {
    this->Superclass::OnChar();
  }
}
