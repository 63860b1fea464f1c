// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Noise/SolidNoise.h"

#include "Noise/NoiseHash.h"

#include <cmath>

namespace relevo
{
#include "glsl/relevoSolidNoise.glsl"

float SolidNoise::GetValue(const double x[3]) const
{
  constexpr double period = 1073741824.0; // lattice points are ints
  ivec3 cell;
  vec3 t;
  for (int i = 0; i < 3; ++i)
  {
    const double grains = x[i] / this->GrainSize;
    const double position = std::isfinite(grains) ? std::fmod(grains, period) : 0.0;
    const double below = std::floor(position);
    cell[i] = static_cast<int>(below);
    t[i] = static_cast<float>(position - below);
  }
  return solidNoise(cell, t, this->Seed);
}
}
