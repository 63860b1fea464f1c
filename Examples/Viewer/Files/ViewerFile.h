// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what kind of file a name means, and whether it can be read or written at all
 */
#ifndef ViewerFile_h
#define ViewerFile_h

#include <string>

/// The name's extension with its dot, in lower case; empty when there is none.
std::string GetExtension(const std::string& fileName);

/// Why there is nothing to read, "" where there is.
std::string FindReadError(const std::string& fileName);

/// VTK's readers differ in what they say of a file that is not there or has nothing in it: this
/// throws ViewerError.
void CheckFile(const std::string& fileName);

/// Whether there is something in it.
bool CanRead(const std::string& fileName);

/// Nor does anyone want to wait for what cannot be written: throws ViewerError where a file can
/// neither be made nor replaced. Makes none.
void CheckOutput(const std::string& fileName);

#endif
