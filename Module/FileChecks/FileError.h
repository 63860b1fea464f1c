// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileError_h
#define FileError_h

#include <stdexcept>

/// Invalid input or output. The text is the cause.
struct FileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

#endif
