// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeCells
 * @brief   the cells of data sets that rays pass through, with their scalars
 *
 * Contains the 3D cells that are neither ghosts nor blanked. Ghost cells with point scalars, which
 * belong to another piece, are stored separately for gradients. Cells without volume, and cells
 * with scalars or points that are not finite, are skipped. Other linear cells without a CellShape
 * are split into tetrahedra by a CellSplitter. Curved cells are converted to Bézier hexahedra,
 * which can be split into linear pieces.
 *
 * Private to the module.
 */
#ifndef VolumeCells_h
#define VolumeCells_h

#include "Bezier/CurvedCells.h"
#include "Cells/CornerIds.h"
#include "Cells/CurvedCell.h"
#include "Cells/ScalarChoice.h"
#include "Cells/TetrahedronCrossing.h"
#include "Cells/VolumeCellList.h"
#include "Integral/Ray.h"
#include "Integral/ScalarTable.h"
#include "Mesh/CellCounts.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <array>
#include <string> // for messages
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkGenericCell;
class vtkIdList;

namespace relevo
{
class CellReader;
class CellSplitter;
class PiecePoints;
struct SplitTolerances;

class RELEVOFILTERSVOLUME_EXPORT VolumeCells
{
public:
  using Cell = VolumeCell;

  /// Splits all cells into tetrahedra. Call this before Add().
  void SplitAll() { this->SplitsAll = true; }

  /// Refers to the lists of cells of the data sets instead of copying them. The data sets must not
  /// change as long as this object is in use. Call this before Add().
  void ReadInPlace() { this->ReadsInPlace = true; }

  /// Stores which input cell each cell comes from, see GetSource(). Call this before Add().
  void KeepSources() { this->KeepsSources = true; }

  /**
   * Adds the cells of a data set. The array has a tuple for each point or each cell. Returns the
   * messages of CheckCells() about invalid cells, which are skipped.
   */
  std::vector<std::string> Add(
    vtkDataSet* mesh, vtkDataArray* array, bool isOfCells, const ScalarChoice& choice);

  /// Converts curved cells. Call this after all data sets have been added. If they are quadratic
  /// tetrahedra only, they become cells with a CellShape, unless all cells are split.
  void ConvertCurved();
  /// The converted curved cells.
  const std::vector<CurvedPart>& GetCurvedParts() const { return this->Curved.GetParts(); }
  bool HasCurvedParts() const { return !this->Curved.GetParts().empty(); }
  /// Replaces them by linear pieces. Returns whether the tolerances were met with the largest
  /// number of pieces.
  bool SplitCurved(const SplitTolerances& tolerances);

  /// Moves the points so that the centre of the bounding box of the cells is at the origin. Call
  /// this after all data sets have been added.
  void MoveToOrigin();
  //@{
  /// The centre before the move, and the diagonal of the box. Valid after MoveToOrigin().
  const dvec3& GetMiddle() const { return this->Middle; }
  double GetDiagonal() const { return this->Diagonal; }
  //@}

  /// The counts of the data sets, in the order of Add(). Those of curved cells are complete after
  /// ConvertCurved().
  const CellCounts& GetCounts() const { return this->Counts; }

  //@{
  /**
   * The cells after splitting, and their corners. Points are in their original position before
   * MoveToOrigin().
   */
  const VolumeCellList& GetCells() const { return this->Cells; }
  const VolumeCellList& GetGhosts() const { return this->Ghosts; }
  int GetNumberOfCorners(const Cell& cell) const;
  vtkIdType GetCornerId(const Cell& cell, int i) const;
  const std::vector<dvec3>& GetPoints() const { return this->Points; }
  const ScalarTable& GetPointScalars() const { return this->PointScalars; }
  /// Replaces the scalars of all points by finite ones.
  void SetPointScalars(ScalarTable scalars) { this->PointScalars = std::move(scalars); }
  const ScalarTable& GetCellScalars() const { return this->CellScalars; }
  TetrahedronCorners GetTetrahedron(const Cell& cell) const;
  CurvedCell GetCurved(const Cell& cell) const;
  //@}

  /// Returns the number of the input cell, over all data sets, of one of GetCells() or, with higher
  /// numbers, of GetCurvedParts(). Needs KeepSources().
  vtkIdType GetSource(size_t number) const;

  /// Whether there are cells and the first one has a cell scalar.
  bool HasCellScalars() const;
  /// Computes the range of a component over all cells; low is greater than high without cells.
  void GetRange(int component, double& low, double& high) const;

  /// Computes gradients of the first components of point scalars from the slopes of the corners.
  Gradients ComputeGradients(
    const Cell& cell, const CornerSlopes& slopes, int numberOfComponents = MaximumComponents) const;

private:
  class Source;

  void AddWeights(vtkDataSet* mesh);
  bool AddWhole(int type, const std::vector<vtkIdType>& ids, const Source& source);
  bool AddCurved(const CellReader& reader, const Source& source);
  void AddLinear(vtkGenericCell* cell, const Source& source, CellSplitter& splitter);
  bool AddInPlace(int type, vtkIdType number, vtkIdType count, const Source& source);
  bool AddCell(const CellShape* shape, const std::vector<vtkIdType>& corners, vtkIdType scalars,
    vtkIdType source, VolumeCellList& all);
  bool Accept(const Cell& cell, vtkIdType source, VolumeCellList& all);
  void Count(vtkIdType cell, bool isGhost, bool isGood, size_t before);
  void AddPieces(const CurvedPart& part, const ivec3& counts, PiecePoints& points,
    const std::vector<BezierPoint>& lattice, CellSplitter& splitter);
  void AddPiece(std::vector<vtkIdType>& corners, const CurvedPart& part, CellSplitter& splitter);
  bool AreFinite(const vtkIdType* points, vtkIdType count) const;
  bool HasVolume(const Cell& cell) const;
  bool HasScalars(const Cell& cell) const;

  std::vector<dvec3> Points;
  ScalarTable PointScalars;
  ScalarTable CellScalars;
  std::vector<double> Weights; // of points; empty if there are none
  int NumberOfScalars = 1;     // of those that are used
  CurvedCells Curved;
  bool SplitsAll = false;
  bool KeepsSources = false;
  bool ReadsInPlace = false;
  vtkIdType NumberOfInputCells = 0; // of all data sets
  std::vector<vtkIdType> Sources;   // of Cells, if they are kept
  CornerIds Corners;
  VolumeCellList Cells;
  VolumeCellList Ghosts;
  dvec3 Middle = dvec3(0.0);
  double Diagonal = 0.0;
  CellCounts Counts;
  bool LacksScalars = false; // a part of the cell being added has scalars that are not finite
};
}

#endif
