// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellSplitter
 * @brief   splits cells into tetrahedra consistently across shared faces
 *
 * Each face is split from its lowest point, and a cell from its lowest point to all faces that do
 * not contain it (J. Dompierre, P. Labbe, M.-G. Vallet, R. Camarero, "How to Subdivide Pyramids,
 * Prisms, and Hexahedra into Tetrahedra", 8th International Meshing Roundtable 1999). This works
 * for all convex cells. Points are ordered by x, y and z, so that cells of different data sets
 * match. Cells that are not linear, and convex point sets, are split with vtkCell::Triangulate().
 *
 * Private to the module.
 */
#ifndef CellSplitter_h
#define CellSplitter_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkNew.h"
#include "vtkType.h"

#include <functional>
#include <vector>

class vtkGenericCell;
class vtkIdList;
class vtkPoints;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CellSplitter
{
public:
  CellSplitter();
  ~CellSplitter();

  /// Splits a 3D cell. Returns four point ids for each tetrahedron. The coordinates of a point are
  /// points[id].
  const std::vector<vtkIdType>& Split(vtkGenericCell* cell, const dvec3* points);
  /// Splits a linear cell of a type that has a FaceTable.
  const std::vector<vtkIdType>& Split(
    int type, const std::vector<vtkIdType>& ids, const dvec3* points);

private:
  using FaceFinder = std::function<void(int face)>;

  void SplitLinear(const std::vector<vtkIdType>& ids, int numberOfFaces, const FaceFinder& findFace,
    const dvec3* points);

  std::vector<vtkIdType> Tetrahedra;
  std::vector<vtkIdType> Face;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> Points;
};
}

#endif
