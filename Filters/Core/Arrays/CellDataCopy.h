// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   cell data of what is made of a data set's cells
 *
 * Private to the modules' own sources.
 */
#ifndef CellDataCopy_h
#define CellDataCopy_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>
#include <vector>

class vtkCellData;
class vtkDataSet;
class vtkIdTypeArray;

namespace relevo
{
/**
 * Gives each new cell the data of the input's cell that `originals` names, and these ids as
 * "vtkOriginalCellIds". Global ids become a plain array. Arrays too short for the input's cells are
 * left out: their names go to the end of `shortArrays`.
 */
RELEVOFILTERSCORE_EXPORT void CopyCellData(vtkDataSet* input, vtkIdTypeArray* originals,
  bool keepNormals, vtkCellData* to, std::vector<std::string>& shortArrays);
}

#endif
