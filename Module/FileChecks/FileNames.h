// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   names of files that are read
 */
#ifndef FileNames_h
#define FileNames_h

#include <string>

/// The name's extension in lower case with its dot, or an empty string.
std::string GetExtension(const std::string& fileName);

/// Why the file cannot be read, or an empty string.
std::string FindReadError(const std::string& fileName);

#endif
