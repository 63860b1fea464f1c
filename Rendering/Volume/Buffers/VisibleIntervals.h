// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the scalars for which a function has opacity
 *
 * Private to the module.
 */
#ifndef VisibleIntervals_h
#define VisibleIntervals_h

#include "Buffers/ActiveCells.h"
#include "Integral/LinearPieces.h"

#include <cstddef>
#include <vector>

namespace relevo
{
/// Return whether a piece of a function has no opacity.
bool IsTransparent(const LinearPieces& pieces, size_t piece);

/// Return the intervals with opacity, in ascending order, of scalars that are low + size * the
/// mesh's scalars.
std::vector<ActiveCells::Interval> FindVisibleIntervals(
  const LinearPieces& pieces, double low, double size);
}

#endif
