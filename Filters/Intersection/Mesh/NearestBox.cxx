// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/NearestBox.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
constexpr double Beyond = 2.0;

// Divides lengths by `reach`, whose square may overflow or underflow.
double GetSquare(const DoubleBox& box, const double point[3], double reach)
{
  double square = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double gap = std::max({ box.Low[c] - point[c], point[c] - box.High[c], 0.0 });
    if (gap > 0.0)
    {
      square += (gap / reach) * (gap / reach);
    }
  }
  return square;
}
}

double GetBoxDistance(const DoubleBoxTree& tree, const double point[3], double reach)
{
  const std::vector<DoubleBoxTree::Node>& nodes = tree.GetNodes();
  if (nodes.empty() || !std::isfinite(point[0]) || !std::isfinite(point[1]) ||
    !std::isfinite(point[2]))
  {
    return Beyond;
  }
  double nearest = Beyond * Beyond;
  // The tree is balanced, so that this depth is sufficient for any number of boxes.
  vtkIdType stack[128];
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const vtkIdType n = stack[--size];
    const DoubleBoxTree::Node& node = nodes[n];
    const double square = GetSquare(node.Bounds, point, reach);
    if (!(square <= 1.0) || square >= nearest)
    {
      continue;
    }
    for (vtkIdType i = node.First; i < node.First + node.Count; ++i)
    {
      nearest = std::min(nearest, GetSquare(tree.GetBox(i), point, reach));
    }
    if (node.Count == 0)
    {
      stack[size++] = node.First;
      stack[size++] = n + 1;
    }
  }
  return nearest <= 1.0 ? std::sqrt(nearest) : Beyond;
}
}
