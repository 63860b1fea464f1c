// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PanelRequests
 * @brief   takes the changes that the user makes in the panel
 */
#ifndef PanelRequests_h
#define PanelRequests_h

#include <optional>
#include <string>

class PanelRequests
{
public:
  virtual ~PanelRequests() = default;
  /// Sets a control, or returns it to its default. A continued change belongs to the last one.
  virtual void Set(
    const std::string& name, const std::optional<std::string>& value, bool isContinued) = 0;
  /// Presses a button.
  virtual void Press(const std::string& name) = 0;
};

#endif
