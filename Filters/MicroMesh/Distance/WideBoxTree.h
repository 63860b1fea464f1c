// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WideBoxTree
 * @brief   a bounding volume hierarchy with four children per node
 *
 * The boxes of the children of a node are stored by coordinate, so that the compiler tests all four
 * with vector instructions. Ranges of items are split at the median of the centers along their
 * longest axis. BoxTree is for items that move; this tree is for many searches in items that do
 * not.
 */
#ifndef WideBoxTree_h
#define WideBoxTree_h

#include "Boxes/BoundingBox.h"
#include "Boxes/BoxTree.h" // for FloatBox

#include <algorithm> // for std::nth_element
#include <array>     // for members
#include <cstddef>   // for std::size_t
#include <numeric>   // for std::iota
#include <utility>   // for std::swap
#include <vector>    // for members

namespace relevo
{
class WideBoxTree
{
public:
  static constexpr int Width = 4;
  using Lanes = std::array<float, Width>;
  struct Node
  {
    Node()
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Low[c].fill(FloatBox::Infinity);
        this->High[c].fill(-FloatBox::Infinity);
      }
    }
    std::array<Lanes, 3> Low;
    std::array<Lanes, 3> High;
    std::array<int, Width> Firsts{ {} }; // position of its items, or the node; 0 for no child
    std::array<int, Width> Counts{ {} }; // of items; 0 for a node
  };

  /// Sort items into a tree. getBox(item) returns a box.
  template <typename GetBox>
  void Build(int number, const GetBox& getBox);

  /**
   * Call visit(item) for items of boxes that are not farther than `nearest`, which visit() may
   * lower. The nearest children come first. getDistances(node, lanes) computes the distances of the
   * children's boxes.
   */
  template <typename GetDistances, typename Visitor>
  void Visit(double& nearest, const GetDistances& getDistances, const Visitor& visit) const;

  /// Call visit(item) for items of boxes that intersect a box, until it returns false.
  template <typename Visitor>
  void VisitIntersecting(const FloatBox& box, const Visitor& visit) const;

private:
  using Centers = std::vector<std::array<float, 3>>;
  struct Range
  {
    int First;
    int Last;
  };

  template <typename GetBox>
  FloatBox Split(const Centers& centers, Range range, const GetBox& getBox);
  Range Halve(const Centers& centers, Range& range);
  static std::size_t CountNodes(int number);

  static constexpr int LeafSize = 4;
  // Nodes at most this deep, with up to three siblings waiting at each level.
  static constexpr int StackSize = 128;

  std::vector<Node> Nodes;
  std::vector<int> Items;
};

// The nodes that Split() makes for a number of items.
inline std::size_t WideBoxTree::CountNodes(int number)
{
  std::array<int, Width> counts{ { number, 0, 0, 0 } };
  for (int step = Width / 2; step > 0; step /= 2)
  {
    for (int i = 0; i < Width; i += 2 * step)
    {
      int& whole = counts[static_cast<std::size_t>(i)];
      if (whole > LeafSize)
      {
        counts[static_cast<std::size_t>(i + step)] = whole - whole / 2;
        whole /= 2;
      }
    }
  }
  std::size_t nodes = 1;
  for (int count : counts)
  {
    nodes += count > LeafSize ? CountNodes(count) : 0;
  }
  return nodes;
}

// Keeps the first half and returns the second.
inline WideBoxTree::Range WideBoxTree::Halve(const Centers& centers, Range& range)
{
  FloatBox box;
  for (int i = range.First; i < range.Last; ++i)
  {
    box.Add(centers[static_cast<std::size_t>(this->Items[static_cast<std::size_t>(i)])].data());
  }
  const auto axis = static_cast<std::size_t>(box.GetLongestAxis());
  const int half = range.First + (range.Last - range.First) / 2;
  std::nth_element(this->Items.begin() + range.First, this->Items.begin() + half,
    this->Items.begin() + range.Last,
    [&](int a, int b)
    {
      const float first = centers[static_cast<std::size_t>(a)][axis];
      const float second = centers[static_cast<std::size_t>(b)][axis];
      return first != second ? first < second : a < b;
    });
  const Range second{ half, range.Last };
  range.Last = half;
  return second;
}

