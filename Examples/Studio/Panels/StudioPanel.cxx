// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/StudioPanel.h"

#include "Panels/ControlWidget.h"
#include "Panels/PatternDrawing.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace
{
const char* const Title = "relevo-studio";

std::vector<std::string> FindGroups(const std::vector<Control>& controls)
{
  std::vector<std::string> groups;
  for (const Control& control : controls)
  {
    if (std::find(groups.begin(), groups.end(), control.Group) == groups.end())
    {
      groups.push_back(control.Group);
    }
  }
  return groups;
}

// The groups that are open at first.
bool IsOpen(const std::string& group)
{
  static const std::set<std::string> open = { "Data", "Colours", "Figures" };
  return open.count(group) > 0;
}

std::string FormatFigure(double value)
{
  char text[32];
  const bool isWhole = value == std::floor(value) && std::abs(value) < 1e15;
  std::snprintf(text, sizeof(text), isWhole ? "%.0f" : "%.3g", value);
  return text;
}

bool IsTabPressed()
{
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(ImGuiKey_Tab, false);
#else
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false);
#endif
}

bool IsControlPressed(ImGuiKey key)
{
#if IMGUI_VERSION_NUM >= 18700
  const bool isPressed = ImGui::IsKeyPressed(key, false);
#else
  const bool isPressed = ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
#endif
  return isPressed && ImGui::GetIO().KeyCtrl && !ImGui::GetIO().WantTextInput;
}
}

//------------------------------------------------------------------------------
bool StudioPanel::IsRevealed(const std::string& name) const
{
  // The parts of a control are named after it.
  const std::string& revealed = this->Revealed;
  return !revealed.empty() &&
    (revealed == name || revealed.compare(0, name.size() + 1, name + ".") == 0 ||
      revealed.compare(0, name.size() + 1, name + "-") == 0);
}

//------------------------------------------------------------------------------
void StudioPanel::Draw(const PanelState& state, PanelRequests& requests)
{
  this->Layout.Start(this->Revealed);
  this->HasHistogram = false;
  DrawSceneTexts(state.Texts, this->Layout);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = std::min(std::round(ImGui::GetFontSize() * 25.0f), window.x);
  ImGui::SetNextWindowPos(ImVec2(window.x - width, 0.0f), ImGuiCond_Always);
  ImGui::SetNextWindowSize(ImVec2(width, window.y), ImGuiCond_Always);
  // The scene does not clear the window below the panel.
  ImGui::SetNextWindowBgAlpha(1.0f);
  if (IsTabPressed() && !ImGui::GetIO().NavActive)
  {
    ImGui::SetNextWindowFocus();
  }
  if (IsControlPressed(ImGuiKey_Z))
  {
    requests.Press("undo");
  }
  if (IsControlPressed(ImGuiKey_Y))
  {
    requests.Press("redo");
  }
  if (ImGui::Begin(Title, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
  {
    if (!state.Message.empty())
    {
      ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.45f, 0.35f, 1.0f));
      ImGui::TextWrapped("%s", state.Message.c_str());
      ImGui::PopStyleColor();
    }
    else if (!state.Note.empty())
    {
      ImGui::TextWrapped("%s", state.Note.c_str());
    }
    if (!state.KeptText.empty())
    {
      this->DrawKeptText(state);
    }
    for (const std::string& group : FindGroups(state.Controls))
    {
      this->DrawGroup(group, state, requests);
    }
    this->DrawFigures(state);
    this->DrawPatterns(state);
  }
  this->Width = ImGui::IsWindowCollapsed() ? 0 : static_cast<int>(width);
  ImGui::End();
  this->Revealed.clear();
}

//------------------------------------------------------------------------------
void StudioPanel::DrawGroup(
  const std::string& group, const PanelState& state, PanelRequests& requests)
{
  if (group.empty())
  {
    this->DrawControls(group, state, requests);
    return;
  }
  const bool hasRevealed = std::any_of(state.Controls.begin(), state.Controls.end(),
    [&](const Control& control)
    { return control.Group == group && this->IsRevealed(control.Name); });
  if (hasRevealed)
  {
    ImGui::SetNextItemOpen(true);
  }
  const bool isOpen = ImGui::CollapsingHeader(
    group.c_str(), IsOpen(group) ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  this->AddHeader(group, isOpen);
  if (isOpen)
  {
    this->DrawControls(group, state, requests);
    return;
  }
  for (const Control& control : state.Controls)
  {
    if (control.Group == group)
    {
      LayoutEntry entry = MakeEntry(control);
      entry.IsVisible = false;
      this->Layout.Add(entry);
    }
  }
}

//------------------------------------------------------------------------------
void StudioPanel::AddHeader(const std::string& group, bool isOpen)
{
  LayoutEntry header;
  header.Name = "group " + group;
  header.Kind = "group";
  header.Value = isOpen ? "on" : "off";
  this->Layout.AddItem(header);
}

//------------------------------------------------------------------------------
void StudioPanel::DrawControls(
  const std::string& group, const PanelState& state, PanelRequests& requests)
{
  ControlWidget widget(this->Layout, requests, state.Content);
  bool isButtonBefore = false;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  for (const Control& control : state.Controls)
  {
    if (control.Group != group)
    {
      continue;
    }
    const bool isButton = control.Kind == ControlKind::Button;
    const float needed = ImGui::CalcTextSize(control.Name.c_str()).x + ImGui::GetFontSize();
    if (isButton && isButtonBefore && ImGui::GetItemRectMax().x + needed < right)
    {
      ImGui::SameLine();
    }
    isButtonBefore = isButton;
    widget.Draw(control);
    if (control.Kind == ControlKind::Transfer)
    {
      this->Transfer.Draw(control, state.Content, this->Layout, requests);
    }
    if (control.Name == "pattern-levels")
    {
      DrawPattern(state.Pattern);
    }
  }
}

//------------------------------------------------------------------------------
void StudioPanel::DrawKeptText(const PanelState& state)
{
  ImGui::TextWrapped("%s", state.KeptText.c_str());
  LayoutEntry entry;
  entry.Name = "probe";
  entry.Kind = "words";
  entry.Value = state.KeptText;
  this->Layout.AddItem(entry);
}

//------------------------------------------------------------------------------
void StudioPanel::DrawFigures(const PanelState& state)
{
  const bool isOpen = ImGui::CollapsingHeader("Figures", ImGuiTreeNodeFlags_DefaultOpen);
  this->AddHeader("Figures", isOpen);
  if (!isOpen)
  {
    return;
  }
  for (const auto& figure : state.Figures)
  {
    ImGui::TextUnformatted(figure.first.c_str());
    ImGui::SameLine(ImGui::GetFontSize() * 13.5f);
    const bool isMemory = figure.first == "memory";
    ImGui::TextUnformatted(isMemory ? (FormatFigure(figure.second / 1048576.0) + " MiB").c_str()
                                    : FormatFigure(figure.second).c_str());
  }
}

//------------------------------------------------------------------------------
void StudioPanel::DrawPatterns(const PanelState& state)
{
  const std::string group = "Levels and patterns";
  this->HasHistogram = ImGui::CollapsingHeader(group.c_str());
  this->AddHeader(group, this->HasHistogram);
  if (this->HasHistogram)
  {
    DrawHistogram(state.Patterns);
  }
}
