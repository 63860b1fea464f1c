// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/Studio.h"

#include "Controls/ControlNumbers.h"
#include "Controls/NearNames.h"
#include "Driving/LayoutFile.h"
#include "Files/ViewerExport.h"
#include "Files/ViewerPicture.h"
#include "Options/UsageError.h"
#include "Options/ViewerArguments.h"
#include "Panels/PatternDrawing.h"
#include "Program/StudioUsage.h"
#include "Scene/SceneProgram.h"
#include "Scene/SceneSession.h"
#include "Text/ViewerText.h"
#include "Window/PixelProbe.h"

#include "vtkCommand.h"
#include "vtkImGuiOverlay.h"
#include "vtkRenderWindow.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <array>
#include <map>

namespace
{
// Priorities: figures are stored before the panel shows them, and its width is used after that.
const float BeforePanel = 1.0f;
const float AfterPanel = -1.0f;

bool IsOn(const std::string& text)
{
  return text == "on" || text == "true" || text == "1";
}

bool IsOff(const std::string& text)
{
  return text == "off" || text == "false" || text == "0";
}
}

//------------------------------------------------------------------------------
Studio::Studio(vtkRenderWindow* window, const OptionValues& values, bool isComplete)
  : Window(window)
  , State(values)
  , Scene(window, values, isComplete)
  , Comparison(window, this->Scene, isComplete)
{
  this->Pattern.Set(this->Controls.GetOwn("pattern-levels"));
  this->Overlay->SetRenderWindow(window);
  this->Overlay->SetCallback([this] { this->Describe(); });
  window->AddObserver(vtkCommand::StartEvent, this, &Studio::OnFrame, BeforePanel);
  window->AddObserver(vtkCommand::StartEvent, this, &Studio::OnPanel, AfterPanel);
  window->AddObserver(vtkCommand::EndEvent, this, &Studio::OnFrameEnd);
  this->UpdateControls();
}

//------------------------------------------------------------------------------
Studio::~Studio() = default;

//------------------------------------------------------------------------------
void Studio::UpdateControls()
{
  this->Controls.SetHasProbe(!this->Probe.GetKeptText().empty());
  this->Controls.Update(this->State, this->Scene.GetContent());
}

//------------------------------------------------------------------------------
void Studio::Fail(const std::string& message)
{
  this->Message = message;
  this->Error = message;
}

//------------------------------------------------------------------------------
void Studio::Tell(const std::string& note)
{
  this->Message.clear();
  this->Note = note;
}

//------------------------------------------------------------------------------
std::string Studio::TakeError()
{
  std::string error;
  error.swap(this->Error);
  return error;
}

//------------------------------------------------------------------------------
void Studio::Set(const std::string& name, const std::optional<std::string>& value, bool isContinued)
{
  const Control* control = this->Controls.Find(name);
  if (control && !ControlList::IsOption(*control))
  {
    const std::string own = value.value_or(control->Default);
    try
    {
      if (name == "pattern-levels")
      {
        this->Pattern.Set(own);
      }
      this->Controls.SetOwn(name, own);
    }
    catch (const ViewerError& error)
    {
      this->Fail(error.what());
    }
    this->UpdateControls();
    return;
  }
  this->Overlay->RequestFrame();
  try
  {
    this->State.Set(name, value, isContinued);
    if (name == "view")
    {
      // The mouse may have moved the camera away from the same value.
      this->Actions.emplace_back("reset-view");
    }
    this->Tell("");
  }
  catch (const UsageError& error)
  {
    this->Fail(error.what());
  }
  this->UpdateControls();
}

//------------------------------------------------------------------------------
void Studio::Press(const std::string& name)
{
  this->Actions.push_back(name);
  this->Overlay->RequestFrame();
}

//------------------------------------------------------------------------------
void Studio::Apply()
{
  while (!this->Actions.empty())
  {
    const std::string action = this->Actions.front();
    this->Actions.erase(this->Actions.begin());
    try
    {
      this->Do(action);
    }
    catch (const std::exception& error) // ViewerError, UsageError
    {
      this->Fail(error.what());
    }
  }
  try
  {
    this->Scene.Apply(this->State.Get());
    if (this->NewCamera)
    {
      SetCamera(this->Scene.Get().GetRenderer(), *this->NewCamera);
    }
  }
  catch (const std::exception& error)
  {
    this->Fail(error.what());
    this->State.Restore(this->Scene.GetValues());
  }
  this->NewCamera.reset();
  this->ApplyComparison();
  this->UpdateControls();
}

