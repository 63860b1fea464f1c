// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes the mesh of a height map of any size
 */
#ifndef TerrainExport_h
#define TerrainExport_h

#include "Options/ViewerOptions.h"

#include <string>

class ViewerMessages;
class vtkCamera;
class vtkTerrainMapper;

/**
 * Writes the terrain of a mapper: within the tolerance of the options, or without one, as the
 * camera sees it. Prints the number of triangles, their error and their coordinates on stdout.
 * Throws ViewerError.
 */
void ExportTerrain(const ViewerOptions& options, vtkTerrainMapper* mapper, vtkCamera* camera,
  const std::string& fileName, ViewerMessages& messages);

#endif
