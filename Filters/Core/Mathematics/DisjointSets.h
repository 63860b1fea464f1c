// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DisjointSets
 * @brief   union-find: disjoint sets of the numbers 0, 1, 2, ...
 */
#ifndef DisjointSets_h
#define DisjointSets_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::max
#include <numeric>   // for std::iota
#include <vector>    // for members

namespace relevo
{
class DisjointSets
{
public:
  explicit DisjointSets(vtkIdType size)
    : Parents(size)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// The lowest number of the set.
  vtkIdType Find(vtkIdType number)
  {
    while (this->Parents[number] != number)
    {
      this->Parents[number] = this->Parents[this->Parents[number]];
      number = this->Parents[number];
    }
    return number;
  }

  void Unite(vtkIdType a, vtkIdType b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<vtkIdType> Parents;
};
}

#endif
