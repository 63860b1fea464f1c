// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceNormals.h"

#include "vtkSMPTools.h"

#include <utility>

namespace relevo
{
SurfaceNormals::SurfaceNormals(std::shared_ptr<const SurfaceTriangles> surface)
  : Triangles(std::move(surface))
{
  const std::vector<SurfaceTriangles::Triangle>& triangles = this->Triangles->GetTriangles();
  this->AreaVectors.resize(triangles.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        dvec3 corners[3];
        for (int corner = 0; corner < 3; ++corner)
        {
          this->Triangles->GetPoint(triangles[t][corner], &corners[corner][0]);
        }
        this->AreaVectors[t] = cross(corners[1] - corners[0], corners[2] - corners[0]);
      }
    });
}

dvec3 SurfaceNormals::GetAreaVectorAt(vtkIdType mergedPoint) const
{
  dvec3 sum(0.0);
  this->Triangles->ForEachTriangleIndex(
    mergedPoint, [&](vtkIdType t) { sum += this->AreaVectors[t]; });
  return sum;
}
}
