// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the shared random numbers of places, in C++
 *
 * Private to the module's own sources.
 */
#ifndef NoiseHash_h
#define NoiseHash_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
#include "glsl/relevoNoiseHash.glsl"

/// What a place of a noise image has random numbers for.
enum NoiseStreams : int
{
  VALUE_STREAM,
  IMPULSE_STREAM,
  OCTAVE_STREAMS // and the next ones
};

inline uvec4 noiseHash(int column, int row, int stream, int seed)
{
  return noiseHash(ivec4(column, row, stream, seed));
}
}

#endif
