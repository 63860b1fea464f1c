// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/ViewerMessages.h"

#include "Text/PrintableText.h"
#include "Text/ReadingGuard.h"
#include "Text/StandardError.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <cctype>
#include <cstring>
#include <functional>
#include <iostream>
#include <mutex>
#include <utility>

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

// Replaces the library's setters by the viewer's options.
std::string NameOptions(std::string text)
{
  const std::pair<const char*, const char*> phrases[] = {
    { "call SetNoDataValue() with that value", "name that value with --no-data-value" },
    { "lower Scale or Offset", "lower --exaggeration, or for a mesh --scale or --offset" },
    { "heights (NoDataValue)", "heights (--no-data-value)" },
    { ", or raise MaximumDimension if textures may be that large", "" },
    { ", or raise MaximumImagerySize if textures may be that large", "" },
    { "raise its recipe's MaximumLevel, or Tolerance", "its curved cells need more segments" },
    { "Convert it with vtkCellDataToPointData.", "Choose a point array." },
    { "lower Density", "lower --hair" },
    { "or use the map frame", "or leave out --globe" },
    { "raise ImageSampleDistance", "use a smaller --size" },
    { "call SetMethodToRayCasting()", "use --volume-method ray" },
    { "lower TableSize", "use --integration exact" },
    { "are sharper than FeatureAngle, ", "are sharper than --feature-angle, " },
    { "set FeatureAngle to 180", "use --feature-angle 180" },
    { "ShapeTolerance and FieldTolerance", "--shape-tolerance and --field-tolerance" },
  };
  for (const auto& phrase : phrases)
  {
    const std::size_t place = text.find(phrase.first);
    if (place != std::string::npos)
    {
      text.replace(place, std::strlen(phrase.first), phrase.second);
    }
  }
  return text;
}

// "ERROR: In file, line n
// vtkClass (0x...): text
//
// " -> "text"
std::string GetText(const void* callData)
{
  std::string text = static_cast<const char*>(callData);
  const std::size_t address = text.find("): ");
  if (address != std::string::npos)
  {
    text.erase(0, address + 3);
  }
  text.erase(text.find_last_not_of(" \n") + 1);
  // Removes VTK's line ends after sentences. Those within names stay and are escaped.
  for (std::size_t end = text.find('\n', 1); end != std::string::npos;
       end = text.find('\n', end + 1))
  {
    text[end] = std::strchr(".:,;", text[end - 1]) ? ' ' : '\n';
  }
  return NameOptions(text);
}

// Collects messages of objects without observers, such as helpers of VTK's readers.
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);

  std::string TakeFirstError() { return std::exchange(this->FirstError, ""); }

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->FirstError = this->FirstError.empty() ? GetText(text) : this->FirstError;
  }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char* text) override
  {
    // Readers of legacy files only warn about a truncated file.
    if (std::strstr(text, "Error reading"))
    {
      this->DisplayErrorText(text);
    }
  }

private:
  std::mutex Mutex;
  std::string FirstError;
};
vtkStandardNewMacro(SilentWindow);

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
        this->FirstError = this->TakeText(callData);
      }
    });
  AddHandler(object, vtkCommand::WarningEvent,
    [this](vtkObject*, void* callData) { this->Warn(this->TakeText(callData)); });
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    // The executive only repeats that the algorithm failed.
    AddHandler(algorithm->GetExecutive(), vtkCommand::ErrorEvent, [](vtkObject*, void*) {});
  }
}

//------------------------------------------------------------------------------
void ViewerMessages::Name(const std::string& words, const std::string& name)
{
  this->Names.emplace_back(words, name);
}

//------------------------------------------------------------------------------
std::string ViewerMessages::TakeText(const void* callData) const
{
  return this->Rename(GetText(callData));
}

//------------------------------------------------------------------------------
std::string ViewerMessages::Rename(std::string text) const
{
  for (const auto& name : this->Names)
  {
    // The term may start a sentence or be within one.
    const std::string start(1, static_cast<char>(std::toupper(name.first.front())));
    for (const std::string& words : { name.first, start + name.first.substr(1) })
    {
      const std::size_t place = text.find(words);
      if (place != std::string::npos)
      {
        text.replace(place, words.size(), name.second);
      }
    }
  }
  return text;
}

//------------------------------------------------------------------------------
void ViewerMessages::Warn(const std::string& text)
{
  if (this->Warnings.insert(text).second)
  {
    this->WaitingWarnings.push_back(text);
  }
  if (this->ShowsWarnings)
  {
    this->ShowWarnings();
  }
}

//------------------------------------------------------------------------------
void ViewerMessages::ShowWarnings()
{
  this->ShowsWarnings = true;
  for (const std::string& text : this->WaitingWarnings)
  {
    this->Progress.Clear();
    WriteMessage("warning", text);
  }
  this->WaitingWarnings.clear();
}

//------------------------------------------------------------------------------
void ViewerMessages::Tell(const std::string& text)
{
  this->Notes.push_back(text);
}

//------------------------------------------------------------------------------
void ViewerMessages::ShowNotes()
{
  for (const std::string& text : this->Notes)
  {
    std::cout << ToPrintable(text) << std::endl;
  }
  this->Notes.clear();
}

//------------------------------------------------------------------------------
void ViewerMessages::Observe(vtkObject* object, const std::string& work)
{
  this->Observe(object);
  this->ObserveProgress(object, work);
}

//------------------------------------------------------------------------------
void ViewerMessages::ObserveProgress(vtkObject* object, const std::string& work)
{
  AddHandler(object, vtkCommand::StartEvent,
    [this, work](vtkObject*, void*)
    {
      ReadingGuard::RestartProgress();
      this->Progress.Show(work);
    });
  AddHandler(object, vtkCommand::ProgressEvent,
    [this, work](vtkObject* caller, void* callData)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      const char* text = algorithm ? algorithm->GetProgressText() : nullptr;
      const double share = *static_cast<double*>(callData);
      ReadingGuard::ReportProgress(share);
      this->Progress.Show(text ? text : work, share);
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

//------------------------------------------------------------------------------
void ViewerMessages::CheckReading()
{
  this->Check();
  auto* window = SilentWindow::SafeDownCast(vtkOutputWindow::GetInstance());
  const std::string error = window ? window->TakeFirstError() : "";
  if (!error.empty())
  {
    throw ViewerError(error);
  }
}

//------------------------------------------------------------------------------
void ViewerMessages::StartReading()
{
  this->Check();
  if (auto* window = SilentWindow::SafeDownCast(vtkOutputWindow::GetInstance()))
  {
    window->TakeFirstError();
  }
}
