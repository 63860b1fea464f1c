// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ControlList
 * @brief   the controls for a file and the options in use
 */
#ifndef ControlList_h
#define ControlList_h

#include "Controls/Control.h"
#include "Scene/SceneContent.h"

#include <array>
#include <map>
#include <string>
#include <vector>

class OptionValues;
class StudioState;

class ControlList
{
public:
  ControlList();

  /// Whether the panel shows the values of a point that was clicked.
  void SetHasProbe(bool hasProbe) { this->HasProbe = hasProbe; }

  /// Updates values, choices and whether the controls apply.
  void Update(const StudioState& state, const SceneContent& content);

  const std::vector<Control>& Get() const { return this->Controls; }
  /// nullptr for an unknown name.
  const Control* Find(const std::string& name) const;

  /// The values of controls that are no options: flags and texts of the program.
  std::string GetOwn(const std::string& name) const;
  void SetOwn(const std::string& name, const std::string& value);
  /// Whether the controls ask for a second view.
  bool IsComparing() const;
  /// Whether a control is an option of relevo-view.
  static bool IsOption(const Control& control);

private:
  void UpdateOwn(Control& control, const StudioState& state, const SceneContent& content);
  void FindChoices(Control& control, const SceneContent& content) const;
  void FindRange(Control& control, const SceneContent& content) const;
  void FindReason(Control& control, const OptionValues& values, const SceneContent& content) const;

  std::vector<Control> Controls;
  std::map<std::string, std::string> Own;
  bool HasProbe = false;
  // Of the values and of the content that the reasons and choices are for.
  std::array<int, 2> Versions = { { -1, -1 } };
};

#endif
