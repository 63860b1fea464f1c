// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellCutter
 * @brief   cuts 3D cells of a data set with an implicit function, curved cells along their shape
 *
 * Private to the module. Each thread needs its own object.
 */
#ifndef CellCutter_h
#define CellCutter_h

#include "Bezier/CurvedCellConversion.h"
#include "Sections/CellSection.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <vector>

class vtkDataSet;
class vtkIdList;
class vtkImplicitFunction;

namespace relevo
{
class CellReader;
class FieldScales;
struct CellKind;

/// The largest errors of the pieces of curved cells.
struct SectionTolerances
{
  double Shape; // length
  double Field; // share of the ranges of the fields
  const FieldScales& Fields;
};

class CellCutter
{
public:
  /// `values` has the function at each point of the data set.
  CellCutter(vtkDataSet* data, vtkImplicitFunction* function, const std::vector<double>& values,
    const SectionTolerances& tolerances);
  ~CellCutter();

  /// Whether the function can change its sign in the cell.
  bool CanCut(vtkIdType cell);
  /// Prepares the conversion of a cell if it is curved.
  void Prepare(vtkIdType cell, CurvedCellConversion& conversion);
  CellSection Cut(vtkIdType cell, const CurvedCellConversion& conversion);

private:
  void CutLinear(vtkIdType cell, const CellKind& kind, CellSection& section);
  void CutCurved(const CurvedCellType& type, const CellKind& kind,
    const CurvedCellConversion& conversion, CellSection& section);
  std::vector<int> CountFieldIntervals(const CurvedCellType& type,
    const CurvedCellConversion& conversion, std::vector<CurvedNode> nodes,
    const std::vector<vtkIdType>& points, std::size_t numberOfParts) const;
  CellKind ReadCell(vtkIdType cell);
  CurvedCellType ReadType(vtkIdType cell, const CellKind& kind);

  vtkDataSet* Data;
  vtkImplicitFunction* Function;
  const std::vector<double>& Values;
  SectionTolerances Tolerances;
  std::map<int, PolyhedronFaces> Faces; // of the types of linear cells
  vtkNew<vtkIdList> Nodes;              // of the current cell
  std::unique_ptr<CellReader> Reader;   // nullptr without curved cells
};
}

#endif
