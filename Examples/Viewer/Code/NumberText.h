// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   numbers and texts in generated programs, which Python and C++ write alike
 */
#ifndef NumberText_h
#define NumberText_h

#include <string>

/// As few digits as the number needs, with a decimal point.
std::string WriteNumber(double number);

/// A text in quotation marks. Control characters are escaped.
std::string Quote(const std::string& text);

/// Lines of at most 100 columns with this start.
std::string WrapComment(const std::string& text, const std::string& start);

#endif
