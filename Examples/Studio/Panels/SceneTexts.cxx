// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/SceneTexts.h"

#include <imgui.h>

namespace
{
const float Margin = 10.0f;
const float MarkSize = 6.0f;
const float MarkWidth = 2.0f;

// A window that takes no events.
void DrawText(const std::string& name, const std::string& text, LayoutList& layout)
{
  const int flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings;
  ImGui::SetNextWindowBgAlpha(0.85f);
  if (ImGui::Begin(("##" + name).c_str(), nullptr, flags))
  {
    ImGui::TextUnformatted(text.c_str());
    LayoutEntry entry;
    entry.Name = name;
    entry.Kind = "words";
    entry.Value = text;
    layout.AddItem(entry);
  }
  ImGui::End();
}

void DrawMark(const ImVec2& centre)
{
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const ImVec2 ends[2] = { ImVec2(MarkSize, 0.0f), ImVec2(0.0f, MarkSize) };
  for (const float width : { 2.0f * MarkWidth, MarkWidth })
  {
    const ImU32 color =
      width > MarkWidth ? IM_COL32(255, 255, 255, 200) : IM_COL32(200, 30, 30, 255);
    for (const ImVec2& end : ends)
    {
      list->AddLine(ImVec2(centre.x - end.x, centre.y - end.y),
        ImVec2(centre.x + end.x, centre.y + end.y), color, width);
    }
  }
}
}

//------------------------------------------------------------------------------
void DrawSceneTexts(const SceneTexts& texts, LayoutList& layout)
{
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (texts.Mark)
  {
    DrawMark(ImVec2(
      static_cast<float>((*texts.Mark)[0]), window.y - static_cast<float>((*texts.Mark)[1])));
  }
  if (!texts.Readout.empty())
  {
    ImGui::SetNextWindowPos(
      ImVec2(Margin, window.y - Margin), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
    DrawText("readout", texts.Readout, layout);
  }
  if (!texts.Keys.empty())
  {
    ImGui::SetNextWindowPos(ImVec2(0.5f * static_cast<float>(texts.SceneWidth), 0.5f * window.y),
      ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    DrawText("key-help", texts.Keys, layout);
  }
}
