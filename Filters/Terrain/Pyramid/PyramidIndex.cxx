// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/PyramidIndex.h"

#include "Files/AtomicFile.h"
#include "Pyramid/Checksum.h"

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
constexpr char Magic[] = "relevo pyramid index 1\n";
constexpr float Infinity = PyramidIndex::Infinity;

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

std::string MakeHeader(const std::string& signature)
{
  return Magic + signature + '\n';
}
}

PyramidIndex::PyramidIndex(const std::vector<std::array<int, 2>>& sizes)
  : Levels(sizes.size())
{
}

const PyramidIndex::Record* PyramidIndex::Find(int level, int column, int row) const
{
  const auto found = this->Levels[level].find(this->GetKey(column, row));
  return found == this->Levels[level].end() ? nullptr : &found->second;
}

void PyramidIndex::AddRange(int level, int column, int row, double minimum, double maximum)
{
  Record& record = this->Levels[level]
                     .try_emplace(this->GetKey(column, row), Record{ Infinity, -Infinity, 0.0f })
                     .first->second;
  record.Minimum = std::min(record.Minimum, RoundDown(minimum));
  record.Maximum = std::max(record.Maximum, RoundUp(maximum));
}

void PyramidIndex::AddDeviation(int level, int column, int row, double deviation)
{
  Record& record = this->Levels[level]
                     .try_emplace(this->GetKey(column, row), Record{ Infinity, -Infinity, 0.0f })
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
  for (auto& level : this->Levels)
  {
    std::uint64_t number = 0;
    if (!Take(bytes, position, number))
    {
      return false;
    }
    level.clear();
    for (std::uint64_t i = 0; i < number; ++i)
    {
      std::uint64_t key = 0;
      Record record;
      if (!Take(bytes, position, key) || !Take(bytes, position, record))
      {
        return false;
      }
      level.emplace(key, record);
    }
  }
  return position == end;
}

std::string PyramidIndex::Write(const std::string& fileName, const std::string& signature) const
{
  std::string bytes = MakeHeader(signature);
  Append(bytes, this->Absent);
  for (const auto& level : this->Levels)
  {
    Append(bytes, static_cast<std::uint64_t>(level.size()));
    std::vector<std::uint64_t> keys; // sorted, so that equal indices are equal files
    for (const auto& tile : level)
    {
      keys.push_back(tile.first);
    }
    std::sort(keys.begin(), keys.end());
    for (const std::uint64_t key : keys)
    {
      Append(bytes, key);
      Append(bytes, level.at(key));
    }
  }
  Append(bytes, GetChecksum(bytes));
  return AtomicFile::Write(fileName, bytes);
}
}
