// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds inner faces of a mesh of 3D cells that is distributed over pieces
 *
 * Private to the module.
 */
#ifndef SharedFaces_h
#define SharedFaces_h

#include "vtkSmartPointer.h"

#include <vector>

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
}

#endif
