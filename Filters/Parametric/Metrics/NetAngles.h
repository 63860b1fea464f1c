// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   angles of control nets
 *
 * Private to the module.
 */
#ifndef NetAngles_h
#define NetAngles_h

namespace relevo
{
struct Patch;
class PatchArrays;

/// Returns the largest angle in degrees between the normals of adjacent quadrilaterals of the
/// control net, or of adjacent triangles for a triangular patch; 0 if there are none.
double ComputeNetAngle(const PatchArrays& patches, const Patch& patch);
}

#endif
