// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the introduction of a generated program
 */
#ifndef ProgramText_h
#define ProgramText_h

#include <string>

struct ProgramText
{
  std::string Name;    // of the program, without extension
  std::string Input;   // the file that it draws
  std::string Command; // that draws the same picture
};

#endif
