// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   rays of which one scalar is shown: an extreme, or the mean
 *
 * Private to the module's own sources.
 */
#ifndef ScalarBlending_h
#define ScalarBlending_h

#include "Cells/Ray.h"

#include <vector>

namespace relevo
{
/**
 * Of the highest scalar, with a sign of 1, or the lowest, with -1; premultiplied. Of each
 * independent component its own; of dependent ones all where the last, which has the opacity, is
 * extreme, and first so.
 */
dvec4 BlendExtreme(
  const TransferFunctions& functions, const std::vector<RayPart>& parts, double sign);

/// Of the mean by length of each component; premultiplied.
dvec4 BlendAverage(const TransferFunctions& functions, const std::vector<RayPart>& parts);
}

#endif
