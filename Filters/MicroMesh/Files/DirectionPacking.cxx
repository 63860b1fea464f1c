// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/DirectionPacking.h"

#include "Data/OctahedralUnit.h"
#include "Files/ArrayPacking.h"
#include "Files/LittleEndian.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace relevo
{
namespace
{
constexpr int BitsOfCoordinate = 8;
constexpr std::size_t ExponentSize = 2;

float GetLength(int exponent)
{
  return std::ldexp(1.0f, exponent);
}

bool AreSame(const vec3& a, const vec3& b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

// The next direction is probably that of the point at the same place, or of the last point.
OctahedralUnit Predict(const std::vector<OctahedralUnit>& units, const std::vector<int>& firsts)
{
  const auto first = static_cast<std::size_t>(firsts[units.size()]);
  return first < units.size() ? units[first] : (units.empty() ? OctahedralUnit{} : units.back());
}
}

std::size_t GetPackedDirectionSize(std::size_t directions)
{
  return ExponentSize + 2 * directions;
}

bool PackDirections(
  const std::vector<vec3>& directions, const std::vector<int>& firsts, std::string& bytes)
{
  const auto first = std::find_if(
    directions.begin(), directions.end(), [](const vec3& d) { return dot(d, d) > 0.0f; });
  const int exponent =
    first == directions.end() ? 0 : static_cast<int>(std::lround(std::log2(length(dvec3(*first)))));
  std::vector<std::uint64_t> coordinates[2];
  std::vector<OctahedralUnit> units;
  for (std::size_t d = 0; d < directions.size(); ++d)
  {
    const OctahedralUnit unit = ToOctahedral(dvec3(directions[d]));
    if (!AreSame(FromOctahedral(unit) * GetLength(exponent), directions[d]))
    {
      return false;
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      const OctahedralUnit last = Predict(units, firsts);
      coordinates[i].push_back(static_cast<std::uint8_t>(unit[i] - last[i]));
    }
    units.push_back(unit);
  }
  bytes.clear();
  AppendNumber(bytes, static_cast<std::uint16_t>(exponent), ExponentSize);
  PackNumbers(coordinates[0], BitsOfCoordinate, bytes);
  PackNumbers(coordinates[1], BitsOfCoordinate, bytes);
  return true;
}

void UnpackDirections(
  std::string_view bytes, const std::vector<int>& firsts, std::vector<vec3>& directions)
{
  const float length = GetLength(static_cast<std::int16_t>(TakeNumber(bytes, ExponentSize)));
  std::vector<std::uint64_t> coordinates[2];
  for (std::vector<std::uint64_t>& values : coordinates)
  {
    values.resize(directions.size());
    UnpackNumbers(bytes, BitsOfCoordinate, values);
  }
  std::vector<OctahedralUnit> units;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    OctahedralUnit unit = Predict(units, firsts);
    for (std::size_t c = 0; c < 2; ++c)
    {
      unit[c] = static_cast<std::uint8_t>(unit[c] + coordinates[c][i]);
    }
    directions[i] = FromOctahedral(unit) * length;
    units.push_back(unit);
  }
}
}
