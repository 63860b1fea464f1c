// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/CanonicalOrder.h"

#include <algorithm>
#include <utility>

namespace relevo
{
int Canonicalize(int ijk[3])
{
  int lambda = 0;
  auto order = [&](int first, int second, int weight)
  {
    if (ijk[first] < ijk[second])
    {
      std::swap(ijk[first], ijk[second]);
      lambda += weight;
    }
  };
  order(0, 1, 1);
  order(0, 2, 2);
  order(1, 2, 4);
  return lambda;
}

void GetPermutation(int lambda, int permutation[3])
{
  // lambda = 3 cannot occur. It has the identity.
  static constexpr int permutations[8][3] = { { 0, 1, 2 }, { 2, 1, 0 }, { 0, 2, 1 }, { 0, 1, 2 },
    { 1, 0, 2 }, { 2, 0, 1 }, { 1, 2, 0 }, { 0, 2, 1 } };
  std::copy(permutations[lambda & 7], permutations[lambda & 7] + 3, permutation);
}

bool IsOdd(int lambda)
{
  return lambda == 1 || lambda == 2 || lambda == 4 || lambda == 7;
}
}
