// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   tests whether a mesh is a closed surface
 */
#ifndef ClosedSurface_h
#define ClosedSurface_h

namespace relevo
{
class RefinementMesh;

/**
 * Return whether every edge between merged points has exactly two faces with the same winding, and
 * every connected part of the mesh encloses a positive volume. Seen from outside, front faces then
 * hide all back faces.
 */
bool IsClosedOutwards(const RefinementMesh& mesh);
}

#endif
