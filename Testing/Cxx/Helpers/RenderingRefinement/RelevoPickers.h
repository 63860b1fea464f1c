// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's pickers on a scene and on its twin, which draws what vtkAdaptiveRefinementFilter makes.
#ifndef RelevoPickers_h
#define RelevoPickers_h

#include "RelevoScene.h"

#include "vtkCellPicker.h"

#include <array>
#include <functional>
#include <string>

namespace RelevoPickers
{
// How many of the lines may differ: those that graze an outline within rounding.
struct Tolerance
{
  double Position = 1e-5; // of the length of what is seen
  double Normal = 1e-4;
  int Lines = 0;
};

// Draws a refined mesh as it is seen along the z axis.
void DrawFromFront(RelevoScene& scene, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe);

// The pixel in which a point is seen.
std::array<double, 2> ToDisplay(vtkRenderer* renderer, double x, double y, double z);

double GetLength(vtkRenderer* renderer);

// The input's cell that a pick on either scene has found.
vtkIdType GetInputCell(vtkCellPicker* picker);

using Check = std::function<bool(vtkCellPicker*, vtkCellPicker*)>;

// Picks both scenes, whose cameras are the same, along random lines. Returns how many hit, or -1
// where they differ. `more` is asked of lines that hit.
int Compare(RelevoScene& refining, RelevoScene& twin, int lines, const std::string& name,
  const Tolerance& tolerance = Tolerance(), const std::function<void(vtkCellPicker*)>& setUp = {},
  const Check& more = {});
}

#endif
