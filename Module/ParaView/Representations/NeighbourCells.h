// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the cells around a piece that other ranks have
 *
 * vtkGhostCellsGenerator is not used, because it lacks most neighbours of scattered pieces.
 *
 * Private to the module.
 */
#ifndef NeighbourCells_h
#define NeighbourCells_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkMultiProcessController;

namespace relevo
{
/**
 * Return a composite data set of a piece and a block of ghost cells: the cells of other ranks that
 * have a point of the piece's surface and this point array. A piece that has ghost cells gets none.
 * Without neighbours, the piece is returned. Collective.
 */
vtkSmartPointer<vtkDataObject> AddNeighbourCells(
  vtkDataObject* piece, const std::string& array, vtkMultiProcessController* controller);
}

#endif
