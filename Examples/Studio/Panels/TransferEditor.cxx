// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/TransferEditor.h"

#include "Controls/ControlNumbers.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace
{
const double Gap = 1e-6; // between nodes, as a share of the range

std::string WriteNodes(const std::vector<TransferNode>& nodes)
{
  std::string text;
  for (const TransferNode& node : nodes)
  {
    std::string line =
      WriteNumbers({ node.Value, node.Color[0], node.Color[1], node.Color[2], node.Opacity });
    std::replace(line.begin(), line.end(), ',', ' ');
    text += (text.empty() ? "" : ";") + line;
  }
  return nodes.size() == 1 ? text + ";" : text;
}

LayoutEntry MakePart(const std::string& name, const std::string& kind, const std::string& value)
{
  LayoutEntry entry;
  entry.Name = name;
  entry.Kind = kind;
  entry.Value = value;
  return entry;
}
}

//------------------------------------------------------------------------------
void TransferEditor::Send(PanelRequests& requests, bool isContinued)
{
  requests.Set("transfer", WriteNodes(this->Nodes), isContinued);
}

//------------------------------------------------------------------------------
void TransferEditor::Draw(
  const Control& control, const SceneContent& content, LayoutList& layout, PanelRequests& requests)
{
  if (!control.IsEnabled || content.Transfer.empty() || !content.Range)
  {
    return;
  }
  this->Nodes = content.Transfer;
  for (TransferNode& node : this->Nodes)
  {
    node.Opacity = std::clamp(node.Opacity, 0.0, 1.0);
  }
  this->Chosen = std::min(this->Chosen, this->Nodes.size() - 1);
  this->Range[0] = std::min((*content.Range)[0], this->Nodes.front().Value);
  this->Range[1] = std::max((*content.Range)[1], this->Nodes.back().Value);
  if (!(this->Range[1] > this->Range[0]))
  {
    return;
  }
  ImGui::PushID("transfer-editor");
  this->DrawCurve(content, layout, requests);
  this->DrawNode(layout, requests);
  ImGui::PopID();
}

//------------------------------------------------------------------------------
void TransferEditor::DrawCurve(
  const SceneContent& content, LayoutList& layout, PanelRequests& requests)
{
  const float font = ImGui::GetFontSize();
  const ImVec2 size(font * 20.0f, font * 6.0f);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double extent = this->Range[1] - this->Range[0];
  const auto place = [&](double value, double opacity)
  {
    return ImVec2(corner.x + static_cast<float>((value - this->Range[0]) / extent) * size.x,
      corner.y + static_cast<float>(1.0 - opacity) * size.y);
  };
  list->AddRectFilled(
    corner, ImVec2(corner.x + size.x, corner.y + size.y), IM_COL32(24, 26, 30, 255));
  const std::vector<double>& counts = content.Counts;
  const double most = counts.empty() ? 0.0 : *std::max_element(counts.begin(), counts.end());
  for (std::size_t bin = 0; most > 0.0 && bin < counts.size(); ++bin)
  {
    const auto value = [&](std::size_t i)
    {
      return (*content.Range)[0] +
        ((*content.Range)[1] - (*content.Range)[0]) * static_cast<double>(i) /
        static_cast<double>(counts.size());
    };
    list->AddRectFilled(place(value(bin), std::sqrt(counts[bin] / most)),
      place(value(bin + 1), 0.0), IM_COL32(90, 96, 110, 255));
  }
  for (std::size_t i = 1; i < this->Nodes.size(); ++i)
  {
    list->AddLine(place(this->Nodes[i - 1].Value, this->Nodes[i - 1].Opacity),
      place(this->Nodes[i].Value, this->Nodes[i].Opacity), IM_COL32(230, 230, 230, 255), 1.5f);
  }
  const float radius = 0.4f * font;
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    TransferNode& node = this->Nodes[i];
    const ImVec2 centre = place(node.Value, node.Opacity);
    ImGui::SetCursorScreenPos(ImVec2(centre.x - radius, centre.y - radius));
    ImGui::PushID(static_cast<int>(i));
    ImGui::InvisibleButton("node", ImVec2(2.0f * radius, 2.0f * radius));
    layout.AddItem(MakePart(
      "transfer." + std::to_string(i), "node", WriteNumbers({ node.Value, node.Opacity })));
    if (ImGui::IsItemActivated())
    {
      this->Chosen = i;
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0f))
    {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      const double first = i == 0 ? this->Range[0] : this->Nodes[i - 1].Value + Gap * extent;
      const double last =
        i + 1 == this->Nodes.size() ? this->Range[1] : this->Nodes[i + 1].Value - Gap * extent;
      const double value =
        std::clamp(this->Range[0] + static_cast<double>((mouse.x - corner.x) / size.x) * extent,
          first, std::max(first, last));
      const double opacity =
        std::clamp(1.0 - static_cast<double>((mouse.y - corner.y) / size.y), 0.0, 1.0);
      if (value != node.Value || opacity != node.Opacity)
      {
        node.Value = value;
        node.Opacity = opacity;
        this->Send(requests, !ImGui::IsItemActivated());
      }
    }
    ImGui::PopID();
    list->AddCircleFilled(centre, radius,
      ImGui::ColorConvertFloat4ToU32(ImVec4(static_cast<float>(node.Color[0]),
        static_cast<float>(node.Color[1]), static_cast<float>(node.Color[2]), 1.0f)));
    list->AddCircle(centre, radius,
      i == this->Chosen ? IM_COL32(255, 200, 60, 255) : IM_COL32(230, 230, 230, 255), 0, 1.5f);
  }
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y + radius));
  ImGui::Dummy(ImVec2(size.x, 1.0f));
}

