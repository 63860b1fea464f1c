// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the help that relevo-view prints, and that its window shows
 */
#ifndef ViewerUsage_h
#define ViewerUsage_h

#include <string>

/// The text of --help.
std::string GetUsage();

/// What mouse and keys do in the window, a line for each.
const char* GetWindowUsage();

#endif
