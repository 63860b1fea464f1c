// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   runs the studio in a window, or by a script without one
 */
#ifndef StudioWindow_h
#define StudioWindow_h

#include "State/OptionValues.h"

#include <string>

/// Shows the studio until its window is closed. Throws ViewerError.
void ShowStudio(const OptionValues& values, const std::string& layoutFile);

/// Runs a script without a display. Throws ViewerError if the script cannot be read, or if a line
/// failed.
void RunScript(
  const OptionValues& values, const std::string& layoutFile, const std::string& script);

/// Serves the window to browsers until SIGINT or SIGTERM. Throws ViewerError.
void ServeStudio(const OptionValues& values, const std::string& layoutFile, int port);

#endif
