// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceDistance
 * @brief   distances of triangles from a surface that they do not intersect
 *
 * Lengths are scaled by a power of two, according to the size of the coordinates, so that squares
 * neither overflow nor underflow.
 *
 * Private to the module.
 */
#ifndef SurfaceDistance_h
#define SurfaceDistance_h

#include "vtkType.h" // for vtkIdType

namespace relevo
{
class MovedSurface;

class SurfaceDistance
{
public:
  /// Measures from triangles of `from` to those of `to`, which must have a triangle with an area.
  SurfaceDistance(const MovedSurface& from, const MovedSurface& to);

  /// Lowers `square` to the squared distance of a triangle if that is smaller. `nearest` is a
  /// triangle of the other surface that is possibly near, or -1, and returns the nearest one found.
  void Lower(vtkIdType triangle, vtkIdType& nearest, double& square) const;
  /// Returns the distance for such a square.
  double GetLength(double square) const;

private:
  double Square(vtkIdType triangle, vtkIdType other) const;

  const MovedSurface& From;
  const MovedSurface& To;
  double Unit;
};
}

#endif
