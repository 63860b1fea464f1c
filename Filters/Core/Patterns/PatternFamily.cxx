// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternFamily.h"

#include "Mathematics/CornerOrder.h"
#include "Patterns/CanonicalOrder.h"

#include <utility>

namespace relevo
{
namespace
{
// Returns the key and permutation code of canonical patterns.
unsigned int MakeCanonicalEntry(int order, int step01, int step12, int step02)
{
  // Sorted corner j is the cell's corner corners[j]. The edge opposite to sorted corner j has the
  // step lacking[j], and the cell's edge i is opposite to its corner i + 2.
  const auto& corners = GetCornerOrder(order);
  const int lacking[3] = { step12, step02, step01 };
  int steps[3];
  for (int j = 0; j < 3; ++j)
  {
    steps[(corners[j] + 1) % 3] = lacking[j];
  }
  const int lambda = Canonicalize(steps);
  int permutation[3];
  GetPermutation(lambda, permutation);
  const int pattern = GetPatternIndex(steps[0], steps[1], steps[2]);
  const int key = 2 * pattern + (IsOdd(lambda) ? 1 : 0);
  return static_cast<unsigned int>(key << 3 |
    GetCornerOrderCode(permutation[corners[0]], permutation[corners[1]], permutation[corners[2]]));
}
}

PatternFamily::PatternFamily(SegmentSteps steps, Kinds kind, PatternMaker make)
  : Steps(std::move(steps))
  , Morphing(kind == MORPHING)
  , Make(std::move(make))
{
  this->MakeKeys();
  this->MakeEntries();
  this->Places = std::vector<Place>(this->Keys.size() / 2);
  this->MakeTime.Modified();
}

PatternFamily::~PatternFamily() = default;

void PatternFamily::MakeKeys()
{
  const int n = this->GetNumberOfSteps();
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < (this->Morphing ? n : i + 1); ++j)
    {
      for (int k = 0; k < (this->Morphing ? n : j + 1); ++k)
      {
        this->Keys.insert(this->Keys.end(), 2,
          { { static_cast<unsigned char>(i), static_cast<unsigned char>(j),
            static_cast<unsigned char>(k) } });
      }
    }
  }
}

void PatternFamily::MakeEntries()
{
  const int n = this->GetNumberOfSteps();
  this->Entries.reserve(static_cast<std::size_t>(6 * n * n * n));
  for (int order = 0; order < 6; ++order)
  {
    const int odd = order & 1; // permutation codes 1, 3 and 5 mirror
    for (int a = 0; a < n; ++a)
    {
      for (int b = 0; b < n; ++b)
      {
        for (int c = 0; c < n; ++c)
        {
          this->Entries.push_back(this->Morphing
              ? static_cast<unsigned int>(2 * ((a * n + b) * n + c) + odd) << 3
              : MakeCanonicalEntry(order, a, b, c));
        }
      }
    }
  }
}

const PatternFamily::Pattern& PatternFamily::GetPattern(int key) const
{
  Place& place = this->Places[static_cast<std::size_t>(key) / 2];
  std::call_once(place.Filled, [&] { place.Content = this->Make(this->Keys[key]); });
  return place.Content;
}
}
