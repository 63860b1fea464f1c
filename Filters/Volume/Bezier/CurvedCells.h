// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedCells
 * @brief   the curved cells of data sets, converted to Bézier hexahedra
 *
 * Private to the modules.
 */
#ifndef CurvedCells_h
#define CurvedCells_h

#include "Bezier/BezierHexahedron.h"
#include "Bezier/CurvedCellConversion.h"
#include "Integral/ScalarTable.h"
#include "Mesh/CellCounts.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <vector>

namespace relevo
{
/// A Bézier hexahedron that is a cell or a part of one.
struct CurvedPart
{
  BezierHexahedron Shape;
  vtkIdType Scalars; // of the cell, or -1 for point scalars
  bool IsGhost;
  vtkIdType Source; // number of the input cell, over all data sets
};

class RELEVOFILTERSVOLUME_EXPORT CurvedCells
{
public:
  struct Cell
  {
    CurvedCellType Type; // IsHalved is not used
    size_t FirstNode;    // in GetNodes()
    vtkIdType Scalars;   // of the cell, or -1 for point scalars
    bool IsGhost;
    bool IsRational;
    vtkIdType Source; // number of the input cell, over all data sets
  };

  /// The points and scalars of the data sets. Weights are empty if there are none.
  struct Points
  {
    const std::vector<dvec3>& Positions;
    const ScalarTable& Values;
    const ScalarTable& CellValues;
    const std::vector<double>& Weights;
  };

  /// Adds a cell with the ids of its nodes.
  void Add(Cell cell, const std::vector<vtkIdType>& nodes);
  bool IsEmpty() const { return this->Cells.empty(); }

  /// Whether all cells are quadratic tetrahedra, which need no conversion.
  bool AreQuadraticTetrahedra() const;
  const std::vector<Cell>& GetCells() const { return this->Cells; }
  const vtkIdType* GetNodes(const Cell& cell) const { return &this->Nodes[cell.FirstNode]; }
  /// Removes the cells, but not their parts.
  void Clear();

  /// Converts the cells. Cells without volume, and with scalars that are not finite, are left out.
  /// Counts those that are not ghosts, except as solid cells.
  void Convert(const Points& points, int numberOfScalars, CellCounts& counts);

  std::vector<CurvedPart>& GetParts() { return this->Parts; }
  const std::vector<CurvedPart>& GetParts() const { return this->Parts; }

private:
  struct Jacobians;
  bool HasScalars(const Cell& cell, const Points& points) const;
  std::vector<BezierHexahedron> Convert(const Cell& cell, const CurvedCellConversion& conversion,
    const Points& points, int numberOfScalars) const;
  void AddParts(const Cell& cell, std::vector<BezierHexahedron>&& parts, const Jacobians& jacobians,
    CellCounts::Counts& counts);

  std::vector<Cell> Cells;
  std::vector<vtkIdType> Nodes;
  std::vector<CurvedPart> Parts;
  bool IsHalved = false;
};
}

#endif
