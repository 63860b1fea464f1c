// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/PatternDrawing.h"

#include "State/EdgePattern.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace
{
const std::size_t MostLines = 2048; // triangles; more are too small for outlines
const std::size_t MostPatterns = 20;

bool IsPower(int segments)
{
  return (segments & (segments - 1)) == 0;
}

// The lowest level with at least so many segments.
int FindLevel(int segments)
{
  return static_cast<int>(std::ceil(std::log2(static_cast<double>(segments))));
}

std::map<int, long long> CountLevels(const std::vector<PatternCount>& counts)
{
  std::map<int, long long> triangles;
  for (const PatternCount& count : counts)
  {
    triangles[FindLevel(count.Segments[0])] += count.Triangles;
  }
  return triangles;
}

void DrawBar(const std::string& name, long long number, long long most)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name.c_str());
  ImGui::SameLine(ImGui::GetFontSize() * 6.0f);
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImVec4(0.26f, 0.45f, 0.68f, 1.0f));
  const float share = most > 0 ? static_cast<float>(number) / static_cast<float>(most) : 0.0f;
  ImGui::ProgressBar(
    share, ImVec2(ImGui::GetFontSize() * 16.0f, 0.0f), std::to_string(number).c_str());
  ImGui::PopStyleColor();
}
}

//------------------------------------------------------------------------------
std::string NamePattern(const std::array<int, 3>& segments)
{
  std::array<char, 64> text;
  if (std::all_of(segments.begin(), segments.end(), IsPower))
  {
    std::snprintf(text.data(), text.size(), "[%d, %d, %d]", FindLevel(segments[0]),
      FindLevel(segments[1]), FindLevel(segments[2]));
  }
  else
  {
    std::snprintf(text.data(), text.size(), "%d-%d-%d", segments[0], segments[1], segments[2]);
  }
  return text.data();
}

//------------------------------------------------------------------------------
SceneFigures ListCounts(const std::vector<PatternCount>& counts)
{
  SceneFigures figures;
  for (const auto& level : CountLevels(counts))
  {
    figures.emplace_back(
      "level-" + std::to_string(level.first) + "-triangles", static_cast<double>(level.second));
  }
  for (const PatternCount& count : counts)
  {
    figures.emplace_back("faces-" + std::to_string(count.Segments[0]) + "-" +
        std::to_string(count.Segments[1]) + "-" + std::to_string(count.Segments[2]),
      static_cast<double>(count.Faces));
  }
  return figures;
}

//------------------------------------------------------------------------------
void DrawHistogram(const std::vector<PatternCount>& counts)
{
  if (counts.empty())
  {
    ImGui::TextUnformatted("this scene has no patterns");
    return;
  }
  const std::map<int, long long> levels = CountLevels(counts);
  long long most = 0;
  for (const auto& level : levels)
  {
    most = std::max(most, level.second);
  }
  ImGui::TextUnformatted("triangles of each level");
  for (const auto& level : levels)
  {
    DrawBar("level " + std::to_string(level.first), level.second, most);
  }
  std::vector<PatternCount> sorted = counts;
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const PatternCount& a, const PatternCount& b) { return a.Faces > b.Faces; });
  const std::size_t number = std::min(sorted.size(), MostPatterns);
  const std::string all = std::to_string(sorted.size());
  const std::string shown =
    number < sorted.size() ? "the " + std::to_string(number) + " most frequent of " + all : all;
  ImGui::TextUnformatted(
    ("faces of " + shown + (sorted.size() == 1 ? " pattern" : " patterns")).c_str());
  for (std::size_t i = 0; i < number; ++i)
  {
    DrawBar(NamePattern(sorted[i].Segments), sorted[i].Faces, sorted.front().Faces);
  }
}

//------------------------------------------------------------------------------
void DrawPattern(const EdgePattern& pattern)
{
  const float font = ImGui::GetFontSize();
  const float side = font * 16.0f;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float left = corner.x + font * 2.5f;
  const float bottom = corner.y + font + side * std::sqrt(0.75f);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto place = [&](const PatternPlace& point)
  {
    return ImVec2(
      left + side * static_cast<float>(point[0]), bottom - side * static_cast<float>(point[1]));
  };
  const ImDrawListFlags flags = list->Flags;
  list->Flags &= ~(ImDrawListFlags_AntiAliasedFill | ImDrawListFlags_AntiAliasedLines);
  const bool hasLines = pattern.GetTriangles().size() <= MostLines;
  const std::array<ImU32, 2> shades = { { IM_COL32(70, 110, 160, 255),
    IM_COL32(110, 150, 200, 255) } };
  bool isSecond = false;
  for (const std::array<int, 3>& triangle : pattern.GetTriangles())
  {
    const ImVec2 a = place(pattern.GetPlaces()[triangle[0]]);
    const ImVec2 b = place(pattern.GetPlaces()[triangle[1]]);
    const ImVec2 c = place(pattern.GetPlaces()[triangle[2]]);
    list->AddTriangleFilled(a, b, c, shades[hasLines || isSecond ? 1 : 0]);
    if (hasLines)
    {
      list->AddTriangle(a, b, c, IM_COL32(20, 30, 45, 255));
    }
    isSecond = !isSecond;
  }
  list->Flags = flags;
  const auto label = [&](int edge, const PatternPlace& at, float dx, float dy)
  {
    const ImVec2 point = place(at);
    const std::string text = std::to_string(pattern.GetLevels()[static_cast<std::size_t>(edge)]);
    list->AddText(ImVec2(point.x + dx, point.y + dy), IM_COL32(255, 200, 60, 255), text.c_str());
  };
  label(0, { { 0.5, 0.0 } }, -0.25f * font, 0.1f * font);
  label(1, { { 0.75, std::sqrt(0.1875) } }, 0.4f * font, -0.8f * font);
  label(2, { { 0.25, std::sqrt(0.1875) } }, -0.9f * font, -0.8f * font);
  ImGui::Dummy(ImVec2(side + font * 4.0f, bottom - corner.y + 1.4f * font));
  const std::array<int, 3>& base = pattern.GetBase();
  ImGui::Text("pattern [%d, %d, %d], lambda %d", base[0], base[1], base[2], pattern.GetLambda());
  ImGui::Text("%d triangles, smallest angle %.2f degrees",
    static_cast<int>(pattern.GetTriangles().size()), pattern.GetSmallestAngle());
}
