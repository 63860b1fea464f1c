// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the second layer of ghost faces, if it is in a piece that is not a neighbour
 *
 * vtkGhostCellsGenerator adds faces around a piece from pieces that touch it. With scattered
 * pieces, the faces around those may be in pieces that do not touch it.
 *
 * Private to the module.
 */
#ifndef SecondLayer_h
#define SecondLayer_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
/// A cell array with unique ids of all faces of all processes.
constexpr const char* FaceIds = "relevo::FaceIds";

/// Add FaceIds to the pieces of this process, and change nothing else. Collective.
void AddFaceIds(
  const std::vector<vtkSmartPointer<vtkPolyData>>& own, vtkMultiProcessController* controller);

/**
 * Add the missing faces around pieces with ghosts from all processes. `own` are the same pieces
 * without ghosts; all have FaceIds. Collective; the controller may be nullptr.
 */
void CompleteSecondLayer(const std::vector<vtkSmartPointer<vtkPolyData>>& own,
  std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkMultiProcessController* controller);
}

#endif
