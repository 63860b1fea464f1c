// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the program writes to stderr, apart from what libraries write there
 */
#ifndef StandardError_h
#define StandardError_h

#include <cstddef>
#include <string>

/// Writes a line `relevo-view: KIND: TEXT`, whatever characters the text has.
void WriteMessage(const std::string& kind, const std::string& text);

/// Writes the text as it is. A signal handler may call this.
void WriteToStandardError(const char* text, std::size_t length);

/**
 * Libraries write to stderr what the program's own message says better: libpng, HDF5, the C library
 * before it aborts. While an object of this class exists, only the functions above reach stderr.
 */
class StandardErrorMute
{
public:
  StandardErrorMute();
  ~StandardErrorMute();
  StandardErrorMute(const StandardErrorMute&) = delete;
  void operator=(const StandardErrorMute&) = delete;
};

#endif
