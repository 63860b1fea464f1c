// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerReadout.h"

#include "Scene/PassiveObserver.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerText.h"
#include "Window/PixelProbe.h"
#include "Window/ViewerFrames.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <iostream>

namespace
{
const int ReadoutMargin = 10;           // pixels
const unsigned long ReadoutDelay = 100; // milliseconds
const double FastFrame = 0.05;          // seconds
}

//------------------------------------------------------------------------------
ViewerReadout::ViewerReadout(
  vtkRenderWindowInteractor* interactor, ViewerFrames& frames, ViewerScene& scene)
  : Interactor(interactor)
  , Frames(frames)
  , Scene(scene)
  , Text(MakeText())
{
  this->Text->SetPosition(ReadoutMargin, ReadoutMargin);
  vtkRenderWindow* window = interactor->GetRenderWindow();
  window->SetNumberOfLayers(2);
  this->Layer->SetLayer(1);
  this->Layer->InteractiveOff();
  this->Layer->PreserveDepthBufferOn();
  this->Layer->AddViewProp(this->Text);
  window->AddRenderer(this->Layer);
  for (unsigned long event : { vtkCommand::MouseMoveEvent, vtkCommand::LeaveEvent })
  {
    AddPassiveObserver(interactor, event, [this](void*) { this->OnChange(); });
  }
  AddPassiveObserver(interactor, vtkCommand::TimerEvent,
    [this](void* data) { this->OnTimer(*static_cast<int*>(data)); });
  scene.GetRenderer()->AddObserver(vtkCommand::EndEvent, this, &ViewerReadout::OnFrame);
  interactor->AddObserver(vtkCommand::KeyPressEvent, this, &ViewerReadout::OnKey);
}

//------------------------------------------------------------------------------
ViewerReadout::~ViewerReadout() = default;

//------------------------------------------------------------------------------
vtkProp* ViewerReadout::GetText() const
{
  return this->Text;
}

//------------------------------------------------------------------------------
void ViewerReadout::OnChange()
{
  const bool isFast = this->Scene.GetRenderer()->GetLastRenderTimeInSeconds() < FastFrame;
  if (this->Timer > 0 && isFast)
  {
    return;
  }
  if (this->Timer > 0)
  {
    this->Interactor->DestroyTimer(this->Timer);
  }
  this->Timer = this->Interactor->CreateOneShotTimer(ReadoutDelay);
}

//------------------------------------------------------------------------------
void ViewerReadout::OnFrame(vtkObject*, unsigned long, void*)
{
  // While the view moves, each frame shows its own values. Those of meshes take longer to find.
  if (this->Scene.IsTerrain() && this->Text->GetVisibility())
  {
    const std::string text = this->Describe();
    this->Text->SetInput(text.c_str());
    this->Text->SetVisibility(!text.empty());
  }
  this->OnChange();
}

//------------------------------------------------------------------------------
void ViewerReadout::OnTimer(int timer)
{
  if (timer != this->Timer)
  {
    return;
  }
  this->Timer = 0;
  if (this->Frames.IsPending())
  {
    return; // The next frame starts the timer again.
  }
  const std::string text = this->Describe();
  const bool isShown = !text.empty();
  if (isShown != (this->Text->GetVisibility() != 0) || (isShown && text != this->Text->GetInput()))
  {
    this->Text->SetInput(text.c_str());
    this->Text->SetVisibility(isShown);
    this->Interactor->Render();
  }
}

//------------------------------------------------------------------------------
void ViewerReadout::OnKey(vtkObject*, unsigned long, void*)
{
  if (this->Interactor->GetKeyCode() == 'c')
  {
    this->Frames.Flush();
    std::string text = DescribeVisible(this->Scene, this->Interactor->GetEventPosition());
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::cout << "here: " << (text.empty() ? "nothing" : text) << std::endl;
  }
}

//------------------------------------------------------------------------------
std::string ViewerReadout::Describe()
{
  return DescribeSurface(this->Scene, this->Interactor->GetEventPosition());
}
