// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/TetrahedronCrossing.h"

#include <cmath>

namespace relevo
{
namespace
{
struct FacePlane
{
  dvec3 Point;
  dvec3 Normal;  // normalized, inwards
  double Height; // of the opposite corner, greater than 0

  FacePlane(const TetrahedronCorners& corners, int opposite)
    : Point(corners[(opposite + 1) % 4])
  {
    const dvec3 a = corners[(opposite + 2) % 4] - this->Point;
    const dvec3 b = corners[(opposite + 3) % 4] - this->Point;
    this->Normal = normalize(cross(a, b));
    this->Height = dot(corners[opposite] - this->Point, this->Normal);
    if (this->Height < 0.0)
    {
      this->Normal = -this->Normal;
      this->Height = -this->Height;
    }
  }
};
}

double ComputeSixfoldVolume(const TetrahedronCorners& corners)
{
  return std::abs(
    dot(corners[1] - corners[0], cross(corners[2] - corners[0], corners[3] - corners[0])));
}

double ComputeSlopes(const TetrahedronCorners& corners, CornerSlopes& slopes)
{
  const double volume = ComputeSixfoldVolume(corners);
  slopes.fill(dvec3(0.0));
  for (int i = 0; i < 4 && volume > 0.0; ++i)
  {
    const FacePlane plane(corners, i);
    slopes[i] = plane.Normal / plane.Height;
  }
  return volume;
}

TetrahedronPlanes::TetrahedronPlanes(const TetrahedronCorners& corners)
{
  for (size_t i = 0; i < 4; ++i)
  {
    const FacePlane plane(corners, static_cast<int>(i));
    const double scale = 1.0 / plane.Height;
    const dvec3 slope = scale * plane.Normal;
    this->X[i] = slope.x;
    this->Y[i] = slope.y;
    this->Z[i] = slope.z;
    this->Offset[i] = -dot(plane.Point, slope);
    this->Scale[i] = scale;
  }
}
}
