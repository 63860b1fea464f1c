// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatternFiles.h"

#include "vtkNew.h"
#include "vtkRefinementPatternTable.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace RelevoPatternFiles
{
bool WriteShifted(const std::string& fileName, int level)
{
  vtkNew<vtkRefinementPatternTable> table;
  table->SetMaximumLevel(level);
  if (!table->Write(fileName.c_str()))
  {
    return false;
  }
  std::ifstream file(fileName, std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  file.close();

  // The format is described at vtkRefinementPatternTable::Write().
  std::size_t place = 20;
  const auto read = [&]
  {
    std::uint32_t value;
    std::memcpy(&value, &bytes[place], sizeof(value));
    place += sizeof(value);
    return value;
  };
  const auto add = [&](float amount)
  {
    float value;
    std::memcpy(&value, &bytes[place], sizeof(value));
    value += amount;
    std::memcpy(&bytes[place], &value, sizeof(value));
    place += sizeof(value);
  };
  for (int pattern = 0; pattern < table->GetNumberOfPatterns(); ++pattern)
  {
    std::uint32_t border = read();
    border += read();
    border += read();
    const std::uint32_t vertices = read();
    const std::uint32_t triangles = read();
    place += 12 * static_cast<std::size_t>(border);
    for (std::uint32_t vertex = border; vertex < vertices; ++vertex)
    {
      add(0.0f);
      add(Shift);
      add(-Shift);
    }
    place += 12 * static_cast<std::size_t>(triangles);
  }
  std::ofstream(fileName, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return place == bytes.size();
}
}
