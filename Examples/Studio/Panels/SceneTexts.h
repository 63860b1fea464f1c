// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   texts over the scene: values under the mouse, a mark and the keys
 */
#ifndef SceneTexts_h
#define SceneTexts_h

#include "Panels/LayoutList.h"

#include <array>
#include <optional>
#include <string>

struct SceneTexts
{
  std::string Readout; // "" for none
  // In pixels from the lower left corner.
  std::optional<std::array<double, 2>> Mark;
  std::string Keys; // "" while they are hidden
  int SceneWidth;   // of the part of the window with the scene, in pixels
};

/// Draws the texts by ImGui and adds them to the layout.
void DrawSceneTexts(const SceneTexts& texts, LayoutList& layout);

#endif
