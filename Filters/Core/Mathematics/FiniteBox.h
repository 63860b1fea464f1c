// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FiniteBox
 * @brief   the bounding box of points, ignoring non-finite coordinates
 */
#ifndef FiniteBox_h
#define FiniteBox_h

#include <algorithm> // for std::min
#include <array>     // for members
#include <cmath>     // for std::isfinite
#include <limits>    // for the empty box

namespace relevo
{
struct FiniteBox
{
  std::array<double, 3> Low{ { Infinity, Infinity, Infinity } };
  std::array<double, 3> High{ { -Infinity, -Infinity, -Infinity } };

  void Add(const double point[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(point[axis]))
      {
        this->Low[axis] = std::min(this->Low[axis], point[axis]);
        this->High[axis] = std::max(this->High[axis], point[axis]);
      }
    }
  }

  /// 0 without finite coordinates.
  double GetMiddle(int axis) const
  {
    return this->HasAxis(axis) ? 0.5 * this->Low[axis] + 0.5 * this->High[axis] : 0.0;
  }
  double GetSide(int axis) const
  {
    return this->HasAxis(axis) ? this->High[axis] - this->Low[axis] : 0.0;
  }

  bool operator==(const FiniteBox& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  bool HasAxis(int axis) const { return this->Low[axis] <= this->High[axis]; }
};
}

#endif
