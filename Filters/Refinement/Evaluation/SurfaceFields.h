// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceFields
 * @brief   point data that a surface evaluates itself instead of linear interpolation
 */
#ifndef SurfaceFields_h
#define SurfaceFields_h

#include "Evaluation/RefinedTopology.h"
#include "vtkRefinementSurface.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkPointData;

namespace relevo
{
class SurfaceFields
{
public:
  /// Find the fields of a mesh's point data for the arrays with the same names in `to`. The surface
  /// may be nullptr. For noDataMagnitude, see NoDataTuples.
  SurfaceFields(
    vtkRefinementSurface* surface, vtkPolyData* mesh, double noDataMagnitude, vtkPointData* to);

  /// Can be called from several threads for different points.
  void Evaluate(
    const vtkRefinementSurface::Face& face, const std::vector<RefinedPoint>& points) const;

  bool IsEmpty() const { return this->Fields.empty(); }

private:
  struct Field
  {
    vtkSmartPointer<vtkDataArray> Coefficients;
    vtkDataArray* Values;
  };
  vtkRefinementSurface* Surface;
  std::vector<Field> Fields;
};
}

#endif
