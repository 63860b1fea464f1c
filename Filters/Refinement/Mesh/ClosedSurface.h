// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   whether a mesh bounds bodies
 */
#ifndef ClosedSurface_h
#define ClosedSurface_h

namespace relevo
{
class RefinementMesh;

/**
 * Whether every edge between places has exactly two faces, which wind alike, and every connected
 * part of the mesh encloses a positive volume: from outside, front faces hide all back faces.
 */
bool IsClosedOutwards(const RefinementMesh& mesh);
}

#endif
