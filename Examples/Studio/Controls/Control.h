// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   a control of the panel: an option of relevo-view, or an action
 */
#ifndef Control_h
#define Control_h

#include <array>
#include <optional>
#include <string>
#include <vector>

enum class ControlKind
{
  Choice,   // one of several words
  Flag,     // on or off
  Number,   // one or more numbers, separated by commas
  Color,    // red, green and blue
  Integer,  // a whole number
  Step,     // a time step
  Plane,    // a cut plane
  Transfer, // a transfer function
  Text,     // for example a file name
  Button    // an action
};

struct Control
{
  std::string Name; // of the option, without --, or of the action
  std::string Group;
  ControlKind Kind = ControlKind::Button;
  std::string Unit;
  std::string Default; // in words
  std::vector<std::string> Choices = {};
  // The ends of the sliders: one pair for all numbers, or one for each.
  std::vector<std::array<double, 2>> Ranges = { { { 0.0, 1.0 } } };
  bool IsLogarithmic = false;
  bool IsIncreasing = false;      // whether each number is less than the next one
  std::vector<double> Start = {}; // where sliders start without a value
  bool IsStartShown = true;       // whether these are the numbers in use

  // These depend on the file and the other options.
  std::optional<std::string> Value = {}; // nothing for the default
  std::vector<double> Current = {};      // the numbers in use, if the scene knows them
  bool IsEnabled = true;
  std::string Reason = {}; // why it is not
};

#endif
