// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImGuiOverlay.h"

#include "Checks/SettingChecks.h"
#include "Context/ImGuiInput.h"
#include "Context/ImGuiPanels.h"
#include "Drawing/OverlayProp.h"
#include "Drawing/PanelPainter.h"
#include "Drawing/SceneFrames.h"

#include <imgui.h>

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <set>

namespace
{
const float Priority = 100.0f; // before interactor styles and widgets
const float LastPriority = -1e6f;
const double SmallestScale = 0.25;
const double LargestScale = 8.0;
const double SmallestFont = 6.0;
const double LargestFont = 96.0;
const double UnscaledDPI = 72.0; // VTK's default

const vtkCommand::EventIds InputEvents[] = { vtkCommand::MouseMoveEvent, vtkCommand::EnterEvent,
  vtkCommand::LeaveEvent, vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
  vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
  vtkCommand::LeftButtonDoubleClickEvent, vtkCommand::RightButtonDoubleClickEvent,
  vtkCommand::MiddleButtonDoubleClickEvent, vtkCommand::MouseWheelForwardEvent,
  vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent, vtkCommand::KeyReleaseEvent,
  vtkCommand::CharEvent };

// The button of an event: 0 left, 1 right, 2 middle.
int GetButton(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::RightButtonReleaseEvent:
    case vtkCommand::RightButtonDoubleClickEvent:
      return 1;
    case vtkCommand::MiddleButtonPressEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
    case vtkCommand::MiddleButtonDoubleClickEvent:
      return 2;
    default:
      return 0;
  }
}

bool IsRelease(unsigned long event)
{
  return event == vtkCommand::LeftButtonReleaseEvent ||
    event == vtkCommand::RightButtonReleaseEvent || event == vtkCommand::MiddleButtonReleaseEvent;
}
}

//------------------------------------------------------------------------------
class vtkImGuiOverlay::Internals
{
public:
  explicit Internals(vtkImGuiOverlay* overlay);
  ~Internals();

  void SetWindow(vtkRenderWindow* window);
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  /// Runs the callback and returns whether a frame would show something new.
  bool Update();
  /// Calls the interactor's Render().
  void RequestFrame();

  vtkImGuiOverlay* Overlay;
  relevo::ImGuiPanels Panels;
  relevo::ImGuiFont Font;
  relevo::PanelPainter Painter;
  relevo::SceneFrames Scene;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<relevo::OverlayProp> Prop;
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkWeakPointer<vtkRenderWindowInteractor> OwnInteractor; // set by the user
  std::function<void()> Callback;
  double Scale = 0.0;
  bool IsVisible = true;
  bool RepeatsScene = true;
  bool IsFrameRequested = false;
  vtkIdType Frames = 0;
  vtkIdType RepeatedFrames = 0;

private:
  void OnFrame();
  void OnFrameReady();
  void OnFrameEnd();
  void OnRequest();
  size_t GetLook() const { return this->IsVisible ? this->Panels.GetLook() : 0; }
  bool OnEvent(unsigned long event);
  void OnRelease(unsigned long event);
  bool Send(unsigned long event);
  void Observe(vtkRenderWindowInteractor* interactor);
  void KeepOnTop();
  void ApplyFont();
  void Run(const std::function<void()>& afterInput = nullptr);
  void Describe();
  bool Draw();

  vtkNew<vtkCallbackCommand> WindowCommand;
  vtkNew<vtkCallbackCommand> ReadyCommand; // after other observers
  vtkNew<vtkCallbackCommand> RequestCommand;
  vtkNew<vtkCallbackCommand> InputCommand;
  vtkNew<vtkCallbackCommand> ReleaseCommand;
  vtkWeakPointer<vtkRenderWindowInteractor> Observed;
  size_t DrawnLook = 0;
  bool IsRequesting = false;                                 // while the panels request a frame
  std::array<bool, 3> IsCaptured{ { false, false, false } }; // buttons pressed over a panel
  std::set<std::string> CapturedKeys;                        // pressed while ImGui used the keys
  bool IsCharacterCaptured = false;                          // of the last key
};

