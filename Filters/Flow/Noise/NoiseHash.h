// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the hashed random numbers that shaders and C++ share
 *
 * Private to the module.
 */
#ifndef NoiseHash_h
#define NoiseHash_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoNoiseHash.glsl"

/// Independent random numbers at the same position of a noise image.
enum NoiseStreams : int
{
  VALUE_STREAM,
  IMPULSE_STREAM,
  OCTAVE_STREAMS // one for each octave, starting here
};

inline uvec4 noiseHash(int column, int row, int stream, int seed)
{
  return noiseHash(ivec4(column, row, stream, seed));
}
}

#endif
