// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeCells
 * @brief   the cells of data sets that rays pass through, with their scalars
 *
 * 3D cells that are neither ghosts nor blanked. Cells with scalars or points that are not finite
 * are left out, and those without volume. Tetrahedra stay as they are, other cells are split into
 * tetrahedra (vtkCell::Triangulate).
 *
 * Private to the module's own sources.
 */
#ifndef VolumeCells_h
#define VolumeCells_h

#include "Cells/Ray.h"
#include "Cells/TetrahedronCrossing.h"
#include "Intersection/FaceTree.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace relevo
{
class VolumeCells
{
public:
  /**
   * Add the cells of a data set. The array has at most 4 components, and a tuple for each point, or
   * each cell; its values count times `scale`.
   */
  void Add(vtkDataSet* mesh, vtkDataArray* array, bool isOfCells, double scale);

  /// After all data sets have been added.
  void Build();

  /// What a ray of world coordinates passes through, from front to back. In several threads.
  std::vector<RayPart> Cross(const Ray& ray) const;

  /// All 3D cells that are neither ghosts nor blanked.
  vtkIdType GetNumberOfSolidCells() const { return this->NumberOfSolidCells; }
  /// Of these, those of no volume or with coordinates that are not finite.
  vtkIdType GetNumberOfBadCells() const { return this->NumberOfBadCells; }

private:
  struct Tetrahedron
  {
    std::array<vtkIdType, 4> Corners;
    vtkIdType Cell; // of scalars of cells, else -1
  };
  TetrahedronCorners GetCorners(const Tetrahedron& cell) const;
  bool AddTetrahedron(const Tetrahedron& cell);
  void CrossTetrahedron(const Tetrahedron& cell, const Ray& ray, std::vector<RayPart>& parts) const;

  std::vector<dvec3> Points;
  std::vector<Scalars> PointScalars;
  std::vector<Scalars> CellScalars;
  std::vector<Tetrahedron> Tetrahedra;
  FaceTree Tree;             // of cells
  dvec3 Center = dvec3(0.0); // of what points are relative to, once built
  double Margin = 0.0;
  vtkIdType NumberOfSolidCells = 0;
  vtkIdType NumberOfBadCells = 0;
};
}

#endif