//------------------------------------------------------------------------------
void Studio::ApplyComparison()
{
  const auto get = [this](const std::string& name)
  {
    const std::string value = this->Controls.GetOwn(name);
    return value == this->Controls.Find(name)->Default ? "" : value;
  };
  StudioComparison::Request request{ get("compare-method"), get("compare-options"),
    this->Controls.GetOwn("show-difference") == "on",
    ParseNumbers(this->Controls.GetOwn("difference-gain") + ",4").front() };
  try
  {
    this->Comparison.Apply(request);
    return;
  }
  catch (const std::exception& error) // ViewerError, UsageError
  {
    this->Fail(error.what());
  }
  // The last request, or none if the first view does not allow it any more.
  request = this->Comparison.GetShown();
  try
  {
    this->Comparison.Apply(request);
  }
  catch (const std::exception&)
  {
    request.Method.clear();
    request.Options.clear();
    this->Comparison.Apply(request);
  }
  const auto set = [this](const std::string& name, const std::string& value)
  { this->Controls.SetOwn(name, value.empty() ? this->Controls.Find(name)->Default : value); };
  set("compare-method", request.Method);
  set("compare-options", request.Options);
}

//------------------------------------------------------------------------------
void Studio::Do(const std::string& action)
{
  if (action == "undo")
  {
    this->State.Undo();
  }
  else if (action == "redo")
  {
    this->State.Redo();
  }
  else if (action == "reset-view")
  {
    this->Scene.ResetView();
  }
  else if (action == "step-back" || action == "step-forward")
  {
    this->MoveStep(this->Scene.GetContent().Step + (action == "step-back" ? -1 : 1));
  }
  else if (action == "play")
  {
    this->IsPlayed = !this->IsPlayed;
  }
  else if (action == "range-all")
  {
    this->Set("range", "all", false);
  }
  else if (action == "measure")
  {
    this->IsMeasuring = true;
    this->RulerStart.reset();
    this->Tell("Click on both ends of the ruler.");
  }
  else if (action == "forget-probe")
  {
    this->Probe.Forget();
  }
  else if (action == "keys")
  {
    this->HasKeys = !this->HasKeys;
  }
  else if (!this->SetView(action))
  {
    this->DoOfFiles(action);
  }
}

//------------------------------------------------------------------------------
void Studio::DoOfFiles(const std::string& action)
{
  const auto save = [this](const std::string& name, const std::function<void()>& write)
  {
    write();
    this->Tell("saved " + name);
  };
  const std::string prefix = "save-";
  if (action == "open-session")
  {
    this->OpenSession(this->Controls.GetOwn("session-name"));
    return;
  }
  if (action.compare(0, prefix.size(), prefix) != 0)
  {
    return;
  }
  const std::string name = this->Controls.GetOwn(action.substr(prefix.size()) + "-name");
  if (action == "save-pattern")
  {
    save(name, [&] { this->Pattern.Save(name, this->Scene.GetMessages()); });
  }
  else if (action == "save-table")
  {
    save(name, [&] { this->Pattern.SaveTable(name, this->Scene.GetMessages()); });
  }
  else if (action == "save-new-picture")
  {
    const std::string picture = FindPictureName(this->State.Get().GetInput());
    save(picture, [&] { this->Save(picture); });
  }
  else
  {
    save(name, [&] { this->Save(name); });
  }
}

//------------------------------------------------------------------------------
bool Studio::SetView(const std::string& name)
{
  const std::string prefix = "view-";
  const bool isView =
    name.compare(0, prefix.size(), prefix) == 0 && FindPlanView(name.substr(prefix.size()));
  if (isView)
  {
    this->Set("view", name.substr(prefix.size()), false);
  }
  return isView;
}

