// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the triangles of a bisected terrain as polydata
 *
 * Private to the modules for terrains.
 */
#ifndef FaceMesh_h
#define FaceMesh_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <string>

class vtkPolyData;

namespace relevo
{
class AdaptiveTerrain;

/// Output the faces that a terrain has selected, with the arrays of vtkTerrainMeshSource.
RELEVOFILTERSTERRAIN_EXPORT void MakeFaceMesh(
  const AdaptiveTerrain& terrain, double exaggeration, vtkPolyData* output);

/// Return why a terrain on a globe cannot have a base at a height: it is beyond the centre. Else
/// "".
RELEVOFILTERSTERRAIN_EXPORT std::string FindBaseError(
  const AdaptiveTerrain& terrain, double exaggeration, double base);

/// Close such a mesh, or another one of the terrain, with walls and a bottom at a height.
RELEVOFILTERSTERRAIN_EXPORT void AddBase(
  const AdaptiveTerrain& terrain, double exaggeration, double base, vtkPolyData* mesh);
}

#endif
