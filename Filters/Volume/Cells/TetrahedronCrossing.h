// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   intersection of a ray with a tetrahedron
 *
 * Private to the module.
 */
#ifndef TetrahedronCrossing_h
#define TetrahedronCrossing_h

#include "Cells/CellShape.h"
#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <algorithm> // for inline functions
#include <array>
#include <limits> // for inline functions

namespace relevo
{
using TetrahedronCorners = std::array<dvec3, 4>;

/// Returns six times the volume, without sign.
double ComputeSixfoldVolume(const TetrahedronCorners& corners);

/// Computes the constant slopes of a tetrahedron. Returns six times the volume. If that is 0,
/// slopes are 0.
RELEVOFILTERSVOLUME_EXPORT double ComputeSlopes(
  const TetrahedronCorners& corners, CornerSlopes& slopes);

struct TetrahedronCrossing
{
  double Begin;
  double End;
  dvec4 FrontWeights; // of the corners
  dvec4 BackWeights;
};

/// The planes of the four faces, for any number of rays.
class TetrahedronPlanes
{
public:
  /// Corners can be in any order.
  explicit TetrahedronPlanes(const TetrahedronCorners& corners);

  /**
   * Clips a ray by the planes. Returns whether a part of it is inside. A ray that is parallel to a
   * face and at most `margin` outside of it counts as inside, so that a ray in a face is inside of
   * both cells.
   */
  bool Cross(const Ray& ray, double margin, TetrahedronCrossing& crossing) const;

private:
  // The weight of a corner is proportional to the height above the opposite face. The weight of a
  // point p is dot(p, (X, Y, Z)) + Offset. One array for each coordinate, so that compilers use
  // vector instructions.
  using Numbers = std::array<double, 4>;
  Numbers X;
  Numbers Y;
  Numbers Z;
  Numbers Offset;
  Numbers Scale; // weight per height
};

inline bool TetrahedronPlanes::Cross(
  const Ray& ray, double margin, TetrahedronCrossing& crossing) const
{
  // Sine of the angle below which a ray is parallel to a face.
  constexpr double parallel = 1e-14;
  constexpr double farthest = std::numeric_limits<double>::max();
  Numbers base;
  Numbers slopes;
  Numbers entries;
  Numbers exits;
  for (size_t i = 0; i < 4; ++i)
  {
    base[i] = ray.Origin.x * this->X[i] + ray.Origin.y * this->Y[i] + ray.Origin.z * this->Z[i] +
      this->Offset[i];
    slopes[i] =
      ray.Direction.x * this->X[i] + ray.Direction.y * this->Y[i] + ray.Direction.z * this->Z[i];
  }
  for (size_t i = 0; i < 4; ++i)
  {
    const double hit = -base[i] / slopes[i];
    const double least = parallel * this->Scale[i];
    const double outside = base[i] < -margin * this->Scale[i] ? farthest : -farthest;
    entries[i] = slopes[i] >= least ? hit : slopes[i] <= -least ? -farthest : outside;
    exits[i] = slopes[i] <= -least ? hit : farthest;
  }
  const double begin =
    std::max(std::max(std::max(entries[0], entries[1]), std::max(entries[2], entries[3])), 0.0);
  const double end =
    std::min(std::min(std::min(exits[0], exits[1]), std::min(exits[2], exits[3])), ray.Length);
  if (!(begin < end))
  {
    return false;
  }
  const auto getWeights = [&](double at)
  {
    dvec4 weights;
    for (int i = 0; i < 4; ++i)
    {
      weights[i] = std::max(base[i] + at * slopes[i], 0.0);
    }
    return weights * (1.0 / (weights.x + weights.y + weights.z + weights.w));
  };
  crossing = { begin, end, getWeights(begin), getWeights(end) };
  return true;
}
}

#endif
