// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFiles.h"

#include <filesystem>
#include <fstream>
#include <iterator>

std::string RelevoMakeFolder(int argc, char* argv[], const std::string& name)
{
  std::filesystem::path folder = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = argv[i] == std::string("-T") ? argv[i + 1] : folder;
  }
  folder /= name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

void RelevoMakeFolder(const std::string& name)
{
  std::filesystem::create_directories(name);
}

std::string RelevoReadFile(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void RelevoWriteFile(const std::string& name, const std::string& text)
{
  std::ofstream(name, std::ios::binary) << text;
}

void RelevoRemoveFile(const std::string& name)
{
  std::filesystem::remove(name);
}
