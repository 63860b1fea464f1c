// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Plot3DFile.h"

#include "Files/AlgorithmReader.h"

#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace
{
const std::uint32_t MostBlocks = 10000;
const std::uint32_t LargestDimension = 100000;

class Header
{
public:
  explicit Header(const std::string& fileName)
    : Size(vtksys::SystemTools::FileLength(fileName))
    , Bytes(4 * (3 * MostBlocks + 8))
  {
    std::ifstream file(fileName, std::ios::binary);
    file.read(this->Bytes.data(), static_cast<std::streamsize>(this->Bytes.size()));
    this->Bytes.resize(static_cast<std::size_t>(file.gcount()));
  }

  bool IsOfGrid() const
  {
    for (bool isBig : { false, true })
    {
      for (bool hasMarkers : { false, true })
      {
        for (bool hasBlocks : { false, true })
        {
          if (this->Fits(isBig, hasMarkers, hasBlocks))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  // The integer at an index, or 0 beyond the end.
  std::uint32_t Get(std::size_t index, bool isBig) const
  {
    if (4 * index + 4 > this->Bytes.size())
    {
      return 0;
    }
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const auto byte = static_cast<unsigned char>(this->Bytes[4 * index + (isBig ? i : 3 - i)]);
      value = (value << 8) | byte;
    }
    return value;
  }

  bool Fits(bool isBig, bool hasMarkers, bool hasBlocks) const
  {
    std::size_t place = hasMarkers ? 1 : 0;
    std::uint32_t blocks = 1;
    if (hasBlocks)
    {
      blocks = this->Get(place, isBig);
      place += hasMarkers ? 3 : 1;
    }
    if (blocks < 1 || blocks > MostBlocks)
    {
      return false;
    }
    std::uint64_t points = 0;
    for (std::uint32_t i = 0; i < 3 * blocks; i += 3)
    {
      std::uint64_t number = 1;
      for (std::uint32_t axis = 0; axis < 3; ++axis)
      {
        const std::uint32_t dimension = this->Get(place + i + axis, isBig);
        if (dimension < 1 || dimension > LargestDimension)
        {
          return false;
        }
        number *= dimension;
      }
      points += number;
    }
    const std::uint64_t markers = hasMarkers ? 8u * (blocks + 1u + (hasBlocks ? 1u : 0u)) : 0u;
    const std::uint64_t head = 12u * blocks + (hasBlocks ? 4u : 0u) + markers;
    for (std::uint64_t bytes : { 12u, 16u, 24u, 28u }) // of a point: floats or doubles, and blanks
    {
      if (points > 1 && head + bytes * points == this->Size)
      {
        return true;
      }
    }
    return false;
  }

  std::uint64_t Size;
  std::vector<char> Bytes;
};

// Returns the name of the solution if the file exists, or "".
std::string FindSolution(const std::string& fileName)
{
  const std::array<std::array<const char*, 2>, 3> ends = { { { { "xyz.bin", "q.bin" } },
    { { ".xyz", ".q" } }, { { ".x", ".q" } } } };
  for (const auto& end : ends)
  {
    const std::string own = end[0];
    if (fileName.size() > own.size() &&
      fileName.compare(fileName.size() - own.size(), own.size(), own) == 0)
    {
      const std::string name = fileName.substr(0, fileName.size() - own.size()) + end[1];
      return vtksys::SystemTools::FileExists(name, true) ? name : "";
    }
  }
  return "";
}
}

//------------------------------------------------------------------------------
bool IsPlot3D(const std::string& fileName)
{
  return vtksys::SystemTools::FileExists(fileName, true) && Header(fileName).IsOfGrid();
}

//------------------------------------------------------------------------------
std::unique_ptr<ResultReader> OpenPlot3D(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->AutoDetectFormatOn();
  reader->SetFileName(fileName.c_str());
  const std::string solution = FindSolution(fileName);
  if (!solution.empty())
  {
    const int pressure = 110;
    const int temperature = 120;
    const int velocity = 200;
    reader->SetQFileName(solution.c_str());
    reader->AddFunction(pressure);
    reader->AddFunction(temperature);
    reader->AddFunction(velocity);
  }
  return std::make_unique<AlgorithmReader>(reader, messages);
}
