// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the points and faces of unsplit cells in a RayCastMesh
 *
 * Private to the modules' own sources.
 */
#ifndef CurvedRecords_h
#define CurvedRecords_h

#include "Cells/CellShape.h"

#include <array>
#include <vector>

namespace relevo
{
/// Return the indices of the cell's points that are the corners of its record, for each kind of
/// cell; or those of its mirror image. Without a shape, the cell is a tetrahedron.
const std::vector<int>& GetRecord(const CellShape* shape, bool isMirrored);

/// Return the corners of the faces of a record.
const std::vector<std::array<int, 4>>& GetRecordFaces(bool isQuadratic);

/// The edges of a hexahedron's record.
constexpr int NumberOfRecordEdges = 12;
std::array<int, 2> GetRecordEdge(int edge);

/// Return whether a face has three distinct corners. Faces of wedges and pyramids may be
/// degenerate.
bool IsFace(std::array<int, 4> face);
}

#endif
