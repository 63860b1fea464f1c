// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   names, values and contents of files as text that a terminal only shows
 */
#ifndef PrintableText_h
#define PrintableText_h

#include <string>

/**
 * Escape line ends (`\n`), other control characters and bytes that are not UTF-8 (`\x1b`), and the
 * characters of Unicode that break lines or reverse their direction (`\u202e`). The result is one
 * line that cannot command a terminal. Other text is not changed.
 */
std::string ToPrintable(const std::string& text);

#endif
