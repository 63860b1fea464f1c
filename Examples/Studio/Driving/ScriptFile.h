// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads scripts that drive the studio
 */
#ifndef ScriptFile_h
#define ScriptFile_h

#include <string>
#include <vector>

struct ScriptLine
{
  int Number; // in the file, from 1
  std::string Command;
  std::string Name;            // of a control, a key or a file, or ""
  std::string Value;           // of set, or ""
  std::vector<double> Numbers; // of drag
};

/// Reads lines: set NAME VALUE, click NAME, drag X0 Y0 X1 Y1, key NAME, wait, save FILE, quit.
/// Empty lines and those after # are ignored. Throws ViewerError with the number of a wrong line.
std::vector<ScriptLine> ReadScript(const std::string& fileName);

#endif
