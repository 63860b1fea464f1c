// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds faces that occur twice in a mesh that is distributed over pieces
 *
 * Not wrapped: for the sources of the plugin.
 */
#ifndef SharedFaces_h
#define SharedFaces_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"             // for results

#include <vector> // for pieces

class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
/**
 * Remove faces of 3D cells whose corners coincide with those of another such face. The pieces have
 * face polygons, see FacePolygons.h, and no ghosts. Collective; without a controller (nullptr),
 * this process has all pieces.
 */
void RemoveSharedFaces(
  std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkMultiProcessController* controller);

/// Return a mesh without the ghosts whose points coincide with those of another face of the mesh,
/// as in pieces that a view has merged. A mesh without such ghosts is returned itself.
RELEVOPARAVIEWFILTERS_EXPORT vtkSmartPointer<vtkPolyData> RemoveRepeatedGhosts(vtkPolyData* mesh);
}

#endif
