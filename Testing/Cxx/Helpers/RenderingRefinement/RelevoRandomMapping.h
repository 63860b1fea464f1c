// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random scalars, lookup tables and mapper settings for RelevoRandomScene.h.
#ifndef RelevoRandomMapping_h
#define RelevoRandomMapping_h

#include "RelevoDice.h"
#include "RelevoTestMeshes.h"

#include "vtkPolyDataMapper.h"
#include "vtkScalarsToColors.h"

#include <functional>
#include <ostream>
#include <vector>

namespace RelevoRandomMapping
{
// A setting for every mapper that draws the same.
using Setting = std::function<void(vtkPolyDataMapper*)>;

// Limits that some choices of a scene set for others.
struct Limits
{
  bool IsTranslucent = false; // because of a lookup table
  bool HasOtherCells = false; // cells that are not faces
  // At level 2, faces are drawn in another order than the filter's, and the last point drawn at a
  // shared position is visible. Tells whether such points have different colours or normals.
  bool HasTies = false;
};

struct Choice
{
  RelevoDice& Dice;
  std::ostream& Log;
  int Level;
  RelevoRandomMapping::Limits& Limits;
};

vtkSmartPointer<vtkDataArray> MakeNumbers(RelevoDice& dice);

// Values in [-2, 12], integers or not, smooth over the points or not.
vtkSmartPointer<vtkDataArray> MakeScalars(
  const Choice& choice, vtkPolyData* mesh, vtkIdType count, bool ofPoints);

vtkSmartPointer<vtkScalarsToColors> MakeLookupTable(const Choice& choice);

vtkSmartPointer<vtkScalarsToColors> MakeFunction(const Choice& choice);

// A colour for each of some integers, in turn, and none for others.
vtkSmartPointer<vtkScalarsToColors> MakeCategories(const Choice& choice);

vtkSmartPointer<vtkScalarsToColors> MakeTable(const Choice& choice);

// Adds scalars to the mesh. The mapper selects among them.
void AddScalars(const Choice& choice, vtkPolyData* mesh);

void AddColorSettings(const Choice& choice, std::vector<Setting>& settings);
}

#endif