//------------------------------------------------------------------------------
void Studio::MoveStep(int step)
{
  const std::vector<double>& times = this->Scene.GetContent().Times;
  const int number = static_cast<int>(times.size());
  if (number > 0)
  {
    this->Set("time", WriteNumbers({ times[std::clamp(step, 0, number - 1)] }), false);
  }
}

//------------------------------------------------------------------------------
void Studio::ShowNextStep()
{
  if (!this->IsPlayed)
  {
    return;
  }
  const int number = static_cast<int>(this->Scene.GetContent().Times.size());
  int next = this->Scene.GetContent().Step + 1;
  if (next >= number)
  {
    this->IsPlayed = this->Controls.GetOwn("loop") == "on" && number > 1;
    next = 0;
  }
  if (this->IsPlayed)
  {
    this->MoveStep(next);
  }
}

//------------------------------------------------------------------------------
void Studio::FailUnknown(const std::string& name)
{
  std::vector<std::string> names;
  for (const Control& control : this->Controls.Get())
  {
    names.push_back(control.Name);
  }
  for (const LayoutEntry& entry : this->Panel.GetLayout().Get())
  {
    if (!this->Controls.Find(entry.Name))
    {
      names.push_back(entry.Name);
    }
  }
  const std::vector<std::string> near = FindNearNames(name, names);
  throw ViewerError(
    "unknown control '" + name + "'" + (near.empty() ? "" : "; similar: " + JoinWords(near)));
}

//------------------------------------------------------------------------------
const LayoutEntry& Studio::FindEntry(const std::string& name)
{
  const LayoutEntry* entry = this->Panel.GetLayout().Find(name);
  if (!entry)
  {
    this->FailUnknown(name);
  }
  return *entry;
}

//------------------------------------------------------------------------------
void Studio::ResolveClip(std::string& name, std::string& value)
{
  const Control* control = this->Controls.Find("clip");
  std::vector<double> plane = ParseNumbers(control->Value.value_or(""));
  const int direction = FindPlaneDirection(plane);
  if (name == "clip-direction")
  {
    const auto* chosen = std::find(PlaneDirections.begin(), PlaneDirections.end(), value);
    if (chosen == PlaneDirections.end() && value != "default")
    {
      throw ViewerError("'" + name + "' needs " +
        JoinWords({ PlaneDirections.begin(), PlaneDirections.end() }) + ", not '" + value + "'");
    }
    const bool isNone = value == "default" || value == PlaneDirections[0];
    value = isNone ? "default"
                   : WriteNumbers(TurnPlane(plane,
                       this->Scene.GetContent().Bounds.value_or(std::array<double, 6>{}),
                       static_cast<int>(chosen - PlaneDirections.begin())));
  }
  else if (value != "default")
  {
    const std::vector<double> numbers = ParseNumbers(value);
    if (direction <= 0)
    {
      throw ViewerError("'" + name + "' is not available: set clip-direction first");
    }
    if (numbers.size() != 1)
    {
      throw ViewerError("'" + name + "' needs a number, not '" + value + "'");
    }
    plane[(direction - 1) / 2] = numbers[0];
    value = WriteNumbers(plane);
  }
  name = "clip";
}

//------------------------------------------------------------------------------
void Studio::ResolvePart(std::string& name, std::string& value)
{
  if (name == "clip-direction" || name == "clip-position")
  {
    this->ResolveClip(name, value);
    return;
  }
  const std::size_t dot = name.find('.');
  const Control* control = this->Controls.Find(name.substr(0, dot));
  if (dot == std::string::npos || !control || control->Start.size() < 2)
  {
    return;
  }
  std::vector<double> numbers = !control->Current.empty() ? control->Current
    : control->Value                                      ? ParseNumbers(*control->Value)
                                                          : control->Start;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (name.substr(dot + 1) == std::to_string(i))
    {
      const std::vector<double> given = ParseNumbers(value);
      if (value != "default" && given.size() != 1)
      {
        throw ViewerError("'" + name + "' needs a number, not '" + value + "'");
      }
      if (!given.empty())
      {
        numbers[i] = given[0];
        value = WriteNumbers(numbers);
      }
      name = control->Name;
      return;
    }
  }
}

