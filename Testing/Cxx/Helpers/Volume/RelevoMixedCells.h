// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh of linear cells of all kinds.
#ifndef RelevoMixedCells_h
#define RelevoMixedCells_h

#include "RelevoVolumes.h"

// A cube from 0 to 1, shifted by x along the x axis, of n^3 cubes whose inner corners are moved by
// up to a share of a cube's side: hexahedra, polyhedra, and pairs of wedges and of pyramids, with
// points in random order.
vtkSmartPointer<vtkUnstructuredGrid> MakeMixedCells(
  int n, unsigned int seed, double share, double x = 0.0);

#endif
