// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   conversion of faces to Bézier patches
 *
 * Private to the module.
 */
#ifndef ControlNets_h
#define ControlNets_h

#include "Cells/FaceNodes.h"
#include "Cells/PatchEvaluation.h"

class vtkDataArray;
class vtkUnstructuredGrid;

namespace relevo
{
class ControlNets
{
public:
  explicit ControlNets(NodeNets&& nodes);

  /// Returns the patches. If there is a triangle with a node in the middle, quadratic cells are
  /// raised to its degree, 3, so that shared edges are bitwise identical.
  const std::vector<FacePatch>& GetPatches() const { return this->Patches; }
  vtkIdType GetNumberOfControlPoints() const { return this->NumberOfControlPoints; }
  /// Returns the grid point at a corner of a patch.
  vtkIdType GetCornerPoint(std::size_t patch, int corner) const;

  /// Returns the coefficients of a point array, with all components of each control point together.
  std::vector<double> Convert(vtkDataArray* array) const;
  /// Returns x, y, z, not multiplied by the weight, and the weight.
  std::vector<dvec4> ConvertPoints(vtkUnstructuredGrid* grid) const;

  /// Removes the patches whose `isKept` is 0.
  void Keep(const std::vector<unsigned char>& isKept);

private:
  void NumberPatches();

  NodeNets Nodes;
  bool RaisesDegrees = false;
  std::vector<FacePatch> Patches;
  vtkIdType NumberOfControlPoints = 0;
};
}

#endif
