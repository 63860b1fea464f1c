// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   extracts and appends cells of meshes
 *
 * Not wrapped: for the sources of the plugin.
 */
#ifndef CellSubset_h
#define CellSubset_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"             // for results

#include <vector> // for what is kept

class vtkPolyData;

namespace relevo
{
/// Return the kept cells, their points, and the data of both, including vtkGhostType.
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkPolyData> ExtractCells(
  vtkPolyData* mesh, const std::vector<bool>& kept);

/// Append the non-empty meshes, with the field data of the first; nullptr if there are none.
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkPolyData> AppendMeshes(
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

/// Set the vtkDataSetAttributes::CellGhostTypes of each cell.
RELEVOPARAVIEWFILTERS_EXPORT void SetGhostTypes(
  vtkPolyData* mesh, const std::vector<unsigned char>& types);
}

#endif
