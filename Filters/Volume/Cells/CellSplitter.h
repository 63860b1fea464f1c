// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellSplitter
 * @brief   splits cells into tetrahedra, so that cells that share a face split it alike
 *
 * Each face is split from its lowest point, and a cell from its own lowest point to all faces that
 * it is not on (J. Dompierre, P. Labbe, M.-G. Vallet, R. Camarero, "How to Subdivide Pyramids,
 * Prisms, and Hexahedra into Tetrahedra", 8th International Meshing Roundtable 1999), which all
 * convex cells allow. The lowest point is that of the lowest x, y and z, which cells of several
 * data sets agree on. Cells that are not linear, and sets of points, are split by
 * vtkCell::Triangulate.
 *
 * Private to the module's own sources.
 */
#ifndef CellSplitter_h
#define CellSplitter_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <vector>

class vtkGenericCell;
class vtkIdList;
class vtkPoints;

namespace relevo
{
class CellSplitter
{
public:
  CellSplitter();
  ~CellSplitter();

  /// Of a 3D cell: ids of points, four for each tetrahedron. The place of a point is points[id].
  const std::vector<vtkIdType>& Split(vtkGenericCell* cell, const dvec3* points);

private:
  void SplitLinear(vtkGenericCell* cell, const dvec3* points);
  void FindFace(vtkGenericCell* cell, int face);

  std::vector<vtkIdType> Tetrahedra;
  std::vector<vtkIdType> Face;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> Points;
};
}

#endif
