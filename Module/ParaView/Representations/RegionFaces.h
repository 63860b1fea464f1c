// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the faces that a process needs to draw its region of space
 *
 * Private to the module.
 */
#ifndef RegionFaces_h
#define RegionFaces_h

#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkAdaptiveRefinement;
class vtkDataObjectTree;
class vtkMatrix4x4;
class vtkMultiProcessController;

namespace relevo
{
/**
 * Return the whole cells of all processes whose refined surface may lie in this process's region,
 * and at least the faces around them as ghosts (vtkGhostType has
 * vtkDataSetAttributes::DUPLICATECELL). Their order is the same on all processes. Regions are those
 * of all processes, in world coordinates; an invalid region gets no cells. The matrix transforms
 * the data to world coordinates.
 *
 * `tree` has the process's own cells and the ghosts around them; it does not change. In the result,
 * each surface's cells are in its first leaf. Collective: every process calls it with a tree of the
 * same blocks, which may be empty or nullptr. Return nullptr if the data cannot be sent.
 */
vtkSmartPointer<vtkDataObjectTree> GatherRegionFaces(vtkDataObjectTree* tree,
  vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix, const std::vector<vtkBoundingBox>& regions,
  vtkMultiProcessController* controller);
}

#endif
