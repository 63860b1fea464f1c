// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DrapedOutput
 * @brief   the points and cells of draped polydata, with the attributes of the input
 *
 * Private to the modules for terrains.
 */
#ifndef DrapedOutput_h
#define DrapedOutput_h

#include "Draping/SurfacePoint.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace relevo
{
class DrapedOutput
{
public:
  /// Points are lifted by an offset in world units.
  DrapedOutput(vtkPolyData* input, double offset);

  /// A point whose attributes are weighted means of those of points of the input.
  struct Source
  {
    std::array<vtkIdType, 3> Ids;
    std::array<double, 3> Weights;
    int Count;
  };
  vtkIdType AddPoint(const SurfacePoint& point, const Source& source);

  /// Whether the height of a point is not that of another one, apart from rounding errors.
  bool IsStep(vtkIdType id, const SurfacePoint& point) const;

  enum Kinds
  {
    VERTICES,
    LINES,
    POLYGONS
  };
  /// Add a cell with the attributes of a cell of the input. Kinds must be in their order.
  void AddCell(Kinds kind, const std::vector<vtkIdType>& points, vtkIdType source);
  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->CellSources.size()); }

  void Finish(vtkPolyData* output);

private:
  vtkPolyData* Input;
  double Offset;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Heights;
  vtkNew<vtkPointData> PointData;
  vtkNew<vtkIdList> SourceIds;
  std::array<vtkNew<vtkCellArray>, 3> Cells;
  std::vector<vtkIdType> CellSources;
};
}

#endif