//------------------------------------------------------------------------------
void Studio::SetValue(const std::string& givenName, const std::string& givenValue)
{
  std::string name = givenName;
  std::string value = givenValue;
  this->ResolvePart(name, value);
  const Control* control = this->Controls.Find(name);
  if (!control)
  {
    const LayoutEntry& entry = this->FindEntry(name);
    const bool isClicked = entry.Kind == "button" || entry.Kind == "group" || entry.Kind == "item";
    throw ViewerError(isClicked
        ? "'" + name + "' is a " + entry.Kind + "; write: click " + name
        : "'" + name + "' is a part of 'transfer'; write: set transfer NODES");
  }
  if (control->Kind == ControlKind::Button)
  {
    throw ViewerError("'" + name + "' is a button; write: click " + name);
  }
  const bool isDefault = value == "default";
  if (!control->IsEnabled && !isDefault)
  {
    throw ViewerError("'" + name + "' is not available: " + control->Reason);
  }
  std::optional<std::string> set = value;
  if (isDefault)
  {
    set.reset();
  }
  else if (control->Kind == ControlKind::Flag)
  {
    if (!IsOn(value) && !IsOff(value))
    {
      throw ViewerError("'" + name + "' needs on or off, not '" + value + "'");
    }
    set = IsOn(value) ? std::optional<std::string>("on") : std::nullopt;
  }
  this->Set(name, set, false);
}

//------------------------------------------------------------------------------
void Studio::RunWithoutPanel(const std::function<void()>& work)
{
  const int width = this->Scene.GetPanelWidth();
  this->Comparison.SetPanelWidth(0);
  try
  {
    work();
  }
  catch (...)
  {
    this->Comparison.SetPanelWidth(width);
    throw;
  }
  this->Comparison.SetPanelWidth(width);
}

//------------------------------------------------------------------------------
void Studio::Save(const std::string& fileName)
{
  const bool hasPanel = this->Controls.GetOwn("panels-in-pictures") == "on" &&
    vtksys::SystemTools::StringEndsWith(vtksys::SystemTools::LowerCase(fileName), ".png");
  if (hasPanel)
  {
    this->SaveScene(fileName);
  }
  else
  {
    this->RunWithoutPanel([&] { this->SaveScene(fileName); });
  }
}

//------------------------------------------------------------------------------
void Studio::SaveScene(const std::string& fileName)
{
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  const std::vector<std::string> meshes = GetExportExtensions();
  const bool isProgram = extension == ".py" || fileName.back() == '/';
  if (extension == ".png")
  {
    this->DrawPicture(this->Controls.GetOwn("panels-in-pictures") == "on",
      [&] { WritePicture(this->Window, fileName, this->Scene.GetMessages()); });
  }
  else if (isProgram || extension == ".json")
  {
    // These describe the frame of a picture of the first view.
    this->Comparison.SetHidden(true);
    try
    {
      this->DrawPicture(false, [&] { this->SaveProgram(fileName); });
    }
    catch (...)
    {
      this->Comparison.SetHidden(false);
      throw;
    }
    this->Comparison.SetHidden(false);
  }
  else if (std::find(meshes.begin(), meshes.end(), extension) != meshes.end())
  {
    this->Scene.Get().Export(fileName);
    if (!vtksys::SystemTools::FileExists(fileName))
    {
      throw ViewerError("this scene has no mesh to save");
    }
  }
  else
  {
    throw ViewerError("cannot save " + fileName +
      ": its name must end with .png, .json for a session, .py for a script, / for the folder of a "
      "C++ source, or as a mesh with " +
      JoinWords(meshes));
  }
}

//------------------------------------------------------------------------------
void Studio::SaveProgram(const std::string& fileName)
{
  ViewerScene& scene = this->Scene.Get();
  ViewerOptions options = this->Scene.GetValues().Parse();
  const int* window = this->Window->GetActualSize();
  const std::array<int, 2> size = { { window[0], window[1] } };
  options.Given["--size"] = std::to_string(size[0]) + "x" + std::to_string(size[1]);
  if (fileName.back() == '/')
  {
    SaveSource(scene, options, size, fileName.substr(0, fileName.size() - 1));
  }
  else if (vtksys::SystemTools::LowerCase(
             vtksys::SystemTools::GetFilenameLastExtension(fileName)) == ".py")
  {
    SaveScript(scene, options, size, fileName);
  }
  else
  {
    options.SaveSession = fileName;
    SaveSceneSession(scene, options);
  }
}

