// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   joins the sections of cells in polygonal meshes
 *
 * Private to the module.
 */
#ifndef SectionOutput_h
#define SectionOutput_h

#include "Sections/CellCutter.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkImplicitFunction;
class vtkPolyData;

namespace relevo
{
/// Store the polygons and the lines with their data. `cells` has the cell of each section. Return
/// the names of arrays that are too short and skipped.
std::vector<std::string> StoreSections(const std::vector<CellSection>& sections,
  const std::vector<vtkIdType>& cells, vtkDataSet* input, vtkImplicitFunction* function,
  vtkPolyData* polygons, vtkPolyData* lines);
}

#endif
