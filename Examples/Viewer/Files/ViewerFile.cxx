// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerFile.h"

#include "Text/ViewerMessages.h"

#include <vtksys/SystemTools.hxx>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace
{
// Why there is nothing to read, "" where there is.
std::string GetInputError(const std::string& fileName)
{
  // A pipe would block when it is opened; a device may never end.
  std::error_code unknown;
  const auto status = std::filesystem::status(fileName, unknown);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    return std::filesystem::is_directory(status) ? "it is a folder" : "it is not a regular file";
  }
  std::ifstream file(fileName);
  return !file ? "the file does not exist or is not readable"
    : file.peek() == std::ifstream::traits_type::eof() ? "the file is empty"
                                                       : "";
}

// Why a file can neither be made nor replaced, "" where it can.
std::string GetOutputError(const std::filesystem::path& file)
{
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code unknown;
  if (!std::filesystem::is_directory(folder, unknown))
  {
    return "there is no folder " + folder.string();
  }
  if (std::filesystem::is_directory(file, unknown))
  {
    return "it is a folder";
  }
  const bool canWrite = access(file.c_str(), W_OK) == 0 ||
    (errno == ENOENT && access(folder.c_str(), W_OK | X_OK) == 0);
  return canWrite ? "" : std::generic_category().message(errno);
}
}

//------------------------------------------------------------------------------
std::string GetExtension(const std::string& fileName)
{
  return vtksys::SystemTools::LowerCase(std::filesystem::path(fileName).extension().string());
}

//------------------------------------------------------------------------------
void CheckFile(const std::string& fileName)
{
  const std::string error = GetInputError(fileName);
  if (!error.empty())
  {
    throw ViewerError("cannot read " + fileName + ": " + error);
  }
}

//------------------------------------------------------------------------------
bool CanRead(const std::string& fileName)
{
  return GetInputError(fileName).empty();
}

//------------------------------------------------------------------------------
void CheckOutput(const std::string& fileName)
{
  const std::string error = GetOutputError(fileName);
  if (!error.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + error);
  }
}
