// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   curved faces as polygons, which pieces of surfaces can exchange
 *
 * A polygon has the nodes of a curved 2D cell as points, in VTK's order. Cell arrays have its type
 * and degrees, and a point array has the weights of nodes. Polygons without these arrays are linear
 * faces.
 *
 * Not wrapped: for the sources of the plugin.
 */
#ifndef FacePolygons_h
#define FacePolygons_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"             // for results
#include "vtkType.h"                     // for vtkIdType

class vtkPolyData;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace relevo
{
/// The ids of the cells and points of a data set, which its faces keep.
constexpr const char* OriginalCellIdsName = "vtkOriginalCellIds";
constexpr const char* OriginalPointIdsName = "vtkOriginalPointIds";

/// Return polygons for the faces that vtkCurvedFaceFilter extracts from a grid, except for ghosts.
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkPolyData> MakeFacePolygons(
  vtkUnstructuredGrid* faces, vtkUnstructuredGrid* grid);

/// Return the 2D cells of polygons, without vertices and lines. Their original ids have other
/// names until RestoreOriginalIds().
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> MakeFaceGrid(
  vtkPolyData* polygons);

/// Give a mesh that was made from a face grid the original ids of the faces' cells.
RELEVOPARAVIEWFILTERS_EXPORT void RestoreOriginalIds(vtkPolyData* mesh);

/// The corners of polygons, which are the first points of curved faces.
class FaceCornerCounter
{
public:
  explicit FaceCornerCounter(vtkPolyData* polygons);
  /// `cell` has `size` points.
  vtkIdType Count(vtkIdType cell, vtkIdType size) const;
  /// Whether the face is that of a 3D cell.
  bool IsOfSolid(vtkIdType cell) const;
  bool HasTypes() const { return this->Types != nullptr; }

private:
  vtkUnsignedCharArray* Types;
  vtkUnsignedCharArray* Solids;
};

/// Return polygons with the corners alone, without data. They have the same points.
vtkSmartPointer<vtkPolyData> MakeCornerPolygons(vtkPolyData* polygons);
}

#endif
