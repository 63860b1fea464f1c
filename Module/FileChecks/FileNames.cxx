// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FileNames.h"

#include <vtksys/SystemTools.hxx>

#include <filesystem>
#include <fstream>

//------------------------------------------------------------------------------
std::string FindReadError(const std::string& fileName)
{
  // Opening a pipe would block, and a device may never end.
  std::error_code unknown;
  const auto status = std::filesystem::status(fileName, unknown);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    return std::filesystem::is_directory(status) ? "it is a folder" : "it is not a regular file";
  }
  std::ifstream file(fileName);
  return !file
    ? (std::filesystem::exists(status) ? "it cannot be opened" : "the file does not exist")
    : file.peek() == std::ifstream::traits_type::eof() ? "the file is empty"
                                                       : "";
}

//------------------------------------------------------------------------------
std::string GetExtension(const std::string& fileName)
{
  return vtksys::SystemTools::LowerCase(std::filesystem::path(fileName).extension().string());
}
