// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   makes text from files safe to print in a terminal
 */
#ifndef PrintableText_h
#define PrintableText_h

#include <string>

/**
 * Escapes line ends (`
 * `), other control characters and bytes that are not UTF-8 (`\x1b`), and Unicode characters that
 * break lines or reverse their direction (`\u202e`). The result is one line without terminal
 * commands. Other text is unchanged.
 */
std::string ToPrintable(const std::string& text);

#endif
