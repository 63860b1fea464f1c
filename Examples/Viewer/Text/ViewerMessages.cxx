// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/ViewerMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <iostream>

namespace
{
using Handler = std::function<void(vtkObject*, void*)>;

void AddHandler(vtkObject* object, unsigned long event, const Handler& handler)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Handler(handler));
  command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Handler*>(data); });
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void* callData)
    { (*static_cast<Handler*>(data))(caller, callData); });
  object->AddObserver(event, command);
}

// VTK's readers have helpers that nobody can observe; the reader itself says what matters.
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);

// "ERROR: In file, line n\nvtkClass (0x...): text\n\n" -> "text", on one line.
std::string GetText(void* callData)
{
  std::string text = static_cast<const char*>(callData);
  const std::size_t address = text.find("): ");
  if (address != std::string::npos)
  {
    text.erase(0, address + 3);
  }
  text.erase(text.find_last_not_of(" \n") + 1);
  // What a file has must not command the terminal.
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}
}

//------------------------------------------------------------------------------
ViewerMessages::ViewerMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkNew<SilentWindow>());
}

//------------------------------------------------------------------------------
void ViewerMessages::Observe(vtkObject* object)
{
  AddHandler(object, vtkCommand::ErrorEvent,
    [this](vtkObject*, void* callData)
    {
      if (this->FirstError.empty())
      {
        this->FirstError = GetText(callData);
      }
    });
  AddHandler(object, vtkCommand::WarningEvent,
    [this](vtkObject*, void* callData) { this->ShowWarning(GetText(callData)); });
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    // The executive only repeats that the algorithm failed.
    AddHandler(algorithm->GetExecutive(), vtkCommand::ErrorEvent, [](vtkObject*, void*) {});
  }
}

//------------------------------------------------------------------------------
void ViewerMessages::ShowWarning(const std::string& text)
{
  if (this->Warnings.insert(text).second)
  {
    this->Progress.Clear();
    std::cerr << "relevo-view: warning: " << text << std::endl;
  }
}

//------------------------------------------------------------------------------
void ViewerMessages::Observe(vtkObject* object, const std::string& work)
{
  this->Observe(object);
  AddHandler(
    object, vtkCommand::StartEvent, [this, work](vtkObject*, void*) { this->Progress.Show(work); });
  AddHandler(object, vtkCommand::ProgressEvent,
    [this, work](vtkObject* caller, void* callData)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      const char* text = algorithm ? algorithm->GetProgressText() : nullptr;
      this->Progress.Show(text ? text : work, *static_cast<double*>(callData));
    });
  AddHandler(object, vtkCommand::EndEvent, [this](vtkObject*, void*) { this->Progress.Clear(); });
}

//------------------------------------------------------------------------------
void ViewerMessages::ThrowErrorsOf(vtkObject* object)
{
  AddHandler(object, vtkCommand::ErrorEvent,
    [](vtkObject*, void* callData) { throw ViewerError(GetText(callData)); });
}

//------------------------------------------------------------------------------
void ViewerMessages::Check()
{
  if (!this->FirstError.empty())
  {
    const ViewerError error(this->FirstError);
    this->FirstError.clear();
    throw error;
  }
}
