// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// An octree as unstructured cells, whose points hang on edges and faces of larger cells.
#ifndef RelevoRefinedCells_h
#define RelevoRefinedCells_h

#include "RelevoVolumes.h"

class RelevoRefinedCells
{
public:
  // The cells fill a unit cube. Their array "field" has the values of Field at their points.
  // Refined cubes have cells of another type, if it is given.
  vtkSmartPointer<vtkUnstructuredGrid> Make(int type, int refinedType = 0) const;

  // 2^Coarse cubes along an edge. Those that touch a sphere are refined as often as Levels says.
  // Then other cells are up to 2^Levels times as large as their neighbours.
  int Coarse = 1;
  int Levels = 1;
  RelevoField Field = GetLinearField;
  // Moves points of the unit cube.
  std::function<RelevoPoint(const RelevoPoint&)> Move = [](const RelevoPoint& at) { return at; };
  bool IsFloat = false; // rounds points to floats
};

#endif
