// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshProbe
 * @brief   cells of a mesh, and values of its array, at points of the refined surface
 */
#ifndef MeshProbe_h
#define MeshProbe_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkAdaptiveRefinement;
class vtkDataArray;
class vtkGenericCell;
class vtkObject;
class vtkPolyData;
class vtkRefinedCellLocator;
class vtkRenderer;

class MeshProbe
{
public:
  /// Takes an array of the mesh's points or cells, or nullptr, and the mesh's recipe.
  MeshProbe(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, vtkDataArray* array, bool isOfPoints);
  ~MeshProbe();

  /// Returns the cell of the mesh that the renderer's camera sees at a point, or -1, and all
  /// components of the array there.
  vtkIdType Find(const double place[3], vtkRenderer* renderer, std::vector<double>& value);

private:
  /// The visible coarse cell at a point, or -1, and the weights of its points.
  vtkIdType FindFace(
    const double place[3], vtkRenderer* renderer, vtkGenericCell* cell, double* weights);
  void Ignore(vtkObject*, unsigned long, void*) {}

  vtkSmartPointer<vtkDataArray> Array;
  bool IsOfPoints;
  vtkNew<vtkRefinedCellLocator> Locator;
};

#endif
