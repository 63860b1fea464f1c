// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/NetAngles.h"

#include "Mathematics/TriangleIndex.h"
#include "Mesh/PatchArrays.h"
#include "View/WorldView.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Returns 0 if a normal is degenerate.
double GetAngle(const dvec3& a, const dvec3& b)
{
  const bool isDegenerate = a == dvec3(0.0) || b == dvec3(0.0);
  return isDegenerate ? 0.0
                      : vtkMath::DegreesFromRadians(std::atan2(length(cross(a, b)), dot(a, b)));
}

double MeasureQuads(const PatchArrays& patches, const Patch& patch)
{
  const int width = patch.Degrees.x;
  const int height = patch.Degrees.y;
  const auto getNormal = [&](int i, int j)
  {
    const auto at = [&](int k, int l)
    { return dvec3(patches.GetPoint(patch.FirstPoint + l * (width + 1) + k)); };
    return UnitOrZero(cross(at(i + 1, j + 1) - at(i, j), at(i, j + 1) - at(i + 1, j)));
  };
  double largest = 0.0;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const dvec3 normal = getNormal(i, j);
      largest = i > 0 ? std::max(largest, GetAngle(normal, getNormal(i - 1, j))) : largest;
      largest = j > 0 ? std::max(largest, GetAngle(normal, getNormal(i, j - 1))) : largest;
    }
  }
  return largest;
}

// Each inverted triangle shares its sides with upright triangles.
double MeasureTriangles(const PatchArrays& patches, const Patch& patch)
{
  const int degree = patch.Degrees.x;
  const auto at = [&](int i, int j)
  {
    const auto index = static_cast<vtkIdType>(GetTriangleIndex(degree, i, j));
    return dvec3(patches.GetPoint(patch.FirstPoint + index));
  };
  const auto getNormal = [&](int i, int j)
  { return UnitOrZero(cross(at(i + 1, j) - at(i, j), at(i, j + 1) - at(i, j))); };
  double largest = 0.0;
  for (int j = 0; j < degree; ++j)
  {
    for (int i = 0; i + j + 1 < degree; ++i)
    {
      const dvec3 normal =
        UnitOrZero(cross(at(i + 1, j + 1) - at(i + 1, j), at(i, j + 1) - at(i + 1, j)));
      largest = std::max({ largest, GetAngle(normal, getNormal(i, j)),
        GetAngle(normal, getNormal(i + 1, j)), GetAngle(normal, getNormal(i, j + 1)) });
    }
  }
  return largest;
}
}

double ComputeNetAngle(const PatchArrays& patches, const Patch& patch)
{
  return patch.IsTriangle ? MeasureTriangles(patches, patch) : MeasureQuads(patches, patch);
}
}
