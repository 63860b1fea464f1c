// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WriteFile.h"

#include <algorithm>
#include <fstream>

namespace relevo
{
namespace
{
// White space may follow the ending.
bool EndsWith(const std::string& fileName, const std::string& ending)
{
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? std::streamoff(file.tellg()) : 0;
  const std::streamoff count = std::min<std::streamoff>(size, 64);
  std::string bytes(static_cast<std::size_t>(count), '\0');
  file.seekg(size - count);
  file.read(bytes.data(), count);
  bytes.resize(bytes.find_last_not_of(" \r\n") + 1);
  return file && bytes.size() >= ending.size() &&
    bytes.compare(bytes.size() - ending.size(), ending.size(), ending) == 0;
}
}

bool IsWholeXML(const std::string& fileName)
{
  return EndsWith(fileName, "</VTKFile>");
}

std::string GetWriterError(const std::string& errors, const AtomicFile& file)
{
  const std::string heading =
    "): "; // the format is ERROR: In FILE, line N, CLASS (ADDRESS): MESSAGE
  const std::size_t begin = errors.find(heading);
  std::string error = begin == std::string::npos ? errors : errors.substr(begin + heading.size());
  error.resize(std::min(error.find('\n'), error.size()));
  const std::string& temporary = file.GetTemporaryName();
  for (std::size_t place; (place = error.find(temporary)) != std::string::npos;)
  {
    error.replace(place, temporary.size(), file.GetFileName());
  }
  return error;
}
}
