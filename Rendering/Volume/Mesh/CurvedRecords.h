// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which points and faces cells that stay unsplit have in a RayCastMesh
 *
 * Private to the module's own sources.
 */
#ifndef CurvedRecords_h
#define CurvedRecords_h

#include "Cells/CellShape.h"

#include <array>
#include <vector>

namespace relevo
{
/// Of the points of each kind of cell, those that are the corners of its record; or the same cell
/// as seen in a mirror.
const std::vector<int>& GetRecord(const CellShape& shape, bool isMirrored);

/// The corners of the faces of a record.
std::vector<std::array<int, 4>> GetRecordFaces(bool isQuadratic);

/// Whether a face has three corners; those of wedges and pyramids may be an edge or a point.
bool IsFace(std::array<int, 4> face);
}

#endif
