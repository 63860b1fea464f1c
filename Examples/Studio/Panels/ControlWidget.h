// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ControlWidget
 * @brief   draws one control by ImGui
 */
#ifndef ControlWidget_h
#define ControlWidget_h

#include "Controls/Control.h"
#include "Panels/LayoutList.h"
#include "Panels/PanelRequests.h"
#include "Scene/SceneContent.h"

#include <string>

class ControlWidget
{
public:
  ControlWidget(LayoutList& layout, PanelRequests& requests, const SceneContent& content);

  /// Draws a control in the current window of ImGui, with its name and a button for the default.
  void Draw(const Control& control);

private:
  void DrawChoice(const Control& control);
  void DrawFlag(const Control& control);
  void DrawNumbers(const Control& control);
  void DrawStep(const Control& control);
  void DrawPlane(const Control& control);
  void DrawColor(const Control& control);
  void DrawText(const Control& control, float width);
  void DrawDefault(const Control& control);
  void DrawTip(const Control& control);
  /// Adds the last item, and sends its value if it has changed.
  void Finish(const LayoutEntry& entry, bool isChanged, const std::string& value);

  LayoutList& Layout;
  PanelRequests& Requests;
  const SceneContent& Content;
};

#endif
