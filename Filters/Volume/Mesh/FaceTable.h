// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   corners of the faces of VTK cell types
 *
 * Private to the module.
 */
#ifndef FaceTable_h
#define FaceTable_h

#include <array>

namespace relevo
{
struct FaceTable
{
  /// Corners in cyclic order, counterclockwise from outside for valid VTK cells. The last corner of
  /// a triangle is -1.
  const std::array<int, 4>* Faces;
  int NumberOfFaces;
};

/// Returns the table of a linear or quadratic tetrahedron, hexahedron, voxel, wedge or pyramid,
/// whose corners precede the points of edges. It is empty for other types.
FaceTable FindFaceTable(int type);
}

#endif
