// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/PyramidIndex.h"

#include "Files/AtomicFile.h"
#include "Pyramid/Checksum.h"
#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>

namespace relevo
{
namespace
{
constexpr char Magic[] = "relevo pyramid index 3\n";
constexpr float Infinity = PyramidIndex::Infinity;
constexpr std::size_t MaximumRun = 255;
constexpr int MaximumLevel = 31;

float RoundDown(double value)
{
  const float rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -Infinity) : rounded;
}

float RoundUp(double value)
{
  return -RoundDown(-value);
}

template <typename T>
void Append(std::string& bytes, const T& value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename T>
bool Take(const std::string& bytes, std::size_t& position, T& value)
{
  if (bytes.size() - position < sizeof(value))
  {
    return false;
  }
  std::memcpy(&value, bytes.data() + position, sizeof(value));
  position += sizeof(value);
  return true;
}

// Zeros are stored as a zero and their number: blocks without errors are often neighbors.
template <typename Codes>
void AppendCodes(std::string& bytes, const Codes& codes)
{
  for (std::size_t i = 0; i < codes.size();)
  {
    Append(bytes, codes[i]);
    std::size_t end = i + 1;
    if (codes[i] == 0)
    {
      while (end < codes.size() && codes[end] == 0 && end - i < MaximumRun)
      {
        ++end;
      }
      Append(bytes, static_cast<std::uint8_t>(end - i));
    }
    i = end;
  }
}

template <typename Codes>
bool TakeCodes(const std::string& bytes, std::size_t& position, Codes& codes)
{
  for (std::size_t i = 0; i < codes.size();)
  {
    std::uint8_t number = 1;
    if (!Take(bytes, position, codes[i]) ||
      (codes[i] == 0 && (!Take(bytes, position, number) || number == 0)) ||
      number > codes.size() - i)
    {
      return false;
    }
    std::fill_n(codes.begin() + i, number, codes[i]);
    i += number;
  }
  return true;
}

template <typename Map>
std::vector<std::uint64_t> GetSortedKeys(const Map& map)
{
  std::vector<std::uint64_t> keys;
  for (const auto& entry : map)
  {
    keys.push_back(entry.first);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

int GetNumberOfKinds(int level)
{
  return level == 0 ? 1 : BlockErrors::NumberOfKinds;
}

void AppendErrors(std::string& bytes, const BlockErrors& errors)
{
  Append(bytes, static_cast<std::int32_t>(errors.GetRootLevel()));
  Append(bytes, errors.GetLargest());
  for (int level = 0; level <= errors.GetRootLevel(); ++level)
  {
    const BlockErrors::Tiles& tiles = errors.GetTiles(level);
    Append(bytes, static_cast<std::uint64_t>(tiles.size()));
    for (const std::uint64_t key : GetSortedKeys(tiles))
    {
      const BlockErrors::Tile& tile = tiles.at(key);
      Append(bytes, key);
      for (int kind = 0; kind < GetNumberOfKinds(level); ++kind)
      {
        AppendCodes(bytes, tile[kind]);
      }
    }
  }
}

std::shared_ptr<const BlockErrors> TakeErrors(const std::string& bytes, std::size_t& position)
{
  std::int32_t rootLevel = 0;
  float largest = 0.0f;
  if (!Take(bytes, position, rootLevel) || !Take(bytes, position, largest) || rootLevel < 0 ||
    rootLevel > MaximumLevel || !(largest >= 0.0f))
  {
    return nullptr;
  }
  auto errors = std::make_shared<BlockErrors>(rootLevel);
  errors->SetLargest(largest);
  for (int level = 0; level <= rootLevel; ++level)
  {
    std::uint64_t number = 0;
    if (!Take(bytes, position, number))
    {
      return nullptr;
    }
    for (std::uint64_t i = 0; i < number; ++i)
    {
      std::uint64_t key = 0;
      BlockErrors::Tile tile{};
      bool isTaken = Take(bytes, position, key);
      for (int kind = 0; kind < GetNumberOfKinds(level) && isTaken; ++kind)
      {
        isTaken = TakeCodes(bytes, position, tile[kind]);
      }
      if (!isTaken)
      {
        return nullptr;
      }
      errors->GetTiles(level).emplace(key, tile);
    }
  }
  return errors;
}

std::string MakeHeader(const std::string& signature)
{
  return Magic + signature + '\n';
}
}

PyramidIndex::PyramidIndex(const std::vector<std::array<int, 2>>& sizes)
  : Sizes(sizes)
  , Levels(sizes.size())
{
}

const PyramidIndex::Record* PyramidIndex::Find(int level, int column, int row) const
{
  const auto found = this->Levels[level].find(MakeGridKey(column, row));
  return found == this->Levels[level].end() ? nullptr : &found->second;
}

void PyramidIndex::AddRange(int level, int column, int row, double minimum, double maximum)
{
  Record& record = this->Levels[level]
                     .try_emplace(MakeGridKey(column, row), Record{ Infinity, -Infinity, 0.0f })
                     .first->second;
  record.Minimum = std::min(record.Minimum, RoundDown(minimum));
  record.Maximum = std::max(record.Maximum, RoundUp(maximum));
}

void PyramidIndex::AddDeviation(int level, int column, int row, double deviation)
{
  Record& record = this->Levels[level]
                     .try_emplace(MakeGridKey(column, row), Record{ Infinity, -Infinity, 0.0f })
                     .first->second;
  record.Deviation = std::max(record.Deviation, RoundUp(deviation));
}

void PyramidIndex::AddAbsent(double sample)
{
  if (!std::isnan(sample))
  {
    this->Absent.Minimum = std::min(this->Absent.Minimum, RoundDown(sample));
    this->Absent.Maximum = std::max(this->Absent.Maximum, RoundUp(sample));
  }
}

double PyramidIndex::GetMaximumDeviation(int level) const
{
  float largest = 0.0f;
  for (const auto& tile : this->Levels[level])
  {
    largest = std::max(largest, tile.second.Deviation);
  }
  return largest;
}

bool PyramidIndex::GetRange(int level, double range[2]) const
{
  range[0] = this->Absent.Minimum;
  range[1] = this->Absent.Maximum;
  for (const auto& tile : this->Levels[level])
  {
    range[0] = std::min<double>(range[0], tile.second.Minimum);
    range[1] = std::max<double>(range[1], tile.second.Maximum);
  }
  return range[0] <= range[1];
}

ElevationRanges PyramidIndex::MakeElevationRanges(double scale, double offset) const
{
  const auto convert = [scale, offset](const Record& record)
  {
    const double first = scale * record.Minimum + offset;
    const double second = scale * record.Maximum + offset;
    return ElevationRanges::Range{ { RoundDown(std::min(first, second)),
      RoundUp(std::max(first, second)) } };
  };
  constexpr ElevationRanges::Range empty = { { 1.0f, 0.0f } };
  const bool hasAbsent = this->Absent.Minimum <= this->Absent.Maximum;
  ElevationRanges ranges(hasAbsent ? convert(this->Absent) : empty);
  ranges.SetAbsent(hasAbsent ? convert(this->Absent) : empty);
  for (const auto& [key, record] : this->Levels[0])
  {
    if (record.Minimum <= record.Maximum)
    {
      ranges.AddTile(
        static_cast<int>(key & 0xffffffffu), static_cast<int>(key >> 32), convert(record));
    }
  }
  ranges.Finish();
  return ranges;
}

std::int64_t PyramidIndex::GetMemorySize() const
{
  constexpr std::size_t pointers = 4 * sizeof(void*); // of a node of a map
  constexpr std::size_t record = sizeof(Record) + pointers;
  constexpr std::size_t range = (sizeof(ElevationRanges::Range) + pointers) * 4 / 3; // all levels
  constexpr std::size_t blocks = sizeof(BlockErrors::Tile) + pointers;
  std::size_t size = this->Levels.empty() ? 0 : this->Levels[0].size() * range;
  for (const auto& level : this->Levels)
  {
    size += level.size() * record;
  }
  for (int level = 0; this->Errors && level <= this->Errors->GetRootLevel(); ++level)
  {
    size += this->Errors->GetTiles(level).size() * blocks;
  }
  return static_cast<std::int64_t>(size);
}

bool PyramidIndex::IsValid(std::size_t level, std::uint64_t key, const Record& record) const
{
  const auto isInside = [](std::uint64_t tile, int size)
  { return tile * TileSize < static_cast<std::uint64_t>(size); };
  return isInside(key & 0xffffffffu, this->Sizes[level][0]) &&
    isInside(key >> 32, this->Sizes[level][1]) && !std::isnan(record.Minimum) &&
    !std::isnan(record.Maximum) && record.Deviation >= 0.0f;
}

bool PyramidIndex::Read(const std::string& fileName, const std::string& signature)
{
  std::ifstream stream(std::filesystem::u8path(fileName), std::ios::binary);
  std::ostringstream contents;
  contents << stream.rdbuf();
  const std::string bytes = contents.str();
  const std::string header = MakeHeader(signature);
  const std::size_t end = bytes.size() - std::min(bytes.size(), sizeof(std::uint64_t));
  std::uint64_t checksum = 0;
  std::size_t position = end;
  if (bytes.compare(0, header.size(), header) != 0 || end < header.size() ||
    !Take(bytes, position, checksum) ||
    checksum != GetChecksum(std::string_view(bytes).substr(0, end)))
  {
    return false;
  }
  position = header.size();
  if (!Take(bytes, position, this->Absent))
  {
    return false;
  }
  if (std::isnan(this->Absent.Minimum) || std::isnan(this->Absent.Maximum))
  {
    return false;
  }
  for (std::size_t level = 0; level < this->Levels.size(); ++level)
  {
    std::uint64_t number = 0;
    if (!Take(bytes, position, number))
    {
      return false;
    }
    this->Levels[level].clear();
    for (std::uint64_t i = 0; i < number; ++i)
    {
      std::uint64_t key = 0;
      Record record;
      if (!Take(bytes, position, key) || !Take(bytes, position, record) ||
        !this->IsValid(level, key, record))
      {
        return false;
      }
      this->Levels[level].emplace(key, record);
    }
  }
  this->Errors = TakeErrors(bytes, position);
  return this->Errors && position == end;
}

std::string PyramidIndex::Write(const std::string& fileName, const std::string& signature) const
{
  std::string bytes = MakeHeader(signature);
  Append(bytes, this->Absent);
  for (const auto& level : this->Levels)
  {
    Append(bytes, static_cast<std::uint64_t>(level.size()));
    for (const std::uint64_t key : GetSortedKeys(level)) // so that equal indices are equal files
    {
      Append(bytes, key);
      Append(bytes, level.at(key));
    }
  }
  AppendErrors(bytes, this->Errors ? *this->Errors : BlockErrors());
  Append(bytes, GetChecksum(bytes));
  return AtomicFile::Write(fileName, bytes);
}
}