//------------------------------------------------------------------------------
void Studio::OpenSession(const std::string& fileName)
{
  const ViewerSession session = ReadSession(fileName);
  std::vector<std::string> arguments;
  for (const auto& option : session.Options)
  {
    if (option.first != "--size") // the window stays
    {
      arguments.push_back(option.first + (option.second ? "=" + *option.second : ""));
    }
  }
  arguments.insert(arguments.end(), { "--", session.Input });
  const OptionValues values(arguments);
  CheckForStudio(values);
  this->State.Replace(values);
  this->NewCamera = session.Camera;
  this->Probe.Forget();
  this->Tell("opened " + fileName);
}

//------------------------------------------------------------------------------
void Studio::Point(const std::optional<WindowPixel>& pixel)
{
  this->Pointer = pixel;
  const auto start = std::chrono::steady_clock::now();
  this->Probe.Point(this->Scene.Get(), pixel);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  this->ProbeTime = time.count();
}

//------------------------------------------------------------------------------
void Studio::ClickScene(const WindowPixel& pixel)
{
  this->IsMeasuring ? this->Measure(pixel) : this->KeepValues(pixel);
}

//------------------------------------------------------------------------------
void Studio::KeepValues(const WindowPixel& pixel)
{
  if (this->Probe.Keep(this->Scene.Get(), pixel))
  {
    this->Tell("");
    this->UpdateControls();
  }
}

//------------------------------------------------------------------------------
void Studio::Measure(const WindowPixel& pixel)
{
  const auto point = FindVisiblePoint(this->Scene.Get(), pixel.data());
  if (!point)
  {
    this->Tell("There is nothing to measure here.");
  }
  else if (!this->RulerStart)
  {
    this->RulerStart = *point;
    this->Tell("The ruler starts here. Choose its other end.");
  }
  else
  {
    std::vector<double> ends(this->RulerStart->begin(), this->RulerStart->end());
    ends.insert(ends.end(), point->begin(), point->end());
    this->RulerStart.reset();
    this->IsMeasuring = false;
    this->Set("ruler", JoinNumbers(ends), false);
  }
}

//------------------------------------------------------------------------------
bool Studio::HandleKey(char key)
{
  static const std::map<char, std::string> actions = { { '<', "step-back" },
    { '>', "step-forward" }, { 'r', "reset-view" }, { 'h', "keys" }, { 'i', "save-new-picture" } };
  static const std::map<char, std::string> views = { { '1', "view-front" }, { '2', "view-back" },
    { '3', "view-left" }, { '4', "view-right" }, { '5', "view-top" }, { '6', "view-bottom" } };
  const auto action = actions.find(key);
  const auto view = views.find(key);
  if (action != actions.end())
  {
    this->Press(action->second);
  }
  else if (view != views.end())
  {
    this->Press(view->second);
  }
  else if (key == 'w' || key == 's')
  {
    this->Toggle("wireframe", key == 'w');
  }
  else if (key == 'c' || key == 'd')
  {
    if (this->Pointer)
    {
      const bool measures = key == 'd' && this->Controls.Find("ruler")->IsEnabled;
      measures ? this->Measure(*this->Pointer) : this->KeepValues(*this->Pointer);
    }
  }
  else
  {
    return this->ChangeByKey(key);
  }
  return true;
}

//------------------------------------------------------------------------------
void Studio::Toggle(const std::string& name, bool isOn)
{
  if (this->Controls.Find(name)->IsEnabled)
  {
    this->Set(name, isOn ? std::optional<std::string>("on") : std::nullopt, false);
  }
}

//------------------------------------------------------------------------------
bool Studio::ChangeByKey(char key)
{
  // The scene has changed already; the controls must follow.
  const std::string change = this->Scene.Get().ChangeByKey(key);
  const std::size_t space = change.find(' ');
  if (change.compare(0, 2, "--") == 0 && space != std::string::npos)
  {
    this->Set(change.substr(2, space - 2), change.substr(space + 1), true);
  }
  else if (!change.empty())
  {
    this->Tell(change);
    this->Overlay->RequestFrame();
  }
  return !change.empty();
}