//------------------------------------------------------------------------------
vtkImGuiOverlay::Internals::Internals(vtkImGuiOverlay* overlay)
  : Overlay(overlay)
{
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->InteractiveOff();
  this->Renderer->PreserveDepthBufferOn();
  this->Renderer->PreserveColorBufferOn();
  this->Renderer->AddViewProp(this->Prop);
  this->Prop->Draw = [this](vtkViewport*) { return this->Draw(); };
  this->Prop->Release = [this](vtkWindow* window)
  {
    this->Painter.ReleaseGraphicsResources(window);
    this->Scene.ReleaseGraphicsResources(window);
  };

  this->WindowCommand->SetClientData(this);
  this->WindowCommand->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* data = static_cast<Internals*>(self);
      event == vtkCommand::StartEvent ? data->OnFrame() : data->OnFrameEnd();
    });
  this->ReadyCommand->SetClientData(this);
  this->ReadyCommand->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<Internals*>(self)->OnFrameReady(); });
  this->RequestCommand->SetPassiveObserver(1);
  this->RequestCommand->SetClientData(this);
  this->RequestCommand->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<Internals*>(self)->OnRequest(); });
  this->InputCommand->SetClientData(this);
  this->InputCommand->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* data = static_cast<Internals*>(self);
      data->InputCommand->SetAbortFlag(data->OnEvent(event));
    });
  // Interactor styles grab the events of a drag, so others see its end only passively.
  this->ReleaseCommand->SetPassiveObserver(1);
  this->ReleaseCommand->SetClientData(this);
  this->ReleaseCommand->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<Internals*>(self)->OnRelease(event); });
}

