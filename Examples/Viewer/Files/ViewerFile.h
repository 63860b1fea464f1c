// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   checks the names of files before they are read or written
 */
#ifndef ViewerFile_h
#define ViewerFile_h

#include "FileNames.h"

#include <string>

/// Throws ViewerError if the file is missing or empty. VTK's readers report this differently.
void CheckFile(const std::string& fileName);

/// Whether the file can be read and is not empty.
bool CanRead(const std::string& fileName);

/// Throws ViewerError if a file can be neither created nor replaced, before long work is done in
/// vain. Creates no file.
void CheckOutput(const std::string& fileName);

/// In a handler of exceptions, throws the current one as a ViewerError that names the file.
[[noreturn]] void ThrowReadingError(const std::string& fileName);

#endif
