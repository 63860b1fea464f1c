// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Context/ImGuiPanels.h"

#include "Context/ImGuiInput.h"

#include <imgui.h>

#include "vtkTimerLog.h"

#include <algorithm>
#include <string_view>

namespace relevo
{
namespace
{
const int MaximumPasses = 4;

void AddBytes(size_t& sum, const void* bytes, size_t size)
{
  const std::string_view text(static_cast<const char*>(bytes), size);
  sum = sum * 31 + std::hash<std::string_view>()(text);
}
}

//------------------------------------------------------------------------------
ImGuiPanels::Current::Current(ImGuiPanels& panels)
  : Previous(ImGui::GetCurrentContext())
{
  ImGui::SetCurrentContext(panels.Context);
}

//------------------------------------------------------------------------------
ImGuiPanels::Current::~Current()
{
  ImGui::SetCurrentContext(this->Previous);
}

//------------------------------------------------------------------------------
ImGuiPanels::ImGuiPanels()
{
  ImGuiContext* previous = ImGui::GetCurrentContext();
  this->Context = ImGui::CreateContext();
  ImGui::SetCurrentContext(this->Context);
  ImGui::GetIO().BackendRendererName = "vtkImGuiOverlay";
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  PrepareInput();
  ImGui::SetCurrentContext(previous);
}

//------------------------------------------------------------------------------
ImGuiPanels::~ImGuiPanels()
{
  ImGuiContext* previous = ImGui::GetCurrentContext();
  ImGui::DestroyContext(this->Context);
  ImGui::SetCurrentContext(previous == this->Context ? nullptr : previous);
}

//------------------------------------------------------------------------------
void ImGuiPanels::Run(
  const int size[2], const std::function<void()>& describe, const std::function<void()>& afterInput)
{
  this->Running = true;
  ImGui::GetIO().DisplaySize = ImVec2(static_cast<float>(size[0]), static_cast<float>(size[1]));
  const bool isFirst = this->Time < 0.0;
  this->Pass(describe, afterInput);
  if (isFirst)
  {
    // ImGui gives new windows the focus. The scene keeps the keys until the user enters a panel.
    ImGui::SetWindowFocus(nullptr);
  }
  for (int pass = 1; pass < MaximumPasses; ++pass)
  {
    const size_t look = this->Look;
    this->Pass(describe, nullptr);
    if (this->Look == look)
    {
      break;
    }
  }
  this->Running = false;
}

//------------------------------------------------------------------------------
void ImGuiPanels::Pass(
  const std::function<void()>& describe, const std::function<void()>& afterInput)
{
  const double now = vtkTimerLog::GetUniversalTime();
  const double shortest = 1e-5;
  const double longest = 0.1;
  const double passed = this->Time < 0.0 ? shortest : now - this->Time;
  ImGui::GetIO().DeltaTime = static_cast<float>(std::clamp(passed, shortest, longest));
  this->Time = now;
  ImGui::NewFrame();
  if (afterInput)
  {
    afterInput();
  }
  describe();
  ImGui::Render();
  this->MeasureLook();
}

//------------------------------------------------------------------------------
void ImGuiPanels::MeasureLook()
{
  size_t look = 0;
  const ImDrawData* data = ImGui::GetDrawData();
  AddBytes(look, &data->DisplaySize, sizeof(data->DisplaySize));
  for (int i = 0; i < data->CmdListsCount; ++i)
  {
    const ImDrawList* list = data->CmdLists[i];
    AddBytes(look, list->VtxBuffer.Data, sizeof(ImDrawVert) * list->VtxBuffer.Size);
    AddBytes(look, list->IdxBuffer.Data, sizeof(ImDrawIdx) * list->IdxBuffer.Size);
    for (const ImDrawCmd& command : list->CmdBuffer)
    {
      AddBytes(look, &command.ClipRect, sizeof(command.ClipRect));
    }
  }
  this->Look = look;
}

//------------------------------------------------------------------------------
ImDrawData* ImGuiPanels::GetDrawData() const
{
  return this->Running ? nullptr : ImGui::GetDrawData();
}
}
