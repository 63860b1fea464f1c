// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Folders and files written by tests.
#ifndef RelevoFiles_h
#define RelevoFiles_h

#include <string>

/// Creates an empty folder with this name in the test's output folder (-T).
std::string RelevoMakeFolder(int argc, char* argv[], const std::string& name);
void RelevoMakeFolder(const std::string& name);

std::string RelevoReadFile(const std::string& name);
void RelevoWriteFile(const std::string& name, const std::string& text);
void RelevoRemoveFile(const std::string& name);

#endif
