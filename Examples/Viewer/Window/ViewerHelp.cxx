// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerHelp.h"

#include "Options/ViewerUsage.h"
#include "Text/ViewerText.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

//------------------------------------------------------------------------------
ViewerHelp::ViewerHelp(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer)
  : Text(MakeText())
{
  this->Text->SetInput(GetWindowUsage());
  this->Text->GetTextProperty()->SetFontFamilyToCourier(); // aligns the columns
  this->Text->GetTextProperty()->SetBackgroundOpacity(0.9);
  renderer->AddViewProp(this->Text);
  interactor->AddObserver(vtkCommand::KeyPressEvent, this, &ViewerHelp::OnKey);
}

//------------------------------------------------------------------------------
ViewerHelp::~ViewerHelp() = default;

//------------------------------------------------------------------------------
vtkProp* ViewerHelp::GetText() const
{
  return this->Text;
}

//------------------------------------------------------------------------------
void ViewerHelp::OnKey(vtkObject* caller, unsigned long, void*)
{
  auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  if (interactor->GetKeyCode() == 'h')
  {
    vtkRenderer* renderer = interactor->GetRenderWindow()->GetRenderers()->GetFirstRenderer();
    double size[2];
    this->Text->GetSize(renderer, size);
    this->Text->SetPosition(
      0.5 * (renderer->GetSize()[0] - size[0]), 0.5 * (renderer->GetSize()[1] - size[1]));
    this->Text->SetVisibility(!this->Text->GetVisibility());
    interactor->Render();
  }
}
