// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PlaceSet
 * @brief   positions that differ by rounding errors only, found by hashing
 *
 * Private to the module.
 */
#ifndef PlaceSet_h
#define PlaceSet_h

#include "Mathematics/RefinementMathematics.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace relevo
{
class PlaceSet
{
public:
  /// Positions that are at most `tolerance` apart in all directions are the same place.
  explicit PlaceSet(double tolerance);

  /// Returns the index of a place, which is added if it is new.
  size_t Find(const dvec3& position);
  const dvec3& GetPosition(size_t place) const { return this->Positions[place]; }
  size_t GetNumberOfPlaces() const { return this->Positions.size(); }

private:
  using Box = std::array<std::int64_t, 3>;

  size_t Search(const Box& box, const dvec3& position) const;

  double Tolerance;
  double Side; // of a box
  std::vector<dvec3> Positions;
  std::vector<size_t> Next; // place in a box with the same hash, or None
  std::unordered_map<std::uint64_t, size_t> Firsts;
};
}

#endif
