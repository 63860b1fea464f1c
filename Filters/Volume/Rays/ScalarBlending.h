// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   blend modes that map one scalar per ray: maximum, minimum and average
 *
 * Private to the module.
 */
#ifndef ScalarBlending_h
#define ScalarBlending_h

#include "Integral/Ray.h"

#include <vector>

namespace relevo
{
/**
 * Returns the premultiplied colour of the highest (sign 1) or lowest (sign -1) scalar. Each
 * independent component has its extreme value. Dependent components are taken at the first position
 * where the last component, the opacity, is extreme.
 */
dvec4 BlendExtreme(
  const TransferFunctions& functions, const std::vector<RayPart>& parts, double sign);

/// Returns the premultiplied colour of the mean scalars by length.
dvec4 BlendAverage(const TransferFunctions& functions, const std::vector<RayPart>& parts);
}

#endif
