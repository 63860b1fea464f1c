// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LayoutList
 * @brief   where the controls of the last pass are in the window, for scripts and tests
 */
#ifndef LayoutList_h
#define LayoutList_h

#include "Controls/Control.h"

#include <string>
#include <vector>

struct LayoutEntry
{
  std::string Name;
  std::string Kind;
  std::string Value;
  std::string Default;
  std::string Unit;
  bool HasRange = false;
  double Range[2] = { 0.0, 0.0 };
  bool IsEnabled = true;
  std::string Reason;    // why it is not
  bool IsVisible = true; // whether it is in the visible part of the panel
  bool IsFocused = false;
  double Rectangle[4] = { 0.0, 0.0, 0.0, 0.0 }; // x, y, width, height in pixels
};

class LayoutList
{
public:
  /// Starts a pass. It scrolls to an item of this name, if there is one.
  void Start(const std::string& revealed);
  void Add(const LayoutEntry& entry) { this->Entries.push_back(entry); }
  /// Adds the last item of ImGui.
  void AddItem(LayoutEntry entry);
  const std::vector<LayoutEntry>& Get() const { return this->Entries; }
  /// nullptr if there is none.
  const LayoutEntry* Find(const std::string& name) const;

private:
  std::vector<LayoutEntry> Entries;
  std::string Revealed;
};

/// The entry of a control, without its place.
LayoutEntry MakeEntry(const Control& control);

#endif
