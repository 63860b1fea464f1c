// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BoundingBox
 * @brief   an axis-aligned box, empty until points are added
 *
 * Private to the modules' own sources.
 */
#ifndef BoundingBox_h
#define BoundingBox_h

#include <algorithm> // for std::min
#include <array>     // for members
#include <limits>    // for the empty box

namespace relevo
{
template <typename T>
struct BoundingBox
{
  std::array<T, 3> Low{ { Infinity, Infinity, Infinity } };
  std::array<T, 3> High{ { -Infinity, -Infinity, -Infinity } };

  void Add(const T point[3])
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], point[c]);
      this->High[c] = std::max(this->High[c], point[c]);
    }
  }
  void Add(const BoundingBox& other)
  {
    this->Add(other.Low.data());
    this->Add(other.High.data());
  }
  bool Intersects(const BoundingBox& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }
  T GetSumOfLengths() const
  {
    return (this->High[0] - this->Low[0]) + (this->High[1] - this->Low[1]) +
      (this->High[2] - this->Low[2]);
  }
  int GetLongestAxis() const
  {
    int axis = 0;
    for (int c = 1; c < 3; ++c)
    {
      axis = this->High[c] - this->Low[c] > this->High[axis] - this->Low[axis] ? c : axis;
    }
    return axis;
  }

  static constexpr T Infinity = std::numeric_limits<T>::infinity();
};
}

#endif
