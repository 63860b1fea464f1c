// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A sphere in a window with an overlay, and events of its interactor.
#ifndef OverlayStage_h
#define OverlayStage_h

#include "RelevoScene.h"
#include "vtkImGuiOverlay.h"

#include <imgui.h>

#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

class OverlayStage
{
public:
  static constexpr int Width = 240;
  static constexpr int Height = 180;

  explicit OverlayStage(int multiSamples = 0)
  {
    vtkNew<vtkSphereSource> sphere;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.2, 0.3, 0.4);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(multiSamples);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->SetInteractorStyle(this->Style);
    this->Overlay->SetRenderWindow(this->Window);
    this->Overlay->SetScale(1.0);
    this->Overlay->SetCallback([this] { this->Describe(); });
    this->Actor->SetMapper(mapper);
    this->Window->AddObserver(vtkCommand::EndEvent, this, &OverlayStage::OnFrame);
    this->Renderer->AddObserver(vtkCommand::EndEvent, this, &OverlayStage::OnScene);
    this->Renderer->ResetCamera();
    this->Interactor->Enable();
  }

  // Sends an event at a position from the upper left corner.
  void Send(unsigned long event, int x, int y)
  {
    this->Interactor->SetEventInformation(x, Height - 1 - y, 0, 0);
    this->Interactor->InvokeEvent(event);
  }

  void SendKey(const char* symbol, char code)
  {
    this->Interactor->SetKeyEventInformation(0, 0, code, 1, symbol);
    this->Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->Interactor->InvokeEvent(vtkCommand::CharEvent);
    this->Interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
  }

  void Drag(int x0, int y0, int x1, int y1)
  {
    this->Send(vtkCommand::MouseMoveEvent, x0, y0);
    this->Send(vtkCommand::LeftButtonPressEvent, x0, y0);
    const int steps = 5;
    for (int i = 1; i <= steps; ++i)
    {
      this->Send(
        vtkCommand::MouseMoveEvent, x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps);
    }
    this->Send(vtkCommand::LeftButtonReleaseEvent, x1, y1);
  }

  void Click(int x, int y) { this->Drag(x, y, x, y); }

  double GetAzimuth() { return this->Renderer->GetActiveCamera()->GetPosition()[0]; }

  // The panel is at (10, 10), with 130 x 90 pixels.
  void Describe()
  {
    if (!this->HasPanel)
    {
      return;
    }
    ImGui::SetNextWindowPos(ImVec2(10.0f, 10.0f));
    ImGui::SetNextWindowSize(ImVec2(130.0f, 90.0f));
    ImGui::Begin("Panel", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    ImGui::SetNextItemWidth(110.0f);
    if (ImGui::SliderFloat("##value", &this->Value, 0.0f, 1.0f) && this->IsColored)
    {
      this->Actor->GetProperty()->SetColor(1.0, this->Value, 0.2);
    }
    this->SliderY =
      static_cast<int>(0.5f * (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y));
    ImGui::SetNextItemWidth(110.0f);
    ImGui::InputText("##text", this->Text, sizeof(this->Text));
    this->TextY = static_cast<int>(0.5f * (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y));
    ImGui::End();
  }

  bool HasPanel = true;
  bool IsColored = false; // whether the slider colours the sphere
  float Value = 0.0f;
  char Text[32] = "";
  int SliderY = 0;
  int TextY = 0;
  int Frames = 0;
  int SceneFrames = 0; // in which the sphere is drawn
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkInteractorStyleTrackballCamera> Style;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
  vtkNew<vtkImGuiOverlay> Overlay;

private:
  void OnFrame() { ++this->Frames; }
  void OnScene() { ++this->SceneFrames; }
};

#endif
