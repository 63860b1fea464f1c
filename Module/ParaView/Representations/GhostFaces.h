// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the faces of other processes around a process's own
 *
 * Private to the module.
 */
#ifndef GhostFaces_h
#define GhostFaces_h

class vtkDataObjectTree;
class vtkMultiProcessController;

namespace relevo
{
/**
 * Give every surface of a tree one layer of the faces around it that other processes, or other
 * partitions of it, have: their vtkGhostType has vtkDataSetAttributes::DUPLICATECELL. Own points,
 * vertices and lines stay as they are, strips become triangles. Collective: every process calls it,
 * with a tree of the same blocks, which may be empty or nullptr.
 */
void AddGhostFaces(vtkDataObjectTree* tree, vtkMultiProcessController* controller);
}

#endif
