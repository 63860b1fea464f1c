// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceDiagonal.h"

#include "Core/WorldView.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
double SurfaceDiagonal::Get(vtkPolyData* mesh, const Placement& placement)
{
  const GeometryStamp stamp = MakeGeometryStamp(mesh);
  if (stamp != this->Of)
  {
    this->Of = stamp;
    this->Compute(mesh);
  }
  return this->HasTriangles ? placement.GetDiagonal(this->Sides) : placement.GetDiagonal(mesh);
}

void SurfaceDiagonal::Compute(vtkPolyData* mesh)
{
  const SurfaceTriangles surface(mesh);
  this->HasTriangles = !surface.GetTriangles().empty();
  double low[3];
  double high[3];
  std::fill_n(low, 3, std::numeric_limits<double>::infinity());
  std::fill_n(high, 3, -std::numeric_limits<double>::infinity());
  for (const SurfaceTriangles::Triangle& triangle : surface.GetTriangles())
  {
    for (vtkIdType corner : triangle)
    {
      double point[3];
      surface.GetPoint(corner, point);
      for (int axis = 0; axis < 3; ++axis)
      {
        if (std::isfinite(point[axis]))
        {
          low[axis] = std::min(low[axis], point[axis]);
          high[axis] = std::max(high[axis], point[axis]);
        }
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Sides[axis] = std::max(high[axis] - low[axis], 0.0);
  }
}
}
