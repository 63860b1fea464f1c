// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceDistance
 * @brief   how far triangles are from a surface that they do not meet
 *
 * Lengths are measured in a power of two near the size of the coordinates, so that squares neither
 * overflow nor vanish.
 *
 * Private to the module's own sources.
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
  /// Of triangles of one surface to the other, which has triangles with an area.
  SurfaceDistance(const MovedSurface& from, const MovedSurface& to);

  /// Lower the square of a distance to that of a triangle, where this is less. `nearest`: a
  /// triangle of the other surface that may be near, -1 for none; becomes one that is nearer.
  void Lower(vtkIdType triangle, vtkIdType& nearest, double& square) const;
  /// The distance that has such a square.
  double GetLength(double square) const;

private:
  double Square(vtkIdType triangle, vtkIdType other) const;

  const MovedSurface& From;
  const MovedSurface& To;
  double Unit;
};
}

#endif
