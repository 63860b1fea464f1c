// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the corners of tetrahedra that are stored by their neighbours
 *
 * Private to the module.
 */
#ifndef TetrahedronCorners_h
#define TetrahedronCorners_h

namespace relevo
{
struct RayCastMesh;

/// Find the corners of all tetrahedra from the sums of points and the neighbours, which must not be
/// of a discontinuous mesh. Return false, without corners, if some tetrahedra cannot be reached
/// from the border or from curved cells.
bool FindTetrahedronCorners(RayCastMesh& mesh);
}

#endif
