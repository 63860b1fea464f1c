// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/ScriptRunner.h"

#include "Program/Studio.h"
#include "Scene/PassiveObserver.h"
#include "Text/StandardError.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkCommand.h"
#include "vtkImGuiOverlay.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <map>
#include <set>

namespace
{
const int Steps = 8; // of a drag
const int MaximumFrames = 1000;

// Keys that are not characters, as X names them.
const std::set<std::string> KeyNames = { "BackSpace", "Delete", "Down", "End", "Escape", "Home",
  "Insert", "Left", "Next", "Prior", "Return", "Right", "Tab", "Up", "space" };

bool IsKey(const std::string& symbol)
{
  return symbol.size() == 1 || KeyNames.count(symbol) > 0;
}
}

//------------------------------------------------------------------------------
ScriptRunner::ScriptRunner(Studio& studio, vtkRenderWindowInteractor* interactor)
  : Driven(studio)
  , Interactor(interactor)
  , Pointer(studio, interactor, false)
{
  interactor->EnableRenderOff();
  interactor->Initialize(); // the first frame would do it, and request a second one
  AddPassiveObserver(
    interactor, vtkCommand::RenderEvent, [this](void*) { this->IsFrameRequested = true; });
}

//------------------------------------------------------------------------------
int ScriptRunner::Run(const std::string& fileName)
{
  const std::vector<ScriptLine> lines = ReadScript(fileName);
  int errors = 0;
  this->IsFrameRequested = true;
  this->Flush();
  for (const ScriptLine& line : lines)
  {
    if (line.Command == "quit")
    {
      break;
    }
    std::string error;
    try
    {
      this->RunLine(line);
      error = this->Driven.TakeError();
    }
    catch (const std::exception& thrown) // ViewerError, UsageError
    {
      error = thrown.what();
    }
    if (!error.empty())
    {
      ++errors;
      WriteMessage("error", fileName + ", line " + std::to_string(line.Number) + ": " + error);
    }
  }
  return errors;
}

//------------------------------------------------------------------------------
void ScriptRunner::RunLine(const ScriptLine& line)
{
  if (line.Command == "set")
  {
    this->Driven.SetValue(line.Name, line.Value);
    this->IsFrameRequested = true;
    this->Flush();
  }
  else if (line.Command == "click")
  {
    this->Click(line.Name);
  }
  else if (line.Command == "drag")
  {
    this->Drag(line.Numbers);
  }
  else if (line.Command == "key")
  {
    this->SendKey(line.Name);
  }
  else if (line.Command == "wait")
  {
    this->Wait();
  }
  else if (line.Command == "save")
  {
    this->Driven.Save(line.Name);
  }
  if (line.Command == "click" || line.Command == "drag" || line.Command == "key")
  {
    this->Pointer.Update();
    this->Flush();
  }
}

//------------------------------------------------------------------------------
void ScriptRunner::Flush()
{
  for (int frame = 0; this->IsFrameRequested && frame < MaximumFrames; ++frame)
  {
    this->IsFrameRequested = false;
    this->Driven.Apply();
    this->Driven.Draw();
  }
}

//------------------------------------------------------------------------------
void ScriptRunner::Wait()
{
  this->IsFrameRequested = true;
  this->Flush();
  for (int frame = 0; frame < MaximumFrames && this->Driven.IsPlaying(); ++frame)
  {
    this->Driven.ShowNextStep();
    this->IsFrameRequested = true;
    this->Flush();
  }
  for (int frame = 0; frame < MaximumFrames && this->Driven.GetScene().Get().GetFrameDelay();
       ++frame)
  {
    this->IsFrameRequested = true;
    this->Flush();
  }
}

//------------------------------------------------------------------------------
void ScriptRunner::Send(unsigned long event, double x, double y)
{
  const int height = this->Interactor->GetRenderWindow()->GetActualSize()[1];
  this->Interactor->SetEventInformation(
    static_cast<int>(x), height - 1 - static_cast<int>(y), 0, 0);
  this->Interactor->InvokeEvent(event);
}

//------------------------------------------------------------------------------
void ScriptRunner::Click(const std::string& name)
{
  // Opens the group, then scrolls to the control.
  for (int pass = 0; pass < 2; ++pass)
  {
    this->Driven.GetPanel().Reveal(name);
    this->Driven.GetOverlay()->Update();
  }
  this->Driven.GetOverlay()->Update();
  const LayoutEntry entry = this->Driven.FindEntry(name);
  if (!entry.IsVisible)
  {
    throw ViewerError("'" + name + "' is not visible");
  }
  if (!entry.IsEnabled)
  {
    throw ViewerError("'" + name + "' is not available: " + entry.Reason);
  }
  const double x = entry.Rectangle[0] + 0.5 * entry.Rectangle[2];
  const double y = entry.Rectangle[1] + 0.5 * entry.Rectangle[3];
  // The panel needs no frames between these events.
  this->Send(vtkCommand::MouseMoveEvent, x, y);
  this->Send(vtkCommand::LeftButtonPressEvent, x, y);
  this->Send(vtkCommand::LeftButtonReleaseEvent, x, y);
  this->IsFrameRequested = true;
  this->Flush();
}

//------------------------------------------------------------------------------
void ScriptRunner::Drag(const std::vector<double>& numbers)
{
  this->Send(vtkCommand::MouseMoveEvent, numbers[0], numbers[1]);
  this->Send(vtkCommand::LeftButtonPressEvent, numbers[0], numbers[1]);
  this->Flush();
  for (int step = 1; step <= Steps; ++step)
  {
    const double share = static_cast<double>(step) / Steps;
    this->Send(vtkCommand::MouseMoveEvent, numbers[0] + share * (numbers[2] - numbers[0]),
      numbers[1] + share * (numbers[3] - numbers[1]));
    this->Flush();
  }
  this->Send(vtkCommand::LeftButtonReleaseEvent, numbers[2], numbers[3]);
  this->Flush();
}

//------------------------------------------------------------------------------
void ScriptRunner::SendKey(const std::string& name)
{
  static const std::map<std::string, char> codes = { { "Tab", '\t' }, { "Return", '\r' },
    { "Escape", '\x1b' }, { "space", ' ' }, { "BackSpace", '\b' } };
  std::string symbol = name;
  bool hasControl = false;
  bool hasShift = false;
  for (std::size_t plus = symbol.find('+'); plus != std::string::npos && symbol.size() > 1;
       plus = symbol.find('+'))
  {
    const std::string modifier = symbol.substr(0, plus);
    if (modifier != "ctrl" && modifier != "shift")
    {
      throw ViewerError("unknown key '" + name + "'");
    }
    hasControl = hasControl || modifier == "ctrl";
    hasShift = hasShift || modifier == "shift";
    symbol = symbol.substr(plus + 1);
  }
  const auto code = codes.find(symbol);
  if (!IsKey(symbol))
  {
    throw ViewerError("unknown key '" + name + "'; keys are characters and " +
      JoinWords({ KeyNames.begin(), KeyNames.end() }));
  }
  const char character = symbol.size() == 1 ? symbol[0] : code == codes.end() ? '\0' : code->second;
  this->Interactor->SetKeyEventInformation(hasControl, hasShift, character, 1, symbol.c_str());
  for (const unsigned long event :
    { vtkCommand::KeyPressEvent, vtkCommand::CharEvent, vtkCommand::KeyReleaseEvent })
  {
    this->Interactor->InvokeEvent(event);
  }
  this->Flush();
}
