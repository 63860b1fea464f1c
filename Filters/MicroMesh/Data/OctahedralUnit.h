// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   unit vectors in octahedral coordinates, as two bytes
 *
 * The bytes 0 to 254 are coordinates from -1 to 1. Two bytes of 255 are a vector without length.
 * relevoMicroMesh.glsl has the same conversion to vectors.
 *
 * Source: Z. Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors",
 * Journal of Computer Graphics Techniques 3(2), 2014.
 */
#ifndef OctahedralUnit_h
#define OctahedralUnit_h

#include "Mathematics/RefinementMathematics.h"

#include <algorithm> // for std::max
#include <array>     // for results
#include <cmath>     // for std::lround
#include <cstdint>   // for bytes

namespace relevo
{
using OctahedralUnit = std::array<std::uint8_t, 2>;

constexpr OctahedralUnit NoOctahedralUnit{ { 255, 255 } };

/// The nearest coordinates of the direction of a vector.
inline OctahedralUnit ToOctahedral(const dvec3& vector)
{
  const double sum = std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z);
  if (!(sum > 0.0))
  {
    return NoOctahedralUnit;
  }
  dvec2 e = dvec2(vector) / sum;
  if (vector.z < 0.0)
  {
    const dvec2 folded = 1.0 - abs(dvec2(e.y, e.x));
    e = dvec2(e.x >= 0.0 ? folded.x : -folded.x, e.y >= 0.0 ? folded.y : -folded.y);
  }
  return { { static_cast<std::uint8_t>(std::lround((e.x + 1.0) * 127.0)),
    static_cast<std::uint8_t>(std::lround((e.y + 1.0) * 127.0)) } };
}

inline vec3 FromOctahedral(const OctahedralUnit& unit)
{
  if (unit == NoOctahedralUnit)
  {
    return vec3(0.0f);
  }
  const dvec2 e = dvec2(unit[0], unit[1]) / 127.0 - 1.0;
  dvec3 n(e, 1.0 - std::abs(e.x) - std::abs(e.y));
  const double fold = std::max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return vec3(n / length(n));
}
}

#endif
