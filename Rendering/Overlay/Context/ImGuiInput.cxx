// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Context/ImGuiInput.h"

#include <imgui.h>

#include "vtkRenderWindowInteractor.h"

#include <limits>
#include <map>

// ImGui 1.87 has a queue of events instead of arrays.
#define RELEVO_IMGUI_HAS_EVENTS (IMGUI_VERSION_NUM >= 18700)

namespace relevo
{
namespace
{
const std::map<std::string, ImGuiKey>& GetKeys()
{
  static const std::map<std::string, ImGuiKey> keys = {
    { "Tab", ImGuiKey_Tab },
    { "ISO_Left_Tab", ImGuiKey_Tab },
    { "Left", ImGuiKey_LeftArrow },
    { "Right", ImGuiKey_RightArrow },
    { "Up", ImGuiKey_UpArrow },
    { "Down", ImGuiKey_DownArrow },
    { "Prior", ImGuiKey_PageUp },
    { "Next", ImGuiKey_PageDown },
    { "Home", ImGuiKey_Home },
    { "End", ImGuiKey_End },
    { "Insert", ImGuiKey_Insert },
    { "Delete", ImGuiKey_Delete },
    { "BackSpace", ImGuiKey_Backspace },
    { "space", ImGuiKey_Space },
    { "Return", ImGuiKey_Enter },
    { "Escape", ImGuiKey_Escape },
#if RELEVO_IMGUI_HAS_EVENTS
    { "KP_Enter", ImGuiKey_KeypadEnter },
#else
    { "KP_Enter", ImGuiKey_KeyPadEnter },
#endif
    { "a", ImGuiKey_A },
    { "c", ImGuiKey_C },
    { "v", ImGuiKey_V },
    { "x", ImGuiKey_X },
    { "y", ImGuiKey_Y },
    { "z", ImGuiKey_Z },
  };
  return keys;
}
}

//------------------------------------------------------------------------------
void PrepareInput()
{
  ImGuiIO& io = ImGui::GetIO();
#if RELEVO_IMGUI_HAS_EVENTS
  // Each event has a pass of its own.
  io.ConfigInputTrickleEventQueue = false;
#else
  for (const auto& key : GetKeys())
  {
    io.KeyMap[key.second] = key.second;
  }
#endif
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  // A blinking cursor would need frames.
  io.ConfigInputTextCursorBlink = false;
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
}

//------------------------------------------------------------------------------
void SendMousePosition(vtkRenderWindowInteractor* interactor, int height)
{
  // ImGui's pixel centres are whole numbers, counted from the top.
  const int* position = interactor->GetEventPosition();
  const float x = static_cast<float>(position[0]);
  const float y = static_cast<float>(height - 1 - position[1]);
#if RELEVO_IMGUI_HAS_EVENTS
  ImGui::GetIO().AddMousePosEvent(x, y);
#else
  ImGui::GetIO().MousePos = ImVec2(x, y);
#endif
}

//------------------------------------------------------------------------------
void SendMouseLeave()
{
  const float outside = -std::numeric_limits<float>::max();
#if RELEVO_IMGUI_HAS_EVENTS
  ImGui::GetIO().AddMousePosEvent(outside, outside);
#else
  ImGui::GetIO().MousePos = ImVec2(outside, outside);
#endif
}

//------------------------------------------------------------------------------
void SendMouseButton(int button, bool isDown)
{
#if RELEVO_IMGUI_HAS_EVENTS
  ImGui::GetIO().AddMouseButtonEvent(button, isDown);
#else
  ImGui::GetIO().MouseDown[button] = isDown;
#endif
}

//------------------------------------------------------------------------------
void SendMouseWheel(float steps)
{
#if RELEVO_IMGUI_HAS_EVENTS
  ImGui::GetIO().AddMouseWheelEvent(0.0f, steps);
#else
  ImGui::GetIO().MouseWheel += steps;
#endif
}

//------------------------------------------------------------------------------
void SendModifiers(vtkRenderWindowInteractor* interactor)
{
  ImGuiIO& io = ImGui::GetIO();
  const bool hasControl = interactor->GetControlKey() != 0;
  const bool hasShift = interactor->GetShiftKey() != 0;
  const bool hasAlt = interactor->GetAltKey() != 0;
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Ctrl, hasControl);
  io.AddKeyEvent(ImGuiMod_Shift, hasShift);
  io.AddKeyEvent(ImGuiMod_Alt, hasAlt);
#elif RELEVO_IMGUI_HAS_EVENTS
  io.AddKeyEvent(ImGuiKey_ModCtrl, hasControl);
  io.AddKeyEvent(ImGuiKey_ModShift, hasShift);
  io.AddKeyEvent(ImGuiKey_ModAlt, hasAlt);
#else
  io.KeyCtrl = hasControl;
  io.KeyShift = hasShift;
  io.KeyAlt = hasAlt;
#endif
}

//------------------------------------------------------------------------------
void SendKey(const std::string& symbol, bool isDown)
{
  // The symbols of letters are capital with Shift.
  const bool isCapital = symbol.size() == 1 && symbol[0] >= 'A' && symbol[0] <= 'Z';
  const auto key =
    GetKeys().find(isCapital ? std::string(1, static_cast<char>(symbol[0] - 'A' + 'a')) : symbol);
  if (key == GetKeys().end())
  {
    return;
  }
#if RELEVO_IMGUI_HAS_EVENTS
  ImGui::GetIO().AddKeyEvent(key->second, isDown);
#else
  ImGui::GetIO().KeysDown[key->second] = isDown;
#endif
}

//------------------------------------------------------------------------------
void SendCharacter(char character)
{
  if (character >= ' ' && character < 127)
  {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned int>(character));
  }
}
}
