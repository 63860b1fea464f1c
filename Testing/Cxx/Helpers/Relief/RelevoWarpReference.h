// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What vtkReliefWarper is to show, by casting a line for each texel: in double precision against
// each piece of the bilinear surface.
#ifndef RelevoWarpReference_h
#define RelevoWarpReference_h

#include "Data/Relief.h"

#include <vector>

class vtkCamera;
class vtkImageData;

class RelevoWarpReference
{
public:
  RelevoWarpReference(vtkImageData* image, vtkCamera* camera, double maximumStretch = 8.0);

  /// Where the line from the eye through a place of the relief's plane first meets the surface
  /// between texels, in texel space; NaN where it does not.
  relevo::dvec3 Cast(double column, double row) const;
  /// Where the line from the eye to a texel's point meets the plane.
  relevo::dvec2 Project(int column, int row) const;
  /// Where a line through a place of the plane is at a height, in texel space.
  relevo::dvec3 GetPoint(double column, double row, double height) const;

  const relevo::Relief& GetRelief() const { return this->Relief; }

private:
  // The line is at start + slope h at the height h.
  void CastQuad(int column, int row, const relevo::dvec2& start, const relevo::dvec2& slope,
    relevo::dvec3& nearest) const;

  relevo::Relief Relief;
  std::vector<unsigned char> Sides;
  relevo::dvec4 Eye; // in texel space, homogeneous
};

#endif
