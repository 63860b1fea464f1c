// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   separates the program's output on stderr from that of libraries
 */
#ifndef StandardError_h
#define StandardError_h

#include <cstddef>
#include <string>

/// Sets the name that messages begin with, instead of relevo-view.
void SetProgramName(const std::string& name);
const std::string& GetProgramName();

/// Writes a line `relevo-view: KIND: TEXT`. All characters of the text are made printable.
void WriteMessage(const std::string& kind, const std::string& text);

/// Writes the text unchanged. A signal handler may call this.
void WriteToStandardError(const char* text, std::size_t length);

/**
 * Suppresses what libraries write to stderr (libpng, HDF5, the C library before it aborts), because
 * the program's messages are better. While an object of this class exists, only the functions above
 * write to stderr.
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
