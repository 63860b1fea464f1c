// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Expected result of vtkReliefWarper: casts a ray per texel, in double precision, at each piece of
// the bilinear surface.
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

  /// First intersection of the line from the eye through a point of the relief's plane with the
  /// surface between texels, in texel space. NaN if there is none.
  relevo::dvec3 Cast(double column, double row) const;
  /// Intersection of the plane with the line from the eye to a texel's point.
  relevo::dvec2 Project(int column, int row) const;
  /// Point at this height on a line through a point of the plane, in texel space.
  relevo::dvec3 GetPoint(double column, double row, double height) const;

  const relevo::Relief& GetRelief() const { return this->Relief; }

private:
  // The line at height h is start + slope h.
  void CastQuad(int column, int row, const relevo::dvec2& start, const relevo::dvec2& slope,
    relevo::dvec3& nearest) const;

  relevo::Relief Relief;
  std::vector<unsigned char> Sides;
  relevo::dvec4 Eye; // in texel space, homogeneous
};

#endif
