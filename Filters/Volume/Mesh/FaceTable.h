// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which corners of a cell its faces have
 *
 * Private to the module's own sources.
 */
#ifndef FaceTable_h
#define FaceTable_h

#include <array>

namespace relevo
{
struct FaceTable
{
  /// Corners in turn, counterclockwise where VTK's cells are seen from outside; of triangles the
  /// last one is -1.
  const std::array<int, 4>* Faces;
  int NumberOfFaces;
};

/// Of tetrahedra, hexahedra, voxels, wedges and pyramids, linear or quadratic, whose corners come
/// before points of edges; empty for other types.
FaceTable FindFaceTable(int type);
}

#endif
