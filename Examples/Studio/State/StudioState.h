// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StudioState
 * @brief   the values that the user wants, with undo and redo
 */
#ifndef StudioState_h
#define StudioState_h

#include "State/OptionValues.h"

#include <optional>
#include <string>
#include <vector>

class StudioState
{
public:
  explicit StudioState(const OptionValues& values);

  const OptionValues& Get() const { return this->Values; }
  /// Changes with each change of the values.
  int GetVersion() const { return this->Version; }

  /// Sets an option, or removes it, as OptionValues::Choose(). A change that continues the last
  /// one, such as the next value of a drag, is undone together with it. Throws UsageError without a
  /// change.
  void Set(
    const std::string& name, const std::optional<std::string>& value, bool isContinued = false);

  /// Replaces all values and the file.
  void Replace(const OptionValues& values);

  /// Replaces all values without an entry for undo, for example by those that are still drawn.
  void Restore(const OptionValues& values);

  bool CanUndo() const { return !this->Past.empty(); }
  bool CanRedo() const { return !this->Future.empty(); }
  void Undo();
  void Redo();

private:
  void Move(std::vector<OptionValues>& from, std::vector<OptionValues>& to);

  OptionValues Values;
  std::vector<OptionValues> Past;
  std::vector<OptionValues> Future;
  std::string LastName; // of the last change, if it can be continued
  int Version = 0;
};

#endif
