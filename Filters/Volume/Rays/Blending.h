// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   from what a ray passes through to the colour of a pixel
 *
 * Private to the module's own sources.
 */
#ifndef Blending_h
#define Blending_h

#include "Cells/Ray.h"

#include <vector>

namespace relevo
{
/// Emission and absorption, front to back; premultiplied.
dvec4 BlendComposite(const TransferFunctions& functions, const std::vector<RayPart>& parts);
}

#endif
