// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the faces that a process needs to draw its part of space
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
 * The cells of all processes of which anything that the recipe can make may lie in this process's
 * region, whole, and as ghosts (vtkGhostType has vtkDataSetAttributes::DUPLICATECELL) at least the
 * faces around them. They come in the same order on all processes. Regions are those of all
 * processes, in world coordinates; an invalid one gets nothing. The matrix leads from the data's
 * coordinates to the world.
 *
 * `tree` has a process's own cells, and the ghosts around them; it stays as it is. Each surface's
 * cells are in its first leaf then. Collective: every process calls it, with a tree of the same
 * blocks, which may be empty or nullptr. nullptr if the data cannot be sent.
 */
vtkSmartPointer<vtkDataObjectTree> GatherRegionFaces(vtkDataObjectTree* tree,
  vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix, const std::vector<vtkBoundingBox>& regions,
  vtkMultiProcessController* controller);
}

#endif
