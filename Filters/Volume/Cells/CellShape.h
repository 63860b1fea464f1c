// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellShape
 * @brief   shape functions, parameters and faces of cells that are not split
 *
 * Private to the module.
 */
#ifndef CellShape_h
#define CellShape_h

#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <array>
#include <vector>

namespace relevo
{
constexpr int MaximumCorners = 10;

struct CellShape
{
  int NumberOfCorners;
  dvec3 Center; // parametric coordinates
  /// VTK's shape functions: the weights of the corners, and their derivatives, first all
  /// derivatives by the first parameter.
  void (*Weigh)(const double parameters[3], double* weights);
  void (*Derive)(const double parameters[3], double* derivatives);
  /// Returns the distance of parameters from the cell, at most 0 inside.
  double (*GetOutside)(const dvec3& parameters);
  /// The bilinear faces. Triangles repeat the last corner.
  std::vector<std::array<int, 4>> Faces;
  /// Faces with three corners, followed by the midpoints of their edges.
  std::vector<std::array<int, 6>> QuadraticFaces;
  /// Volume of an undistorted cell / determinant of the derivatives at its centre.
  double Volume;
};

/// The derivative of each corner's weight by position.
using CornerSlopes = std::array<dvec3, MaximumCorners>;

/// Returns the shape of a VTK cell type, or null if the cells must be split. A voxel is a
/// hexahedron whose corners have the order of GetCornerOrder().
RELEVOFILTERSVOLUME_EXPORT const CellShape* FindCellShape(int type);

/// Returns the index of a corner of the shape among the points of the cell.
int GetCorner(int type, int corner);
}

#endif
