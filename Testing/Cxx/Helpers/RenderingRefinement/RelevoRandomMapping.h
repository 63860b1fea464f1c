// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random scalars, tables of colours and settings of mappers, for RelevoRandomScene.h.
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
// A setting, to be given to every mapper that draws the same.
using Setting = std::function<void(vtkPolyDataMapper*)>;

// What some of a scene's choices leave to others.
struct Limits
{
  bool IsTranslucent = false; // by a table
  bool HasOtherCells = false; // than faces
  // At level 2 faces are drawn in another order than the filter's. Of points that faces share, the
  // last one drawn is seen: are they of different colours or normals?
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

// Values in [-2, 12], whole numbers or not; smooth over the points or not.
vtkSmartPointer<vtkDataArray> MakeScalars(
  const Choice& choice, vtkPolyData* mesh, vtkIdType count, bool ofPoints);

vtkSmartPointer<vtkScalarsToColors> MakeLookupTable(const Choice& choice);

vtkSmartPointer<vtkScalarsToColors> MakeFunction(const Choice& choice);

// A colour for each of some whole numbers, in turn, and none for others.
vtkSmartPointer<vtkScalarsToColors> MakeCategories(const Choice& choice);

vtkSmartPointer<vtkScalarsToColors> MakeTable(const Choice& choice);

// Scalars of the mesh; which of them count is the mapper's choice.
void AddScalars(const Choice& choice, vtkPolyData* mesh);

void AddColorSettings(const Choice& choice, std::vector<Setting>& settings);
}

#endif
