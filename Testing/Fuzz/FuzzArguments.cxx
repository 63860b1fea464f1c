// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Command lines of relevo-view. Arguments are separated by line ends.
#include "Options/OptionParser.h"
#include "Options/UsageError.h"

#include <sstream>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  std::vector<std::string> arguments = { "relevo-view" };
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes), size));
  for (std::string line; std::getline(text, line);)
  {
    arguments.push_back(line.substr(0, line.find('\0')));
  }
  std::vector<char*> pointers;
  for (std::string& argument : arguments)
  {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  try
  {
    ParseOptions(static_cast<int>(arguments.size()), pointers.data());
  }
  catch (const UsageError&)
  {
    return 0; // the only exception of invalid command lines
  }
  return 0;
}
