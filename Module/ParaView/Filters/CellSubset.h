// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   some of the cells of a mesh
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
/// The cells that are kept, their points, and the data of both, vtkGhostType among them.
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkPolyData> ExtractCells(
  vtkPolyData* mesh, const std::vector<bool>& kept);

/// What is left of meshes put together, with the field data of the first; nullptr for none.
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkPolyData> AppendMeshes(
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

/// Say of each cell what vtkDataSetAttributes::CellGhostTypes it has.
RELEVOPARAVIEWFILTERS_EXPORT void SetGhostTypes(
  vtkPolyData* mesh, const std::vector<unsigned char>& types);
}

#endif
