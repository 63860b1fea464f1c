// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's pickers on a scene and on its twin, which draws the output of vtkAdaptiveRefinementFilter.
#ifndef RelevoPickers_h
#define RelevoPickers_h

#include "RelevoScene.h"

#include "vtkCellPicker.h"

#include <array>
#include <functional>
#include <string>

namespace RelevoPickers
{
// Number of lines that may differ because they graze a silhouette within rounding.
struct Tolerance
{
  double Position = 1e-5; // relative to the size of the object
  double Normal = 1e-4;
  int Lines = 0;
};

// Draws a refined mesh seen along the z axis.
void DrawFromFront(RelevoScene& scene, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe);

// The pixel that shows a point.
std::array<double, 2> ToDisplay(vtkRenderer* renderer, double x, double y, double z);

double GetLength(vtkRenderer* renderer);

// The input's cell that a pick in either scene found.
vtkIdType GetInputCell(vtkCellPicker* picker);

using Check = std::function<bool(vtkCellPicker*, vtkCellPicker*)>;

// Picks along random lines in both scenes, which have the same camera. Returns the number of hits,
// or -1 if the scenes differ. `more` checks lines that hit.
int Compare(RelevoScene& refining, RelevoScene& twin, int lines, const std::string& name,
  const Tolerance& tolerance = Tolerance(), const std::function<void(vtkCellPicker*)>& setUp = {},
  const Check& more = {});
}

#endif
