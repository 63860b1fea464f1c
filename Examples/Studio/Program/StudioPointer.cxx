// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/StudioPointer.h"

#include "Program/Studio.h"
#include "Scene/PassiveObserver.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImGuiOverlay.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <cstdlib>

namespace
{
const float KeyPriority = 50.0f; // after panels and before interactor styles
const unsigned long Delay = 50;  // milliseconds
const int LargestClick = 2;      // pixels that the mouse may move
}

//------------------------------------------------------------------------------
StudioPointer::StudioPointer(Studio& studio, vtkRenderWindowInteractor* interactor, bool hasTimers)
  : Driven(studio)
  , Interactor(interactor)
  , HasTimers(hasTimers)
{
  AddPassiveObserver(interactor, vtkCommand::MouseMoveEvent, [this](void*) { this->OnMove(true); });
  AddPassiveObserver(interactor, vtkCommand::LeaveEvent, [this](void*) { this->OnMove(false); });
  AddPassiveObserver(
    interactor, vtkCommand::LeftButtonPressEvent, [this](void*) { this->OnPress(); });
  AddPassiveObserver(
    interactor, vtkCommand::LeftButtonReleaseEvent, [this](void*) { this->OnRelease(); });
  AddPassiveObserver(interactor, vtkCommand::TimerEvent,
    [this](void* data) { this->OnTimer(*static_cast<int*>(data)); });
  AddPassiveObserver(
    interactor->GetRenderWindow(), vtkCommand::EndEvent, [this](void*) { this->OnFrame(); });
  this->KeyCommand->SetClientData(this);
  this->KeyCommand->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      auto* pointer = static_cast<StudioPointer*>(self);
      pointer->KeyCommand->SetAbortFlag(pointer->OnCharacter());
    });
  interactor->AddObserver(vtkCommand::CharEvent, this->KeyCommand, KeyPriority);
}

//------------------------------------------------------------------------------
StudioPointer::~StudioPointer()
{
  this->Interactor->RemoveObserver(this->KeyCommand);
}

//------------------------------------------------------------------------------
std::optional<WindowPixel> StudioPointer::FindPixel() const
{
  const int* pixel = this->Interactor->GetEventPosition();
  // A second view has no values.
  const bool isOverScene = this->IsInside && !this->Driven.GetOverlay()->GetCapturesMouse() &&
    pixel[0] < this->Driven.GetScene().GetColumnSize()[0];
  return isOverScene ? std::optional<WindowPixel>({ pixel[0], pixel[1] }) : std::nullopt;
}

//------------------------------------------------------------------------------
void StudioPointer::Update()
{
  this->Driven.Point(this->FindPixel());
  this->Driven.GetOverlay()->Refresh();
}

//------------------------------------------------------------------------------
void StudioPointer::OnMove(bool isInside)
{
  this->IsInside = isInside;
  this->StartTimer();
}

//------------------------------------------------------------------------------
void StudioPointer::OnPress()
{
  this->Pressed = this->FindPixel();
}

//------------------------------------------------------------------------------
void StudioPointer::OnRelease()
{
  const std::optional<WindowPixel> pixel = this->FindPixel();
  if (this->Pressed && pixel && std::abs((*pixel)[0] - (*this->Pressed)[0]) <= LargestClick &&
    std::abs((*pixel)[1] - (*this->Pressed)[1]) <= LargestClick)
  {
    this->Driven.ClickScene(*pixel);
    this->StartTimer();
  }
  this->Pressed.reset();
}

//------------------------------------------------------------------------------
void StudioPointer::OnFrame()
{
  // Frames that only the panels need do not change what is under the mouse.
  const long long repeated = this->Driven.GetOverlay()->GetNumberOfRepeatedFrames();
  if (repeated == this->RepeatedFrames)
  {
    this->StartTimer();
  }
  this->RepeatedFrames = repeated;
}

//------------------------------------------------------------------------------
void StudioPointer::StartTimer()
{
  if (this->HasTimers && this->Timer == 0)
  {
    this->Timer = this->Interactor->CreateOneShotTimer(Delay);
  }
}

//------------------------------------------------------------------------------
void StudioPointer::OnTimer(int timer)
{
  if (timer == this->Timer && timer != 0)
  {
    this->Timer = 0;
    this->Update();
  }
}

//------------------------------------------------------------------------------
bool StudioPointer::OnCharacter()
{
  if (this->Interactor->GetControlKey())
  {
    return false;
  }
  this->Driven.Point(this->FindPixel());
  const bool isHandled = this->Driven.HandleKey(this->Interactor->GetKeyCode());
  if (isHandled)
  {
    this->Interactor->Render();
  }
  return isHandled;
}
