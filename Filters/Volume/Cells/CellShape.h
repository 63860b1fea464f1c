// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellShape
 * @brief   shape functions, parameters and faces of cells that stay unsplit
 *
 * Private to the module's own sources.
 */
#ifndef CellShape_h
#define CellShape_h

#include "Cells/Ray.h"
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
  dvec3 Center; // parameters
  /// VTK's: a weight for each corner; its derivatives, all by the first parameter before the next.
  void (*Weigh)(const double parameters[3], double* weights);
  void (*Derive)(const double parameters[3], double* derivatives);
  /// How far parameters are outside: at most 0 for those of the cell.
  double (*GetOutside)(const dvec3& parameters);
  /// Bilinear faces; of triangles the last corner counts twice.
  std::vector<std::array<int, 4>> Faces;
  /// Faces of three corners and the middles of the edges after them.
  std::vector<std::array<int, 6>> QuadraticFaces;
  /// Of an undistorted cell, as a share of the determinant of the derivatives in the middle.
  double Volume;
};

/// Of each corner the derivative of its weight by the place.
using CornerSlopes = std::array<dvec3, MaximumCorners>;

/// Of a type of VTK; null for cells that are to be split. A voxel is a hexahedron whose corners
/// come in the order of GetCornerOrder().
RELEVOFILTERSVOLUME_EXPORT const CellShape* FindCellShape(int type);

/// Which of a cell's points is a corner of its shape.
int GetCorner(int type, int corner);
}

#endif
