// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the normals that a mesh comes with, which may lack a direction at some points
 *
 * Not wrapped: for the modules' own sources.
 */
#ifndef GivenNormals_h
#define GivenNormals_h

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

#ifndef __VTK_WRAP__
namespace relevo
{
/// Normals of all points, or null: an array that took another's name and place may have any size.
inline vtkDataArray* GetGivenNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  return normals && normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() >= mesh->GetNumberOfPoints()
    ? normals
    : nullptr;
}

/// Makes a unit vector of the normal at a point. False where it is zero or not finite.
inline bool GetUnitNormal(vtkDataArray* normals, vtkIdType point, double normal[3])
{
  normals->GetTuple(point, normal);
  const double length = vtkMath::Normalize(normal);
  return std::isfinite(length) && length > 0.0;
}

/// Whether there are normals, but no direction at some of the points.
inline bool MissesNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = GetGivenNormals(mesh);
  double normal[3];
  for (vtkIdType i = 0; normals && i < mesh->GetNumberOfPoints(); ++i)
  {
    if (!GetUnitNormal(normals, i, normal))
    {
      return true;
    }
  }
  return false;
}
}
#endif

#endif