template <typename GetBox>
FloatBox WideBoxTree::Split(const Centers& centers, Range range, const GetBox& getBox)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  std::array<Range, Width> ranges{ { range, { 0, 0 }, { 0, 0 }, { 0, 0 } } };
  for (int step = Width / 2; step > 0; step /= 2)
  {
    for (int i = 0; i < Width; i += 2 * step)
    {
      Range& whole = ranges[static_cast<std::size_t>(i)];
      if (whole.Last - whole.First > LeafSize)
      {
        ranges[static_cast<std::size_t>(i + step)] = this->Halve(centers, whole);
      }
    }
  }
  FloatBox all;
  for (std::size_t i = 0; i < Width; ++i)
  {
    const int count = ranges[i].Last - ranges[i].First;
    if (count == 0)
    {
      continue;
    }
    const bool isLeaf = count <= LeafSize;
    const int first = isLeaf ? ranges[i].First : static_cast<int>(this->Nodes.size());
    FloatBox box;
    if (isLeaf)
    {
      for (int k = ranges[i].First; k < ranges[i].Last; ++k)
      {
        box.Add(getBox(this->Items[static_cast<std::size_t>(k)]));
      }
    }
    else
    {
      box = this->Split(centers, ranges[i], getBox);
    }
    Node& node = this->Nodes[index];
    node.Firsts[i] = first;
    node.Counts[i] = isLeaf ? count : 0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      node.Low[c][i] = box.Low[c];
      node.High[c][i] = box.High[c];
    }
    all.Add(box);
  }
  return all;
}

template <typename GetBox>
void WideBoxTree::Build(int number, const GetBox& getBox)
{
  this->Nodes.clear();
  this->Items.resize(static_cast<std::size_t>(number));
  std::iota(this->Items.begin(), this->Items.end(), 0);
  Centers centers(this->Items.size());
  for (int i = 0; i < number; ++i)
  {
    const FloatBox box = getBox(i);
    for (std::size_t c = 0; c < 3; ++c)
    {
      centers[static_cast<std::size_t>(i)][c] = 0.5f * box.Low[c] + 0.5f * box.High[c];
    }
  }
  if (number > 0)
  {
    this->Nodes.reserve(CountNodes(number));
    this->Split(centers, { 0, number }, getBox);
  }
}

template <typename GetDistances, typename Visitor>
void WideBoxTree::Visit(
  double& nearest, const GetDistances& getDistances, const Visitor& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  struct Pending
  {
    int Node;
    float Distance;
  };
  std::array<Pending, StackSize> stack;
  std::size_t size = 0;
  stack[size++] = { 0, 0.0f };
  while (size > 0)
  {
    const Pending pending = stack[--size];
    if (double(pending.Distance) > nearest)
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(pending.Node)];
    Lanes distances;
    getDistances(node, distances);
    std::array<int, Width> order{ { 0, 1, 2, 3 } };
    const auto sortPair = [&](std::size_t a, std::size_t b)
    {
      if (distances[static_cast<std::size_t>(order[b])] <
        distances[static_cast<std::size_t>(order[a])])
      {
        std::swap(order[a], order[b]);
      }
    };
    sortPair(0, 1);
    sortPair(2, 3);
    sortPair(0, 2);
    sortPair(1, 3);
    sortPair(1, 2);
    for (int lane : order)
    {
      const auto i = static_cast<std::size_t>(lane);
      for (int k = 0; k < node.Counts[i] && double(distances[i]) <= nearest; ++k)
      {
        visit(this->Items[static_cast<std::size_t>(node.Firsts[i] + k)]);
      }
    }
    for (std::size_t k = Width; k-- > 0;)
    {
      const auto i = static_cast<std::size_t>(order[k]);
      if (node.Counts[i] == 0 && node.Firsts[i] > 0 && double(distances[i]) <= nearest)
      {
        stack[size++] = { node.Firsts[i], distances[i] };
      }
    }
  }
}

template <typename Visitor>
void WideBoxTree::VisitIntersecting(const FloatBox& box, const Visitor& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  std::array<int, StackSize> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(stack[--size])];
    std::array<int, Width> isHit;
    for (std::size_t i = 0; i < Width; ++i)
    {
      isHit[i] = (node.Low[0][i] <= box.High[0] ? 1 : 0) & (box.Low[0] <= node.High[0][i] ? 1 : 0) &
        (node.Low[1][i] <= box.High[1] ? 1 : 0) & (box.Low[1] <= node.High[1][i] ? 1 : 0) &
        (node.Low[2][i] <= box.High[2] ? 1 : 0) & (box.Low[2] <= node.High[2][i] ? 1 : 0);
    }
    for (std::size_t i = 0; i < Width; ++i)
    {
      if (isHit[i] == 0)
      {
        continue;
      }
      for (int k = 0; k < node.Counts[i]; ++k)
      {
        if (!visit(this->Items[static_cast<std::size_t>(node.Firsts[i] + k)]))
        {
          return;
        }
      }
      if (node.Counts[i] == 0)
      {
        stack[size++] = node.Firsts[i];
      }
    }
  }
}
}

#endif
