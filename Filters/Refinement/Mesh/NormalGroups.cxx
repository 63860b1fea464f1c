// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/NormalGroups.h"

#include "Mathematics/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace relevo
{
void GroupNormals(const std::vector<vec3>& normals, float tolerance, std::vector<vtkIdType>& groups)
{
  const auto number = static_cast<vtkIdType>(normals.size());
  groups.assign(normals.size(), 0);
  if (number < 2)
  {
    return;
  }
  vec3 low = normals[0];
  vec3 high = normals[0];
  for (const vec3& normal : normals)
  {
    low = min(low, normal);
    high = max(high, normal);
  }
  const vec3 extent = high - low;
  const float squaredTolerance = tolerance * tolerance;
  if (dot(extent, extent) <= squaredTolerance)
  {
    return;
  }
  // After sorting along the axis of the largest extent, only neighbours need to be compared.
  const int axis =
    extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
  std::vector<vtkIdType> order(normals.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](vtkIdType l, vtkIdType r) { return normals[l][axis] < normals[r][axis]; });
  DisjointSets sets(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    const vec3& normal = normals[order[i]];
    for (vtkIdType k = i + 1; k < number && normals[order[k]][axis] - normal[axis] <= tolerance;
         ++k)
    {
      const vec3 difference = normals[order[k]] - normal;
      if (dot(difference, difference) <= squaredTolerance)
      {
        sets.Unite(order[i], order[k]);
      }
    }
  }
  for (vtkIdType i = 0; i < number; ++i)
  {
    groups[i] = sets.Find(i);
  }
}
}
