// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   3D cells on both sides of faces, and the faces' planes
 *
 * Private to the module's own sources.
 */
#ifndef CellLinks_h
#define CellLinks_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/CellFaces.h"

#include <array>
#include <vector>

namespace relevo
{
/// Planes are (n, d) with n.x + d = 0 and |n| = 1; all 0 where a face has no area or is not finite.
struct CellLinks
{
  /// A face between two cells, or a part of it.
  struct Link
  {
    dvec4 Plane; // n points to the second cell
    std::array<int, 2> Cells;
  };
  struct BorderFace
  {
    dvec4 Plane; // n points outwards
    dvec3 Center;
    int Cell;
  };
  std::vector<Link> Links;
  std::vector<BorderFace> Border;
  dvec3 Origin = dvec3(0.0); // of what planes and centres are relative to
};

/**
 * Faces of three cells or more are at the border. Cells whose points coincide, so that two of their
 * faces have the same corners, are skipped: those beside them are linked. On which side of a face a
 * cell is follows from the centres of both or, where these do not say it, as between empty cells,
 * from the order of corners.
 */
CellLinks LinkCells(const std::vector<dvec3>& points, CellFaces cells);
}

#endif
