// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshProbe
 * @brief   values of a mesh's array by place
 */
#ifndef MeshProbe_h
#define MeshProbe_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkStaticCellLocator;

class MeshProbe
{
public:
  /// An array of the mesh's points or cells.
  MeshProbe(vtkPolyData* mesh, vtkDataArray* array, bool isOfPoints);
  ~MeshProbe();

  /// All components, on the coarse face that is nearest; none where there is no face.
  std::vector<double> GetValue(const double place[3]);

private:
  vtkSmartPointer<vtkDataArray> Array;
  bool IsOfPoints;
  vtkNew<vtkStaticCellLocator> Locator;
};

#endif
