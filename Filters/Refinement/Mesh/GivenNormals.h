// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the normals stored with a mesh, which may lack a direction at some points
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
/// Return the normals of all points, or nullptr if the array does not have their number.
inline vtkDataArray* GetGivenNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  return normals && normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() >= mesh->GetNumberOfPoints()
    ? normals
    : nullptr;
}

/// Get the unit vector of the normal at a point and return its original length. If that is zero or
/// not finite, there is no normal.
inline double GetUnitNormal(vtkDataArray* normals, vtkIdType point, double normal[3])
{
  normals->GetTuple(point, normal);
  return vtkMath::Normalize(normal);
}

inline bool IsLengthOfNormal(double length)
{
  return std::isfinite(length) && length > 0.0;
}

/// Whether normals cannot be used for drawing a refined mesh: they have no direction, or vertices
/// and lines use them unchanged and their length is not 1.
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
