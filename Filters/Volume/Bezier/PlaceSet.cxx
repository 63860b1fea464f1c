// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/PlaceSet.h"

#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double TolerancesPerBox = 1024.0;
constexpr size_t None = std::numeric_limits<size_t>::max();

std::uint64_t GetHash(const std::array<std::int64_t, 3>& box)
{
  std::uint64_t hash = 0;
  for (const std::int64_t number : box)
  {
    hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}
}

PlaceSet::PlaceSet(double tolerance)
  : Tolerance(tolerance)
  , Side(TolerancesPerBox * tolerance)
{
}

size_t PlaceSet::Search(const Box& box, const dvec3& position) const
{
  const auto found = this->Firsts.find(GetHash(box));
  size_t place = found == this->Firsts.end() ? None : found->second;
  while (place != None)
  {
    const dvec3 apart = abs(this->Positions[place] - position);
    if (apart.x <= this->Tolerance && apart.y <= this->Tolerance && apart.z <= this->Tolerance)
    {
      return place;
    }
    place = this->Next[place];
  }
  return None;
}

size_t PlaceSet::Find(const dvec3& position)
{
  const auto getBox = [this](const dvec3& at)
  {
    return Box{ { std::llround(at.x / this->Side), std::llround(at.y / this->Side),
      std::llround(at.z / this->Side) } };
  };
  const Box own = getBox(position);
  const Box low = getBox(position - this->Tolerance);
  const Box high = getBox(position + this->Tolerance);
  for (std::int64_t i = low[0]; i <= high[0]; ++i)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      for (std::int64_t k = low[2]; k <= high[2]; ++k)
      {
        const size_t place = this->Search({ { i, j, k } }, position);
        if (place != None)
        {
          return place;
        }
      }
    }
  }
  const size_t place = this->Positions.size();
  this->Positions.push_back(position);
  const auto [first, isNew] = this->Firsts.insert({ GetHash(own), place });
  this->Next.push_back(isNew ? None : first->second);
  first->second = place;
  return place;
}
}
