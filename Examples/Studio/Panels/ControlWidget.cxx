// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/ControlWidget.h"

#include "Controls/ControlNumbers.h"
#include "Options/ViewerArguments.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace
{
const double SmallestGap = 1e-3; // between increasing numbers, share of the slider

// From a place to the end of the last item.
void SetRectangle(const ImVec2& start, LayoutEntry& entry)
{
  entry.Rectangle[0] = start.x;
  entry.Rectangle[1] = start.y;
  entry.Rectangle[2] = ImGui::GetItemRectMax().x - start.x;
  entry.Rectangle[3] = ImGui::GetItemRectMax().y - start.y;
  entry.IsVisible = ImGui::IsItemVisible();
}

unsigned int ToByte(float share)
{
  return static_cast<unsigned int>(std::lround(255.0f * std::min(std::max(share, 0.0f), 1.0f)));
}
}

//------------------------------------------------------------------------------
ControlWidget::ControlWidget(
  LayoutList& layout, PanelRequests& requests, const SceneContent& content)
  : Layout(layout)
  , Requests(requests)
  , Content(content)
{
}

//------------------------------------------------------------------------------
void ControlWidget::Finish(const LayoutEntry& entry, bool isChanged, const std::string& value)
{
  const bool isContinued = !ImGui::IsItemActivated() && ImGui::IsItemActive();
  this->Layout.AddItem(entry);
  if (isChanged)
  {
    this->Requests.Set(entry.Name, value, isContinued);
  }
}

//------------------------------------------------------------------------------
void ControlWidget::Draw(const Control& control)
{
  ImGui::PushID(control.Name.c_str());
  ImGui::BeginDisabled(!control.IsEnabled);
  ImGui::BeginGroup();
  switch (control.Kind)
  {
    case ControlKind::Choice:
      this->DrawChoice(control);
      break;
    case ControlKind::Flag:
      this->DrawFlag(control);
      break;
    case ControlKind::Number:
    case ControlKind::Integer:
      this->DrawNumbers(control);
      break;
    case ControlKind::Step:
      this->DrawStep(control);
      break;
    case ControlKind::Plane:
      this->DrawPlane(control);
      break;
    case ControlKind::Color:
      this->DrawColor(control);
      break;
    case ControlKind::Text:
    case ControlKind::Transfer:
      this->DrawText(control, ImGui::GetFontSize() * 13.0f);
      break;
    case ControlKind::Button:
      if (ImGui::Button(control.Name.c_str()))
      {
        this->Requests.Press(control.Name);
      }
      this->Layout.AddItem(MakeEntry(control));
      break;
  }
  if (control.Kind != ControlKind::Button)
  {
    this->DrawDefault(control);
  }
  ImGui::EndGroup();
  ImGui::EndDisabled();
  this->DrawTip(control);
  ImGui::PopID();
}

//------------------------------------------------------------------------------
void ControlWidget::DrawDefault(const Control& control)
{
  ImGui::SameLine(ImGui::GetFontSize() * 13.5f);
  ImGui::BeginDisabled(!control.Value.has_value());
  if (ImGui::SmallButton("x"))
  {
    this->Requests.Set(control.Name, std::nullopt, false);
  }
  LayoutEntry entry;
  entry.Name = control.Name + ".default";
  entry.Kind = "button";
  entry.IsEnabled = control.IsEnabled && control.Value.has_value();
  entry.Reason = control.IsEnabled ? control.Name + " has its default" : control.Reason;
  this->Layout.AddItem(entry);
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::TextUnformatted(control.Name.c_str());
}

