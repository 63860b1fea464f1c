// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshProbe
 * @brief   values of a mesh's array at points of the refined surface
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
  /// Takes an array of the mesh's points or cells, and the mesh's recipe.
  MeshProbe(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, vtkDataArray* array, bool isOfPoints);
  ~MeshProbe();

  /// All components at a point of the face that the renderer's camera sees. Empty if there is no
  /// face.
  std::vector<double> GetValue(const double place[3], vtkRenderer* renderer);

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
