// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceDiagonal.h"

#include "Core/WorldView.h"
#include "Mesh/SurfaceTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
SurfaceDiagonal::SurfaceDiagonal(vtkPolyData* mesh, const SurfaceTriangles& surface)
{
  if (surface.GetTriangles().empty())
  {
    GetFiniteSides(mesh, this->Sides);
    return;
  }
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

double SurfaceDiagonal::Get(const Placement& placement) const
{
  return placement.GetDiagonal(this->Sides);
}
}
