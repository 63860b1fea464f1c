// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how much control nets are bent
 *
 * Private to the module's own sources.
 */
#ifndef NetAngles_h
#define NetAngles_h

namespace relevo
{
struct Patch;
class PatchArrays;

/// The largest angle, in degrees, between normals of two quads of a patch's control net, or of two
/// triangles of a triangle's, that share a side; 0 where there are none.
double ComputeNetAngle(const PatchArrays& patches, const Patch& patch);
}

#endif
