// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the normals that a mesh comes with, which may lack a direction at some points
 */
#ifndef GivenNormals_h
#define GivenNormals_h

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

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

/// Makes a unit vector of the normal at a point, and returns the length that it had. It is none
/// where that is zero or not finite.
inline double GetUnitNormal(vtkDataArray* normals, vtkIdType point, double normal[3])
{
  normals->GetTuple(point, normal);
  return vtkMath::Normalize(normal);
}

inline bool IsLengthOfNormal(double length)
{
  return std::isfinite(length) && length > 0.0;
}

/// Whether there are normals that a refined mesh cannot be drawn with: without a direction, or,
/// where vertices and lines take them as they are, of another length than 1.
inline bool NeedsUnitNormals(vtkPolyData* mesh)
{
  constexpr double rounding = 1e-4;
  const bool isRefinedAlone = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() == 0;
  vtkDataArray* normals = GetGivenNormals(mesh);
  double normal[3];
  for (vtkIdType i = 0; normals && i < mesh->GetNumberOfPoints(); ++i)
  {
    const double length = GetUnitNormal(normals, i, normal);
    if (!IsLengthOfNormal(length) || !(isRefinedAlone || std::abs(length - 1.0) < rounding))
    {
      return true;
    }
  }
  return false;
}
}

#endif
