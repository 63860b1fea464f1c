// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the faces around a piece of a surface that other pieces have
 *
 * Faces are neighbours if they have corners at the same position. vtkGhostCellsGenerator is not
 * used: it merges points at borders, and so loses split normals and texture coordinates. With
 * scattered pieces it also lacks faces of pieces that touch only the first layer.
 *
 * Private to the module.
 */
#ifndef GhostFaces_h
#define GhostFaces_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
/**
 * Add layers of ghost faces (vtkGhostType has vtkDataSetAttributes::DUPLICATECELL) around pieces of
 * one surface, which have polygons only. Each piece's own points and faces stay the first, with
 * their data. The points of ghosts are not shared with them. A piece without neighbours stays the
 * same object. Collective; without a controller (nullptr), this process has all pieces.
 */
void AddGhostFaces(std::vector<vtkSmartPointer<vtkPolyData>>& pieces, int numberOfLayers,
  vtkMultiProcessController* controller);
}

#endif
