// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   faces as Bézier patches
 *
 * Private to the module's own sources.
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

  /// If there is a triangle with a node in its middle, quadratic cells have its degree, 3: so
  /// edges that they have in common are the same to the bit.
  const std::vector<FacePatch>& GetPatches() const { return this->Patches; }
  vtkIdType GetNumberOfControlPoints() const { return this->NumberOfControlPoints; }
  /// The point of the grid at a patch's corner.
  vtkIdType GetCornerPoint(std::size_t patch, int corner) const;

  /// Coefficients of a point array, all components of a control point following one another.
  std::vector<double> Convert(vtkDataArray* array) const;
  /// x, y, z, not multiplied with the weight, and the weight.
  std::vector<dvec4> ConvertPoints(vtkUnstructuredGrid* grid) const;

  /// Leaves out the patches for which `isKept` has 0.
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
