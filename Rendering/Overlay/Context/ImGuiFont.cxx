// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Context/ImGuiFont.h"

#include <imgui.h>

#include <vtksys/SystemTools.hxx>

namespace relevo
{
bool ImGuiFont::Apply(double scale)
{
  if (this->FileName == this->UsedFileName && this->Size == this->UsedSize &&
    scale == this->UsedScale)
  {
    return true;
  }
  this->UsedFileName = this->FileName;
  this->UsedSize = this->Size;
  this->UsedScale = scale;
  ++this->Version;

  ImGuiStyle style;
  style.ScaleAllSizes(static_cast<float>(scale));
  ImGui::GetStyle() = style;
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  atlas->Clear();
  const float pixels = static_cast<float>(this->Size * scale);
  bool hasFile = false;
  // ImGui asserts that the file exists.
  if (!this->FileName.empty() && vtksys::SystemTools::FileExists(this->FileName, true))
  {
    hasFile = atlas->AddFontFromFileTTF(this->FileName.c_str(), pixels) != nullptr;
    hasFile = hasFile && atlas->Build();
  }
  if (!hasFile)
  {
    atlas->Clear();
    ImFontConfig config;
    config.SizePixels = pixels;
    atlas->AddFontDefault(&config);
    atlas->Build();
  }
  return hasFile || this->FileName.empty();
}
}
