// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the directions of a micro-mesh as a length and two bytes each
 */
#ifndef DirectionPacking_h
#define DirectionPacking_h

#include "Mathematics/RefinementMathematics.h"

#include <string>
#include <string_view>
#include <vector>

namespace relevo
{
/// The number of bytes for a number of directions.
std::size_t GetPackedDirectionSize(std::size_t directions);

/// Pack directions with a common length, a power of two, and octahedral coordinates. `firsts` are
/// those of FindFirstPoints(). Returns false if others would be read than these.
bool PackDirections(
  const std::vector<vec3>& directions, const std::vector<int>& firsts, std::string& bytes);

/// Fill directions, from bytes of the right size.
void UnpackDirections(
  std::string_view bytes, const std::vector<int>& firsts, std::vector<vec3>& directions);
}

#endif
