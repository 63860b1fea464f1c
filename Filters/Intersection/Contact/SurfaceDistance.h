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

  /// `nearest`: a triangle of the other surface that may be near, -1 for none; becomes the nearest.
  double Compute(vtkIdType triangle, vtkIdType& nearest) const;

private:
  double Square(vtkIdType triangle, vtkIdType other) const;

  const MovedSurface& From;
  const MovedSurface& To;
  double Unit;
};
}

#endif
