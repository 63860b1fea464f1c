// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshProbe
 * @brief   values of a mesh's array at places of the refined surface
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
  /// An array of the mesh's points or cells, and what the mesh is refined to.
  MeshProbe(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, vtkDataArray* array, bool isOfPoints);
  ~MeshProbe();

  /// All components, of the face that the renderer's camera sees at a place; none where there is
  /// no face.
  std::vector<double> GetValue(const double place[3], vtkRenderer* renderer);

private:
  /// The coarse cell seen at a place, -1 for none, and its points' shares.
  vtkIdType FindFace(
    const double place[3], vtkRenderer* renderer, vtkGenericCell* cell, double* weights);
  void Ignore(vtkObject*, unsigned long, void*) {}

  vtkSmartPointer<vtkDataArray> Array;
  bool IsOfPoints;
  vtkNew<vtkRefinedCellLocator> Locator;
};

#endif
