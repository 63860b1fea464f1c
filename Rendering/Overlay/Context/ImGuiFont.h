// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ImGuiFont
 * @brief   the font and the sizes of an ImGui context
 */
#ifndef ImGuiFont_h
#define ImGuiFont_h

#include <string>

namespace relevo
{
class ImGuiFont
{
public:
  /// A file name, or an empty string for ImGui's own font.
  std::string FileName;
  double Size = 13.0; // pixels at the scale 1

  /**
   * Rebuild the fonts and the style of the current context if the settings or the scale have
   * changed. Return false if the file cannot be read; ImGui's own font is then used.
   */
  bool Apply(double scale);

  /// Return a number that changes with the pixels of the atlas.
  int GetVersion() const { return this->Version; }

  double GetScale() const { return this->UsedScale; }

private:
  std::string UsedFileName;
  double UsedSize = 0.0;
  double UsedScale = 0.0;
  int Version = 0;
};
}

#endif
