// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OptionValues
 * @brief   a file and the options that it is drawn with, as on relevo-view's command line
 */
#ifndef OptionValues_h
#define OptionValues_h

#include "Options/OptionCopy.h"
#include "Options/ViewerOptions.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class OptionValues
{
public:
  /// Takes the arguments of relevo-view. Throws UsageError.
  explicit OptionValues(const std::vector<std::string>& arguments);

  /// The value of an option, named without --. A flag has the value "on".
  std::optional<std::string> Get(const std::string& name) const;
  /// Sets an option, or removes it.
  void Set(const std::string& name, const std::optional<std::string>& value);

  /// Sets or removes an option. If it chooses between a surface and a volume, this also removes the
  /// options that suit only the other one.
  void Choose(const std::string& name, const std::optional<std::string>& value);

  /// Checks all values together. Throws UsageError.
  ViewerOptions Parse() const;

  /// The options, with --, whose values differ.
  OptionNames Compare(const OptionValues& other) const;

  bool operator==(const OptionValues& other) const
  {
    return this->Input == other.Input && this->Values == other.Values;
  }
  const std::map<std::string, std::string>& GetAll() const { return this->Values; }
  const std::string& GetInput() const { return this->Input; }

private:
  bool IsValid() const;
  std::vector<std::string> GetArguments() const;

  std::string Input;
  std::map<std::string, std::string> Values; // by names without --
};

/// Throws UsageError if there is an option that only relevo-view has.
void CheckForStudio(const OptionValues& values);

/// Whether an option has no value.
bool IsFlag(const std::string& name);

#endif