//------------------------------------------------------------------------------
void ControlWidget::DrawTip(const Control& control)
{
  if (control.Kind == ControlKind::Button && control.IsEnabled)
  {
    return;
  }
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
  {
    return;
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 25.0f);
  if (!control.IsEnabled)
  {
    ImGui::TextUnformatted(control.Reason.c_str());
  }
  else
  {
    ImGui::TextUnformatted(("--" + control.Name +
      (control.Unit.empty() ? "" : ", " + control.Unit) + "\ndefault: " + control.Default)
                             .c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

//------------------------------------------------------------------------------
void ControlWidget::DrawChoice(const Control& control)
{
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13.0f);
  const std::string shown = control.Value ? *control.Value : "(" + control.Default + ")";
  const bool isOpen = ImGui::BeginCombo("##choice", shown.c_str());
  this->Layout.AddItem(MakeEntry(control));
  if (!isOpen)
  {
    return;
  }
  for (const std::string& choice : control.Choices)
  {
    const bool isChosen = control.Value && *control.Value == choice;
    if (ImGui::Selectable(choice.c_str(), isChosen))
    {
      this->Requests.Set(control.Name, choice, false);
    }
    LayoutEntry entry;
    entry.Name = control.Name + "=" + choice;
    entry.Kind = "item";
    entry.Value = isChosen ? "on" : "off";
    this->Layout.AddItem(entry);
  }
  ImGui::EndCombo();
}

//------------------------------------------------------------------------------
void ControlWidget::DrawFlag(const Control& control)
{
  bool isOn = control.Value && *control.Value == "on";
  const bool isChanged = ImGui::Checkbox("##flag", &isOn);
  this->Layout.AddItem(MakeEntry(control));
  if (isChanged)
  {
    this->Requests.Set(control.Name, isOn ? std::optional<std::string>("on") : std::nullopt, false);
  }
}

//------------------------------------------------------------------------------
void ControlWidget::DrawNumbers(const Control& control)
{
  std::vector<double> numbers = !control.Current.empty() ? control.Current
    : control.Value                                      ? ParseNumbers(*control.Value)
                                                         : control.Start;
  if (numbers.empty())
  {
    numbers = control.Start;
  }
  const bool isInteger = control.Kind == ControlKind::Integer;
  const int flags =
    (control.IsLogarithmic ? ImGuiSliderFlags_Logarithmic : 0) | ImGuiSliderFlags_NoRoundToFormat;
  const auto number = static_cast<int>(numbers.size());
  const bool isKnown = control.Value || control.IsStartShown || !control.Current.empty();
  const char* format = !isKnown ? "default" : isInteger ? "%.0f" : "%.5g";
  LayoutEntry entry = MakeEntry(control);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  for (int i = 0; i < number; ++i)
  {
    const std::array<double, 2>& range =
      control.Ranges[std::min<std::size_t>(i, control.Ranges.size() - 1)];
    double lowest = std::min(range[0], numbers[i]);
    double highest = std::max(range[1], numbers[i]);
    ImGui::PushID(i);
    ImGui::SetNextItemWidth((ImGui::GetFontSize() * 13.0f - 2.0f * (number - 1)) / number);
    double value = numbers[i];
    bool isChanged = ImGui::SliderScalar(
      "##number", ImGuiDataType_Double, &value, &lowest, &highest, format, flags);
    value = isInteger ? std::round(value) : value;
    if (control.IsIncreasing)
    {
      const double gap = SmallestGap * (range[1] - range[0]);
      value = i > 0 ? std::max(value, numbers[i - 1] + gap) : value;
      value = i + 1 < number ? std::min(value, numbers[i + 1] - gap) : value;
    }
    isChanged = isChanged && value != numbers[i];
    const bool isContinued = !ImGui::IsItemActivated();
    LayoutEntry part = entry;
    part.Name = number > 1 ? control.Name + "." + std::to_string(i) : control.Name;
    part.Value = WriteNumbers({ value });
    part.Range[0] = lowest;
    part.Range[1] = highest;
    this->Layout.AddItem(part);
    if (isChanged)
    {
      numbers[i] = value;
      this->Requests.Set(control.Name, WriteNumbers(numbers), isContinued);
    }
    if (i + 1 < number)
    {
      ImGui::SameLine(0.0f, 2.0f);
    }
    ImGui::PopID();
  }
  if (number > 1)
  {
    SetRectangle(start, entry);
    this->Layout.Add(entry);
  }
}

//------------------------------------------------------------------------------
void ControlWidget::DrawStep(const Control& control)
{
  int step = this->Content.Step;
  const int last = std::max(static_cast<int>(this->Content.Times.size()) - 1, 0);
  std::array<char, 64> shown{ "no times" };
  if (!this->Content.Times.empty())
  {
    std::snprintf(
      shown.data(), shown.size(), "%%d of %d: time %.6g", last, this->Content.Times[step]);
  }
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13.0f);
  const bool isChanged = ImGui::SliderInt("##step", &step, 0, last, shown.data());
  const bool isOther = isChanged && step >= 0 && step <= last && !this->Content.Times.empty();
  this->Finish(
    MakeEntry(control), isOther, isOther ? WriteNumbers({ this->Content.Times[step] }) : "");
}

//------------------------------------------------------------------------------
void ControlWidget::DrawPlane(const Control& control)
{
  std::vector<double> plane = control.Value ? ParseNumbers(*control.Value) : std::vector<double>();
  const int direction = FindPlaneDirection(plane);
  const std::array<double, 6> bounds = this->Content.Bounds.value_or(std::array<double, 6>{});
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.0f);
  const bool isOpen =
    ImGui::BeginCombo("##direction", direction < 0 ? "other" : PlaneDirections[direction]);
  LayoutEntry entry = MakeEntry(control);
  entry.Name = "clip-direction";
  entry.Kind = "choice";
  entry.Value = direction < 0 ? "other" : PlaneDirections[direction];
  this->Layout.AddItem(entry);
  if (isOpen)
  {
    for (int i = 0; i < static_cast<int>(PlaneDirections.size()); ++i)
    {
      if (ImGui::Selectable(PlaneDirections[i], direction == i))
      {
        const auto turned = WriteNumbers(TurnPlane(plane, bounds, i));
        this->Requests.Set(
          control.Name, i == 0 ? std::nullopt : std::optional<std::string>(turned), false);
      }
      LayoutEntry item;
      item.Name = std::string("clip-direction=") + PlaneDirections[i];
      item.Kind = "item";
      this->Layout.AddItem(item);
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine(0.0f, 2.0f);
  ImGui::BeginDisabled(direction <= 0);
  const int axis = std::max(direction - 1, 0) / 2;
  double position = direction > 0 ? plane[axis] : 0.0;
  double lowest = std::min(position, bounds[2 * axis]);
  double highest = std::max(position, bounds[2 * axis + 1]);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9.0f - 2.0f);
  const bool isChanged = ImGui::SliderScalar("##position", ImGuiDataType_Double, &position, &lowest,
    &highest, "%.5g", ImGuiSliderFlags_NoRoundToFormat);
  const bool isContinued = !ImGui::IsItemActivated();
  entry.Name = "clip-position";
  entry.Kind = "number";
  entry.Value = direction > 0 ? WriteNumbers({ position }) : "";
  entry.HasRange = true;
  entry.Range[0] = lowest;
  entry.Range[1] = highest;
  entry.IsEnabled = control.IsEnabled && direction > 0;
  entry.Reason = control.IsEnabled ? "set clip-direction first" : control.Reason;
  this->Layout.AddItem(entry);
  ImGui::EndDisabled();
  entry = MakeEntry(control);
  SetRectangle(start, entry);
  this->Layout.Add(entry);
  if (isChanged && direction > 0 && position != plane[axis])
  {
    plane[axis] = position;
    this->Requests.Set(control.Name, WriteNumbers(plane), isContinued);
  }
}

//------------------------------------------------------------------------------
void ControlWidget::DrawColor(const Control& control)
{
  const float swatch = ImGui::GetFrameHeight() + 2.0f;
  this->DrawText(control, ImGui::GetFontSize() * 13.0f - swatch);
  ImGui::SameLine(0.0f, 2.0f);
  std::array<double, 3> color = { { 1.0, 1.0, 1.0 } };
  if (control.Value)
  {
    color = ToColor("--" + control.Name, *control.Value);
  }
  float shown[3];
  std::copy(color.begin(), color.end(), shown);
  const bool isChanged = ImGui::ColorEdit3("##color", shown, ImGuiColorEditFlags_NoInputs);
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", ToByte(shown[0]), ToByte(shown[1]),
    ToByte(shown[2]));
  if (isChanged)
  {
    this->Requests.Set(control.Name, text.data(), ImGui::IsItemActive());
  }
}

//------------------------------------------------------------------------------
void ControlWidget::DrawText(const Control& control, float width)
{
  constexpr std::size_t more = 1024; // characters that the user may add
  const std::string value = control.Value.value_or("");
  std::vector<char> text(value.size() + more, '\0');
  std::copy(value.begin(), value.end(), text.begin());
  ImGui::SetNextItemWidth(width);
  const bool isEntered =
    ImGui::InputText("##text", text.data(), text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  this->Layout.AddItem(MakeEntry(control));
  if (isEntered && value != text.data())
  {
    this->Requests.Set(
      control.Name, *text.data() ? std::optional<std::string>(text.data()) : std::nullopt, false);
  }
}