//------------------------------------------------------------------------------
void TransferEditor::DrawNode(LayoutList& layout, PanelRequests& requests)
{
  TransferNode& node = this->Nodes[this->Chosen];
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13.0f);
  double opacity = node.Opacity;
  const double lowest = 0.0;
  const double highest = 1.0;
  const bool isMoved = ImGui::SliderScalar("opacity of the node", ImGuiDataType_Double, &opacity,
    &lowest, &highest, "%.4g", ImGuiSliderFlags_NoRoundToFormat);
  const bool isContinued = !ImGui::IsItemActivated();
  layout.AddItem(MakePart("transfer-opacity", "number", WriteNumbers({ node.Opacity })));
  if (isMoved && opacity != node.Opacity)
  {
    node.Opacity = std::clamp(opacity, 0.0, 1.0);
    this->Send(requests, isContinued);
  }
  float color[3] = { static_cast<float>(node.Color[0]), static_cast<float>(node.Color[1]),
    static_cast<float>(node.Color[2]) };
  const bool isColored =
    ImGui::ColorEdit3("colour of the node", color, ImGuiColorEditFlags_NoInputs);
  layout.AddItem(MakePart("transfer-color", "color", ""));
  if (isColored)
  {
    std::copy(color, color + 3, node.Color.begin());
    this->Send(requests, true);
  }
  if (ImGui::Button("next node"))
  {
    this->Chosen = (this->Chosen + 1) % this->Nodes.size();
  }
  layout.AddItem(MakePart("transfer-next", "button", ""));
  ImGui::SameLine();
  if (ImGui::Button("add"))
  {
    // In the middle between this node and the next one.
    const std::size_t first =
      std::min(this->Chosen, this->Nodes.size() < 2 ? 0 : this->Nodes.size() - 2);
    TransferNode added = this->Nodes[first];
    const TransferNode& next = this->Nodes[std::min(first + 1, this->Nodes.size() - 1)];
    const bool isLast = this->Nodes.size() < 2;
    added.Value = isLast ? 0.5 * (added.Value + this->Range[1]) : 0.5 * (added.Value + next.Value);
    added.Opacity = 0.5 * (added.Opacity + next.Opacity);
    for (int i = 0; i < 3; ++i)
    {
      added.Color[i] = 0.5 * (added.Color[i] + next.Color[i]);
    }
    if (added.Value > this->Nodes[first].Value && (isLast || added.Value < next.Value))
    {
      this->Nodes.insert(this->Nodes.begin() + static_cast<std::ptrdiff_t>(first) + 1, added);
      this->Chosen = first + 1;
      this->Send(requests, false);
    }
  }
  layout.AddItem(MakePart("transfer-add", "button", ""));
  ImGui::SameLine();
  ImGui::BeginDisabled(this->Nodes.size() < 2);
  if (ImGui::Button("remove"))
  {
    this->Nodes.erase(this->Nodes.begin() + static_cast<std::ptrdiff_t>(this->Chosen));
    this->Send(requests, false);
  }
  layout.AddItem(MakePart("transfer-remove", "button", ""));
  ImGui::EndDisabled();
}