//------------------------------------------------------------------------------
vtkImGuiOverlay::Internals::~Internals()
{
  this->SetWindow(nullptr);
  this->Observe(nullptr);
  this->Prop->Draw = nullptr;
  this->Prop->Release = nullptr;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::SetWindow(vtkRenderWindow* window)
{
  if (this->Window)
  {
    this->Window->RemoveObserver(this->WindowCommand);
    this->Window->RemoveObserver(this->ReadyCommand);
    this->Window->RemoveRenderer(this->Renderer);
  }
  this->Window = window;
  if (window)
  {
    window->AddObserver(vtkCommand::StartEvent, this->WindowCommand);
    window->AddObserver(vtkCommand::StartEvent, this->ReadyCommand, LastPriority);
    window->AddObserver(vtkCommand::EndEvent, this->WindowCommand, Priority);
  }
  this->Observe(this->Overlay->GetInteractor());
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->OwnInteractor = interactor;
  this->Observe(this->Overlay->GetInteractor());
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::Observe(vtkRenderWindowInteractor* interactor)
{
  if (this->Observed == interactor)
  {
    return;
  }
  if (this->Observed)
  {
    this->Observed->RemoveObserver(this->InputCommand);
    this->Observed->RemoveObserver(this->ReleaseCommand);
    this->Observed->RemoveObserver(this->RequestCommand);
  }
  this->Observed = interactor;
  if (!interactor)
  {
    return;
  }
  interactor->AddObserver(vtkCommand::RenderEvent, this->RequestCommand);
  for (const vtkCommand::EventIds event : InputEvents)
  {
    interactor->AddObserver(event, this->InputCommand, Priority);
    if (IsRelease(event))
    {
      interactor->AddObserver(event, this->ReleaseCommand, Priority);
    }
  }
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::KeepOnTop()
{
  int highest = 0;
  bool isAdded = false;
  vtkRendererCollection* renderers = this->Window->GetRenderers();
  vtkCollectionSimpleIterator cookie;
  renderers->InitTraversal(cookie);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(cookie))
  {
    isAdded = isAdded || renderer == this->Renderer;
    highest = renderer == this->Renderer ? highest : std::max(highest, renderer->GetLayer());
  }
  if (this->Renderer->GetLayer() <= highest)
  {
    this->Renderer->SetLayer(highest + 1);
  }
  if (this->Window->GetNumberOfLayers() <= this->Renderer->GetLayer())
  {
    this->Window->SetNumberOfLayers(this->Renderer->GetLayer() + 1);
  }
  if (!isAdded)
  {
    this->Window->AddRenderer(this->Renderer);
  }
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::ApplyFont()
{
  const double automatic =
    std::clamp(this->Window->GetDPI() / UnscaledDPI, SmallestScale, LargestScale);
  if (!this->Font.Apply(this->Scale > 0.0 ? this->Scale : automatic))
  {
    vtkErrorWithObjectMacro(this->Overlay,
      "SetFontFileName: " << this->Font.FileName
                          << " cannot be read as a font. ImGui's font is used.");
  }
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::Describe()
{
  if (this->IsVisible)
  {
    if (this->Callback)
    {
      this->Callback();
    }
    this->Overlay->InvokeEvent(vtkImGuiOverlay::PanelsEvent);
  }
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::Run(const std::function<void()>& afterInput)
{
  this->ApplyFont();
  this->Panels.Run(
    this->Window->GetActualSize(), [this] { this->Describe(); }, afterInput);
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::Internals::Update()
{
  if (!this->Window || this->Panels.IsRunning())
  {
    return false;
  }
  // Without a pass, hidden panels reappear as they were, without the focus of new ones.
  if (this->IsVisible)
  {
    const relevo::ImGuiPanels::Current current(this->Panels);
    this->Run();
  }
  return this->IsFrameRequested || this->GetLook() != this->DrawnLook;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::OnFrame()
{
  this->KeepOnTop();
  this->Observe(this->Overlay->GetInteractor());
  this->Update();
  if (this->IsFrameRequested)
  {
    this->Scene.RequestScene();
  }
  this->IsFrameRequested = false;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::OnFrameReady()
{
  this->Scene.Start(this->Window, this->Renderer, this->RepeatsScene);
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::OnFrameEnd()
{
  this->RepeatedFrames += this->Scene.IsRepeating() ? 1 : 0;
  this->Scene.Finish(this->Window, this->Renderer);
  this->DrawnLook = this->GetLook();
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::OnRequest()
{
  // Otherwise, the interactor has drawn the frame already.
  if (!this->IsRequesting && !(this->Observed->GetEnabled() && this->Observed->GetEnableRender()))
  {
    this->Scene.RequestScene();
  }
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::RequestFrame()
{
  this->Observe(this->Overlay->GetInteractor());
  this->Scene.RequestPanels();
  this->IsRequesting = true;
  this->Observed->Render();
  this->IsRequesting = false;
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::Internals::Draw()
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  const relevo::ImGuiPanels::Current current(this->Panels);
  ImDrawData* panels = this->Panels.GetDrawData();
  if (!window)
  {
    return false;
  }
  const bool hasPanels = this->IsVisible && panels && panels->TotalVtxCount > 0;
  this->Scene.DrawBackground(window,
    hasPanels ? relevo::FindRectangle(panels, window->GetActualSize()) : relevo::PixelRectangle{});
  if (!hasPanels)
  {
    return this->Scene.IsRepeating();
  }
  if (!this->Painter.Draw(window, panels, this->Font.GetVersion()))
  {
    vtkErrorWithObjectMacro(this->Overlay, "The shader of the panels cannot be built.");
    return false;
  }
  ++this->Frames;
  return true;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::Internals::OnRelease(unsigned long event)
{
  const int button = GetButton(event);
  if (!this->IsCaptured[button])
  {
    const relevo::ImGuiPanels::Current current(this->Panels);
    relevo::SendMouseButton(button, false);
  }
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::Internals::OnEvent(unsigned long event)
{
  if (!this->IsVisible || !this->Window || this->Panels.IsRunning())
  {
    return false;
  }
  const relevo::ImGuiPanels::Current current(this->Panels);
  relevo::SendModifiers(this->Observed);
  const bool isCaptured = this->Send(event);
  if (this->IsFrameRequested || this->GetLook() != this->DrawnLook)
  {
    this->RequestFrame();
  }
  return isCaptured;
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::Internals::Send(unsigned long event)
{
  const int height = this->Window->GetActualSize()[1];
  const int button = GetButton(event);
  const std::string key = this->Observed->GetKeySym() ? this->Observed->GetKeySym() : "";
  bool isCaptured = false;
  // ImGui decides after it has seen the event, before the panels change.
  const auto findMouse = [&] { isCaptured = ImGui::GetIO().WantCaptureMouse; };
  const auto findKeys = [&] { isCaptured = ImGui::GetIO().WantCaptureKeyboard; };
  switch (event)
  {
    case vtkCommand::LeaveEvent:
      relevo::SendMouseLeave();
      this->Run();
      return false;
    case vtkCommand::EnterEvent:
    case vtkCommand::MouseMoveEvent:
      relevo::SendMousePosition(this->Observed, height);
      this->Run(findMouse);
      return isCaptured;
    case vtkCommand::LeftButtonPressEvent:
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::MiddleButtonPressEvent:
      relevo::SendMousePosition(this->Observed, height);
      relevo::SendMouseButton(button, true);
      this->Run(findMouse);
      this->IsCaptured[button] = isCaptured;
      return isCaptured;
    case vtkCommand::LeftButtonReleaseEvent:
    case vtkCommand::RightButtonReleaseEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
      relevo::SendMousePosition(this->Observed, height);
      relevo::SendMouseButton(button, false);
      this->Run();
      isCaptured = this->IsCaptured[button];
      this->IsCaptured[button] = false;
      return isCaptured;
    case vtkCommand::LeftButtonDoubleClickEvent:
    case vtkCommand::RightButtonDoubleClickEvent:
    case vtkCommand::MiddleButtonDoubleClickEvent:
      // ImGui finds double clicks by the time between clicks.
      return this->IsCaptured[button] || ImGui::GetIO().WantCaptureMouse;
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      relevo::SendMousePosition(this->Observed, height);
      relevo::SendMouseWheel(event == vtkCommand::MouseWheelForwardEvent ? 1.0f : -1.0f);
      this->Run(findMouse);
      return isCaptured;
    case vtkCommand::KeyPressEvent:
      relevo::SendKey(key, true);
      this->Run(findKeys);
      this->IsCharacterCaptured = isCaptured;
      if (isCaptured)
      {
        this->CapturedKeys.insert(key);
      }
      return isCaptured;
    case vtkCommand::KeyReleaseEvent:
      relevo::SendKey(key, false);
      this->Run();
      return this->CapturedKeys.erase(key) > 0;
    default: // CharEvent
      if (this->IsCharacterCaptured)
      {
        relevo::SendCharacter(this->Observed->GetKeyCode());
        this->Run();
      }
      return this->IsCharacterCaptured;
  }
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkImGuiOverlay);

//------------------------------------------------------------------------------
vtkImGuiOverlay::vtkImGuiOverlay()
  : Data(std::make_unique<Internals>(this))
{
}

//------------------------------------------------------------------------------
vtkImGuiOverlay::~vtkImGuiOverlay() = default;

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetRenderWindow(vtkRenderWindow* window)
{
  if (window != this->Data->Window)
  {
    this->Data->SetWindow(window);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkImGuiOverlay::GetRenderWindow()
{
  return this->Data->Window;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (interactor != this->Data->OwnInteractor)
  {
    this->Data->SetInteractor(interactor);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkImGuiOverlay::GetInteractor()
{
  if (this->Data->OwnInteractor)
  {
    return this->Data->OwnInteractor;
  }
  return this->Data->Window ? this->Data->Window->GetInteractor() : nullptr;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetCallback(std::function<void()> callback)
{
  this->Data->Callback = std::move(callback);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetVisibility(bool visibility)
{
  if (visibility != this->Data->IsVisible)
  {
    this->Data->IsVisible = visibility;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::GetVisibility()
{
  return this->Data->IsVisible;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetScale(double scale)
{
  if (scale == 0.0 || relevo::CheckRange(this, "Scale", scale, SmallestScale, LargestScale))
  {
    relevo::SetInRange(this, "Scale", this->Data->Scale, scale, 0.0, LargestScale);
  }
}

//------------------------------------------------------------------------------
double vtkImGuiOverlay::GetScale()
{
  return this->Data->Scale;
}

//------------------------------------------------------------------------------
double vtkImGuiOverlay::GetScaleInUse()
{
  return this->Data->Font.GetScale();
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetFontFileName(const char* fileName)
{
  const std::string name = fileName ? fileName : "";
  if (name != this->Data->Font.FileName)
  {
    this->Data->Font.FileName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkImGuiOverlay::GetFontFileName()
{
  return this->Data->Font.FileName.empty() ? nullptr : this->Data->Font.FileName.c_str();
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetFontSize(double pixels)
{
  relevo::SetInRange(this, "FontSize", this->Data->Font.Size, pixels, SmallestFont, LargestFont);
}

//------------------------------------------------------------------------------
double vtkImGuiOverlay::GetFontSize()
{
  return this->Data->Font.Size;
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::Update()
{
  return this->Data->Update();
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::Refresh()
{
  const bool isChanged = this->GetInteractor() && this->Data->Update();
  if (isChanged)
  {
    this->Data->RequestFrame();
  }
  return isChanged;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::RequestFrame()
{
  this->Data->IsFrameRequested = true;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::SetRepeatsScene(bool repeats)
{
  if (repeats != this->Data->RepeatsScene)
  {
    this->Data->RepeatsScene = repeats;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::GetRepeatsScene()
{
  return this->Data->RepeatsScene;
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::GetCapturesMouse()
{
  const relevo::ImGuiPanels::Current current(this->Data->Panels);
  return ImGui::GetIO().WantCaptureMouse;
}

//------------------------------------------------------------------------------
bool vtkImGuiOverlay::GetCapturesKeyboard()
{
  const relevo::ImGuiPanels::Current current(this->Data->Panels);
  return ImGui::GetIO().WantCaptureKeyboard;
}

//------------------------------------------------------------------------------
vtkIdType vtkImGuiOverlay::GetNumberOfFrames()
{
  return this->Data->Frames;
}

//------------------------------------------------------------------------------
vtkIdType vtkImGuiOverlay::GetNumberOfRepeatedFrames()
{
  return this->Data->RepeatedFrames;
}

//------------------------------------------------------------------------------
ImGuiContext* vtkImGuiOverlay::GetContext()
{
  return this->Data->Panels.GetContext();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkImGuiOverlay::GetRenderer()
{
  return this->Data->Renderer;
}

//------------------------------------------------------------------------------
void vtkImGuiOverlay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& data = *this->Data;
  os << indent << "RenderWindow: " << data.Window.Get() << "\n";
  os << indent << "Interactor: " << this->GetInteractor() << "\n";
  os << indent << "Visibility: " << (data.IsVisible ? "On" : "Off") << "\n";
  os << indent << "RepeatsScene: " << (data.RepeatsScene ? "On" : "Off") << "\n";
  os << indent << "Scale: " << data.Scale << "\n";
  os << indent << "FontFileName: " << data.Font.FileName << "\n";
  os << indent << "FontSize: " << data.Font.Size << "\n";
}
