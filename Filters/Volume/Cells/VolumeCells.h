// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeCells
 * @brief   the cells of data sets that rays pass through, with their scalars
 *
 * 3D cells that are neither ghosts nor blanked. Cells with scalars or points that are not finite
 * are left out, and those without volume. Cells without a CellShape are split into tetrahedra
 * by a CellSplitter.
 *
 * Private to the module's own sources.
 */
#ifndef VolumeCells_h
#define VolumeCells_h

#include "Cells/CurvedCell.h"
#include "Cells/Ray.h"
#include "Cells/ScalarChoice.h"
#include "Cells/TetrahedronCrossing.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <array>
#include <string> // for faults
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkIdList;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT VolumeCells
{
public:
  struct Cell
  {
    const CellShape* Shape; // null for tetrahedra
    size_t FirstCorner;     // in Corners
    vtkIdType Scalars;      // of cells, else -1
  };

  /// Before cells are added: all of them are split into tetrahedra.
  void SplitAll() { this->SplitsAll = true; }

  /**
   * Add the cells of a data set. The array has a tuple for each point, or each cell. Returns what
   * is wrong with cells that are left out, as CheckCells().
   */
  std::vector<std::string> Add(
    vtkDataSet* mesh, vtkDataArray* array, bool isOfCells, const ScalarChoice& choice);

  /// After all data sets have been added: move the points so that the middle of the cells' box is
  /// the origin.
  void MoveToOrigin();
  //@{
  /// Where the middle was, and the diagonal of the box; after MoveToOrigin().
  const dvec3& GetMiddle() const { return this->Middle; }
  double GetDiagonal() const { return this->Diagonal; }
  //@}

  /// All 3D cells without faults that are neither ghosts nor blanked.
  vtkIdType GetNumberOfSolidCells() const { return this->NumberOfSolidCells; }
  /// Of these, those of no volume or with coordinates that are not finite.
  vtkIdType GetNumberOfBadCells() const { return this->NumberOfBadCells; }
  /// Of them, those that are seen: neither bad nor with scalars that are not finite.
  vtkIdType GetNumberOfDrawnCells() const { return this->NumberOfDrawnCells; }

  //@{
  /**
   * What was added: cells, after splitting, and their corners among the points. Points are where
   * they were, until MoveToOrigin().
   */
  const std::vector<Cell>& GetCells() const { return this->Cells; }
  int GetNumberOfCorners(const Cell& cell) const;
  vtkIdType GetCornerId(const Cell& cell, int i) const;
  const std::vector<dvec3>& GetPoints() const { return this->Points; }
  const std::vector<Scalars>& GetPointScalars() const { return this->PointScalars; }
  const std::vector<Scalars>& GetCellScalars() const { return this->CellScalars; }
  TetrahedronCorners GetTetrahedron(const Cell& cell) const;
  CurvedCell GetCurved(const Cell& cell) const;
  //@}

  /// Whether there are cells, and the first has scalars of its own.
  bool HasCellScalars() const { return !this->Cells.empty() && this->Cells.front().Scalars >= 0; }
  /// The lowest and highest scalar of the cells; low is above high if there are none.
  void GetRange(int component, double& low, double& high) const;

  /// By the slopes of corners, of scalars of points.
  Gradients ComputeGradients(const Cell& cell, const CornerSlopes& slopes) const;

private:
  bool AddCell(const CellShape* shape, const std::vector<vtkIdType>& corners, vtkIdType scalars);
  bool AreFinite(vtkIdList* points, vtkIdType firstPoint) const;
  bool HasVolume(const Cell& cell) const;
  bool HasScalars(const Cell& cell) const;

  std::vector<dvec3> Points;
  std::vector<Scalars> PointScalars;
  std::vector<Scalars> CellScalars;
  bool SplitsAll = false;
  std::vector<vtkIdType> Corners;
  std::vector<Cell> Cells;
  dvec3 Middle = dvec3(0.0);
  double Diagonal = 0.0;
  vtkIdType NumberOfSolidCells = 0;
  vtkIdType NumberOfBadCells = 0;
  vtkIdType NumberOfDrawnCells = 0;
};
}

#endif
