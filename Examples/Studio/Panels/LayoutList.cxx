// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/LayoutList.h"

#include <imgui.h>

#include <algorithm>

//------------------------------------------------------------------------------
void LayoutList::AddItem(LayoutEntry entry)
{
  const ImVec2 first = ImGui::GetItemRectMin();
  const ImVec2 last = ImGui::GetItemRectMax();
  entry.Rectangle[0] = first.x;
  entry.Rectangle[1] = first.y;
  entry.Rectangle[2] = last.x - first.x;
  entry.Rectangle[3] = last.y - first.y;
  entry.IsVisible = ImGui::IsItemVisible();
  entry.IsFocused = ImGui::IsItemFocused();
  if (!this->Revealed.empty() && entry.Name == this->Revealed)
  {
    ImGui::SetScrollHereY();
  }
  this->Entries.push_back(entry);
}

//------------------------------------------------------------------------------
void LayoutList::Start(const std::string& revealed)
{
  this->Entries.clear();
  this->Revealed = revealed;
}

//------------------------------------------------------------------------------
const LayoutEntry* LayoutList::Find(const std::string& name) const
{
  const auto entry = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&](const LayoutEntry& candidate) { return candidate.Name == name; });
  return entry == this->Entries.end() ? nullptr : &*entry;
}

//------------------------------------------------------------------------------
LayoutEntry MakeEntry(const Control& control)
{
  static const char* const kinds[] = { "choice", "flag", "number", "color", "integer", "step",
    "plane", "transfer", "text", "button" };
  LayoutEntry entry;
  entry.Name = control.Name;
  entry.Kind = kinds[static_cast<int>(control.Kind)];
  entry.Value = control.Value.value_or("");
  entry.Default = control.Default;
  entry.Unit = control.Unit;
  entry.HasRange = control.Kind == ControlKind::Number || control.Kind == ControlKind::Integer;
  entry.Range[0] = control.Ranges.front()[0];
  entry.Range[1] = control.Ranges.front()[1];
  entry.IsEnabled = control.IsEnabled;
  entry.Reason = control.Reason;
  return entry;
}
