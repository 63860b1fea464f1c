// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which cells of a data set are sound, and what is wrong with the others
 *
 * Classes that take unstructured cells check them here first, and leave out those with faults.
 * VTK reads the lists of cells without checks, so nothing else may look at a cell before.
 *
 * Private to the modules' own sources.
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
  /// Quadratic polygons and convex point sets too, which have no list of faces.
  bool TakesAllTypes = false;
  /// Cells with points that are not finite, which the class counts itself.
  bool TakesInfinitePoints = false;
  /// Cells that are blanked.
  bool TakesHiddenCells = false;
};

struct CellChecks
{
  std::vector<CellUse> Uses; // for each cell
  std::vector<std::string> Errors;
};

/// One sentence for each kind of fault, with its first cell and how many others there are.
RELEVOFILTERSCORE_EXPORT CellChecks CheckCells(vtkDataSet* data, const CellDemands& demands = {});
}

#endif
