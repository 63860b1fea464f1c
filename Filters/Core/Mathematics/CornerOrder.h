// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   permutations of a triangle's corners, and the corners of its edges
 */
#ifndef CornerOrder_h
#define CornerOrder_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <array> // for signature

namespace relevo
{
/**
 * The permutation for a code (0 to 5, as in relevoWeights.glsl): position j of the result is
 * element order[j] of the original.
 */
RELEVOFILTERSCORE_EXPORT const std::array<int, 3>& GetCornerOrder(int code);

/// The inverse of GetCornerOrder().
RELEVOFILTERSCORE_EXPORT int GetCornerOrderCode(int first, int second, int third);

/// The two sorted corners of each edge of a face.
constexpr int EdgeCorners[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
}

#endif
