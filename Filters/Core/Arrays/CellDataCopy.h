// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   copies cell data to cells that are created from a data set's cells
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
 * Copy to each new cell the data of the input's cell in `originals`, and add these ids as
 * "vtkOriginalCellIds". Global ids become an ordinary array. Arrays with fewer tuples than the
 * input has cells are skipped, and their names are appended to `shortArrays`.
 */
RELEVOFILTERSCORE_EXPORT void CopyCellData(vtkDataSet* input, vtkIdTypeArray* originals,
  bool keepNormals, vtkCellData* to, std::vector<std::string>& shortArrays);
}

#endif
