// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Motion
 * @brief   an affine transform of a surface
 *
 * Private to the module.
 */
#ifndef Motion_h
#define Motion_h

#include "Boxes/BoundingBox.h"
#include "RelevoFiltersIntersectionModule.h" // for export macro

#include <array>  // for members
#include <string> // for return values

class vtkMatrix4x4;

namespace relevo
{
class RELEVOFILTERSINTERSECTION_EXPORT Motion
{
public:
  /// Sets the matrix; nullptr is the identity. Returns an error, such as "has a singular matrix",
  /// or "".
  std::string Set(vtkMatrix4x4* matrix);

  bool operator==(const Motion& other) const { return this->Elements == other.Elements; }

  /// Computes in the same order as VTK's transforms, so that a mesh transformed by these has
  /// bitwise identical points.
  void Move(const double x[3], double moved[3]) const
  {
    const std::array<double, 16>& m = this->Elements;
    for (int c = 0; c < 3; ++c)
    {
      moved[c] = m[4 * c] * x[0] + m[4 * c + 1] * x[1] + m[4 * c + 2] * x[2] + m[4 * c + 3];
    }
  }

  /// Returns a box that contains the transformed box.
  BoundingBox<double> MoveBox(const BoundingBox<double>& box) const;

  /// Returns the largest factor by which a length grows.
  double GetLargestStretch() const;

private:
  std::array<double, 16> Elements{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
};
}

#endif
