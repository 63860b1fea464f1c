// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the 3D cells on both sides of each face, and the planes of the faces
 *
 * Private to the module.
 */
#ifndef CellLinks_h
#define CellLinks_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/CellFaces.h"

#include <array>
#include <vector>

namespace relevo
{
/// Planes are (n, d) with n.x + d = 0 and |n| = 1, or 0 if the face has no area or is not finite.
struct CellLinks
{
  /// A face between two cells, or a part of one.
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
  dvec3 Origin = dvec3(0.0); // planes and centres are relative to this point
};

/**
 * Faces of three or more cells belong to the border. Degenerate cells, with two faces that have the
 * same corners, are skipped, and their neighbours are linked. The orientation of a face follows
 * from the centres of its two cells. If these are inconclusive, as for empty cells, it follows from
 * the order of corners.
 */
CellLinks LinkCells(const std::vector<dvec3>& points, CellFaces cells);
}

#endif
