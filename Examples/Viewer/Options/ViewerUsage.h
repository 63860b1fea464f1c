// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the help texts of relevo-view and of its window
 */
#ifndef ViewerUsage_h
#define ViewerUsage_h

#include <string>

/// The text of --help.
std::string GetUsage();

/// The mouse actions and keys of the window, one per line.
const char* GetWindowUsage();

#endif
