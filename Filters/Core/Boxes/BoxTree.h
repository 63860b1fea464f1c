// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BoxTree
 * @brief   a bounding volume hierarchy of items, such as triangles, faces or cells
 *
 * A binary tree, split at the median of the centers along their longest axis. When the items have
 * moved, Fit() takes their new boxes and keeps the tree. Its bounds are exact after any motion.
 * T is the type of coordinates and Id that of item numbers.
 *
 * Private to the modules' own sources.
 */
#ifndef BoxTree_h
#define BoxTree_h

#include "Boxes/BoundingBox.h"
#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::nth_element
#include <array>     // for stacks
#include <cmath>     // for std::isfinite
#include <cstddef>   // for std::size_t
#include <numeric>   // for std::iota
#include <utility>   // for std::swap
#include <vector>    // for members

namespace relevo
{
template <typename T, typename Id>
class BoxTree
{
public:
  using Box = BoundingBox<T>;
  struct Node
  {
    Box Bounds;
    Id First; // position of its items; of an inner node the second child, the first follows it
    Id Count; // of items; 0 for an inner node
  };

  /// Sort items with these boxes into a tree whose leaves have at most `maximumPerLeaf` items.
  void Build(const std::vector<Box>& boxes, Id maximumPerLeaf = 4);
  /// Take new boxes of the same items.
  void Fit(const std::vector<Box>& boxes);

  const std::vector<Node>& GetNodes() const { return this->Nodes; }
  /// The items, sorted so that those of each node are adjacent.
  const std::vector<Id>& GetItems() const { return this->Items; }
  /// The item at a position in GetItems(), and its box.
  Id GetItem(Id position) const { return this->Items[position]; }
  const Box& GetBox(Id position) const { return this->Boxes[position]; }

  /// Whether a box intersects that of any item.
  bool Intersects(const Box& box) const;

  /**
   * Call visit(item) for items whose boxes are not farther than `nearest`, which visit() may lower.
   * The nearest child of a node comes first. getDistance(box, nearest) returns more than `nearest`
   * for boxes that need not be visited.
   */
  template <typename GetDistance, typename Visitor>
  void Visit(double& nearest, const GetDistance& getDistance, const Visitor& visit) const;

private:
  using Centers = std::vector<std::array<T, 3>>;

  void Split(const Centers& centers, Id first, Id last, Id maximumPerLeaf);

  // The two halves of a node are equal. No tree that fits into memory is as deep as this.
  static constexpr int StackSize = 128;

  std::vector<Node> Nodes; // parents before their children
  std::vector<Id> Items;
  std::vector<Box> Boxes; // of items, by position
};

template <typename T, typename Id>
void BoxTree<T, Id>::Build(const std::vector<Box>& boxes, Id maximumPerLeaf)
{
  this->Items.resize(boxes.size());
  std::iota(this->Items.begin(), this->Items.end(), Id(0));
  Centers centers(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const T center = T(0.5) * boxes[i].Low[c] + T(0.5) * boxes[i].High[c];
      centers[i][c] = std::isfinite(center) ? center : T(0); // NaN cannot be sorted
    }
  }
  this->Nodes.clear();
  if (!boxes.empty())
  {
    this->Split(centers, 0, static_cast<Id>(boxes.size()), maximumPerLeaf);
  }
  this->Fit(boxes);
}

template <typename T, typename Id>
void BoxTree<T, Id>::Split(const Centers& centers, Id first, Id last, Id maximumPerLeaf)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.push_back({ {}, first, last - first });
  if (last - first <= maximumPerLeaf)
  {
    return;
  }
  Box box;
  for (Id i = first; i < last; ++i)
  {
    box.Add(centers[this->Items[i]].data());
  }
  const int axis = box.GetLongestAxis();
  const Id half = first + (last - first) / 2;
  std::nth_element(this->Items.begin() + first, this->Items.begin() + half,
    this->Items.begin() + last,
    [&](Id a, Id b)
    { return centers[a][axis] != centers[b][axis] ? centers[a][axis] < centers[b][axis] : a < b; });
  this->Split(centers, first, half, maximumPerLeaf);
  this->Nodes[index].First = static_cast<Id>(this->Nodes.size());
  this->Nodes[index].Count = 0;
  this->Split(centers, half, last, maximumPerLeaf);
}

template <typename T, typename Id>
void BoxTree<T, Id>::Fit(const std::vector<Box>& boxes)
{
  this->Boxes.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    this->Boxes[i] = boxes[this->Items[i]];
  }
  // Children come after their parents.
  for (std::size_t n = this->Nodes.size(); n-- > 0;)
  {
    Node& node = this->Nodes[n];
    node.Bounds = {};
    for (Id i = node.First; i < node.First + node.Count; ++i)
    {
      node.Bounds.Add(this->Boxes[i]);
    }
    if (node.Count == 0)
    {
      node.Bounds = this->Nodes[n + 1].Bounds;
      node.Bounds.Add(this->Nodes[node.First].Bounds);
    }
  }
}

template <typename T, typename Id>
bool BoxTree<T, Id>::Intersects(const Box& box) const
{
  std::array<Id, StackSize> stack;
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const Id n = stack[--size];
    const Node& node = this->Nodes[n];
    if (!node.Bounds.Intersects(box))
    {
      continue;
    }
    for (Id i = node.First; i < node.First + node.Count; ++i)
    {
      if (this->Boxes[i].Intersects(box))
      {
        return true;
      }
    }
    if (node.Count == 0)
    {
      stack[size++] = node.First;
      stack[size++] = n + 1;
    }
  }
  return false;
}

template <typename T, typename Id>
template <typename GetDistance, typename Visitor>
void BoxTree<T, Id>::Visit(
  double& nearest, const GetDistance& getDistance, const Visitor& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  struct Pending
  {
    Id Node;
    double Distance;
  };
  std::array<Pending, StackSize> stack;
  int size = 0;
  stack[size++] = { 0, getDistance(this->Nodes[0].Bounds, nearest) };
  while (size > 0)
  {
    const Pending pending = stack[--size];
    if (pending.Distance > nearest)
    {
      continue;
    }
    const Node& node = this->Nodes[pending.Node];
    for (Id i = node.First; i < node.First + node.Count; ++i)
    {
      if (getDistance(this->Boxes[i], nearest) <= nearest)
      {
        visit(this->Items[i]);
      }
    }
    if (node.Count == 0)
    {
      Pending first = { pending.Node + 1,
        getDistance(this->Nodes[pending.Node + 1].Bounds, nearest) };
      Pending second = { node.First, getDistance(this->Nodes[node.First].Bounds, nearest) };
      if (second.Distance < first.Distance)
      {
        std::swap(first, second);
      }
      stack[size++] = second;
      stack[size++] = first;
    }
  }
}

using FloatBox = BoundingBox<float>;
using FloatBoxTree = BoxTree<float, int>;
using DoubleBox = BoundingBox<double>;
using DoubleBoxTree = BoxTree<double, vtkIdType>;
}

#endif
