// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the second layer of ghost faces, where it is further away than a neighbouring piece
 *
 * vtkGhostCellsGenerator gives a piece the faces around it from pieces that touch it. The faces
 * around those may be of pieces that do not, where pieces are scattered.
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
/// A cell array that tells all faces of all processes from each other.
constexpr const char* FaceIds = "relevo::FaceIds";

/// Add it to the pieces of this process, and change nothing else of them. Collective.
void AddFaceIds(
  const std::vector<vtkSmartPointer<vtkPolyData>>& own, vtkMultiProcessController* controller);

/**
 * Give pieces with ghosts the faces that are missing around them, whichever process has them.
 * `own` are the same pieces without ghosts; all have FaceIds. Collective; the controller may be
 * nullptr.
 */
void CompleteSecondLayer(const std::vector<vtkSmartPointer<vtkPolyData>>& own,
  std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkMultiProcessController* controller);
}

#endif
