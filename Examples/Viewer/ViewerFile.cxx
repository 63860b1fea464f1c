// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerFile.h"

#include "ViewerMessages.h"

#include <filesystem>
#include <fstream>

//------------------------------------------------------------------------------
void CheckFile(const std::string& fileName)
{
  std::ifstream file(fileName);
  const char* reason = !file                  ? "the file does not exist or is not readable"
    : std::filesystem::is_directory(fileName) ? "it is a folder"
    : file.peek() == std::ifstream::traits_type::eof() ? "the file is empty"
                                                       : nullptr;
  if (reason)
  {
    throw ViewerError("cannot read " + fileName + ": " + reason);
  }
}
