// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   checks the cells of a data set and describes faults
 *
 * Classes for unstructured cells call these checks first and skip cells with faults. VTK reads the
 * lists of cells without checks, so no cell may be read before.
 */
#ifndef CellChecks_h
#define CellChecks_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace relevo
{
enum class CellUse : unsigned char
{
  None, // points, lines, and cells with faults
  Surface,
  Solid
};

/// The cells that a class accepts.
struct CellDemands
{
  /// Accept quadratic polygons and convex point sets, which have no list of faces.
  bool TakesAllTypes = false;
  /// Accept cells with non-finite points; the class counts them.
  bool TakesInfinitePoints = false;
  /// Accept blanked cells.
  bool TakesHiddenCells = false;
};

struct CellChecks
{
  std::vector<CellUse> Uses; // per cell
  std::vector<std::string> Errors;
};

/// Check the cells. There is one error per kind of fault, with its first cell and the number of
/// other cells.
RELEVOFILTERSCORE_EXPORT CellChecks CheckCells(vtkDataSet* data, const CellDemands& demands = {});
}

#endif
