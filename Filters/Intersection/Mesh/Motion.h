// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Motion
 * @brief   the affine matrix that moves a surface
 *
 * Private to the module's own sources.
 */
#ifndef Motion_h
#define Motion_h

#include "RelevoFiltersIntersectionModule.h" // for export macro

#include <array>  // for members
#include <string> // for return values

class vtkMatrix4x4;

namespace relevo
{
struct Box;

class RELEVOFILTERSINTERSECTION_EXPORT Motion
{
public:
  /// Take a matrix, nullptr for identity. Returns what is wrong with it, as "has a singular
  /// matrix", or nothing.
  std::string Set(vtkMatrix4x4* matrix);

  bool operator==(const Motion& other) const { return this->Elements == other.Elements; }

  /// As VTK's transforms have it, so that a mesh moved by them meets in the same places.
  void Move(const double x[3], double moved[3]) const
  {
    const std::array<double, 16>& m = this->Elements;
    for (int c = 0; c < 3; ++c)
    {
      moved[c] = m[4 * c] * x[0] + m[4 * c + 1] * x[1] + m[4 * c + 2] * x[2] + m[4 * c + 3];
    }
  }

  /// A box around all that a box becomes.
  Box MoveBox(const Box& box) const;

  /// The factor by which the longest length grows.
  double GetLargestStretch() const;

private:
  std::array<double, 16> Elements{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
};
}

#endif