//------------------------------------------------------------------------------
void Studio::DrawPicture(bool hasPanels, const std::function<void()>& use)
{
  this->Overlay->SetVisibility(hasPanels);
  // The frame of the picture must not appear on the screen.
  const vtkTypeBool swaps = this->Window->GetSwapBuffers();
  this->Window->SetSwapBuffers(0);
  const auto restore = [&]
  {
    this->Overlay->VisibilityOn();
    this->Window->SetSwapBuffers(swaps);
  };
  try
  {
    this->Window->Render();
    use();
  }
  catch (...)
  {
    restore();
    throw;
  }
  restore();
}

//------------------------------------------------------------------------------
void Studio::Draw()
{
  this->Window->Render();
  try
  {
    this->Comparison.CheckFrame();
  }
  catch (const ViewerError& error)
  {
    this->Fail(error.what());
  }
}

//------------------------------------------------------------------------------
void Studio::OnFrame()
{
  this->ShownFigures = this->Figures;
  this->Start = std::chrono::steady_clock::now();
}

//------------------------------------------------------------------------------
void Studio::OnPanel()
{
  if (this->Overlay->GetVisibility())
  {
    this->Comparison.SetPanelWidth(this->Panel.GetWidth());
  }
}

//------------------------------------------------------------------------------
void Studio::OnFrameEnd()
{
  this->Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time =
    std::chrono::steady_clock::now() - this->Start;
  ++this->Frames;
  this->Figures = this->Scene.GetFigures();
  this->Figures.insert(this->Figures.begin(),
    { { "frames", static_cast<double>(this->Frames) },
      { "panel-frames", static_cast<double>(this->Overlay->GetNumberOfRepeatedFrames()) },
      { "frame-ms", time.count() }, { "probe-ms", this->ProbeTime } });
  const SceneFigures compared = this->Comparison.MeasureFrame();
  this->Figures.insert(this->Figures.end(), compared.begin(), compared.end());
  // Patterns that the graphics card has chosen are read back only for the histogram and the layout.
  const bool hasLayout = !this->LayoutFile.empty() && this->Overlay->GetVisibility();
  const bool hadPatterns = !this->Patterns.empty();
  this->Patterns = this->Panel.ShowsHistogram() || hasLayout ? this->Scene.Get().GetPatternCounts()
                                                             : std::vector<PatternCount>();
  if (this->Panel.ShowsHistogram() && !hadPatterns && !this->Patterns.empty())
  {
    this->Overlay->RequestFrame(); // the histogram has just been opened
  }
  if (hasLayout)
  {
    try
    {
      WriteLayout(this->LayoutFile, this->Panel.GetLayout(), this->ListFigures());
    }
    catch (const ViewerError& error)
    {
      this->LayoutFile.clear(); // reported once
      this->Fail(error.what());
    }
  }
}

//------------------------------------------------------------------------------
SceneFigures Studio::ListFigures() const
{
  SceneFigures figures = this->Figures;
  const SceneFigures counts = ListCounts(this->Patterns);
  figures.insert(figures.end(), counts.begin(), counts.end());
  figures.insert(figures.end(),
    { { "pattern-lambda", static_cast<double>(this->Pattern.GetLambda()) },
      { "pattern-triangles", static_cast<double>(this->Pattern.GetTriangles().size()) },
      { "pattern-angle", this->Pattern.GetSmallestAngle() } });
  return figures;
}

//------------------------------------------------------------------------------
SceneTexts Studio::FindTexts()
{
  const int width = this->Window->GetActualSize()[0] - this->Panel.GetWidth();
  return { this->Probe.GetText(), this->Probe.FindKeptPixel(this->Scene.Get()),
    this->HasKeys ? GetStudioKeys() : "", width };
}

//------------------------------------------------------------------------------
void Studio::Describe()
{
  this->Panel.Draw(
    { this->Controls.Get(), this->Scene.GetContent(), this->ShownFigures, this->Patterns,
      this->Pattern, this->Message, this->Note, this->FindTexts(), this->Probe.GetKeptText() },
    *this);
}
