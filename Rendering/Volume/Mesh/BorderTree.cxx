// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BorderTree.h"

namespace relevo
{
// The node after a missed node is the sibling of a first child; otherwise, it is the node after its
// parent.
std::vector<float> FlattenTree(const FloatBoxTree& tree, float margin)
{
  const std::vector<FloatBoxTree::Node>& nodes = tree.GetNodes();
  std::vector<int> next(nodes.size(), static_cast<int>(nodes.size()));
  std::vector<float> flat;
  flat.reserve(8 * nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i)
  {
    const FloatBoxTree::Node& node = nodes[i];
    if (node.Count == 0)
    {
      next[i + 1] = node.First;
      next[node.First] = next[i];
    }
    for (float low : node.Bounds.Low)
    {
      flat.push_back(low - margin);
    }
    flat.push_back(static_cast<float>(node.Count == 0 ? next[i] : node.First));
    for (float high : node.Bounds.High)
    {
      flat.push_back(high + margin);
    }
    flat.push_back(static_cast<float>(node.Count));
  }
  return flat;
}
}
