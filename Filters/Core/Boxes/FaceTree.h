// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceTree
 * @brief   a bounding volume hierarchy over the faces or cells of a mesh
 *
 * This is a binary tree of boxes, split at the median of the longest axis. Faces are visited in
 * order of the distance of their boxes. The visit ends when the nearest result is nearer than all
 * remaining boxes.
 */
#ifndef FaceTree_h
#define FaceTree_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <algorithm> // for std::swap
#include <array>     // for members
#include <vector>    // for members

namespace relevo
{
struct FaceBox
{
  std::array<float, 3> Low;
  std::array<float, 3> High;
};

/// A segment to intersect with boxes: the points Start + t Direction with t in [0, 1].
struct RELEVOFILTERSCORE_EXPORT BoxSegment
{
  BoxSegment(const double start[3], const double end[3], double margin);
  /// The parameter t where the segment enters a box that is enlarged by the margin. It is more than
  /// `last` if the segment does not enter the box before `last`.
  double GetEntry(const FaceBox& box, double last) const;

  double Start[3];
  double Inverse[3]; // 1 / direction
  bool Still[3];     // components of the direction that are 0
  double Margin;
};

class RELEVOFILTERSCORE_EXPORT FaceTree
{
public:
  /// Build the tree with at most this number of faces per leaf.
  void Build(std::vector<FaceBox> boxes, int maximumPerLeaf = 4);

  /**
   * Call visit(face) for the faces whose boxes are within `nearest`, which visit may reduce.
   * getDistance(box, nearest) returns more than nearest for boxes to skip.
   */
  template <typename GetDistance, typename Visitor>
  void Visit(double& nearest, const GetDistance& getDistance, const Visitor& visit) const;

  struct Node
  {
    FaceBox Box;
    int First; // leaf: first face in the order; inner node: second child (the first one follows)
    int Count; // number of faces; 0 for inner nodes
  };
  const std::vector<Node>& GetNodes() const { return this->Nodes; }
  const std::vector<int>& GetOrder() const { return this->Order; }

  const FaceBox& GetBox(int face) const { return this->Boxes[face]; }
  bool IsEmpty() const { return this->Boxes.empty(); }

private:
  void Split(int first, int last, int maximumPerLeaf);

  std::vector<FaceBox> Boxes;
  std::vector<int> Order;
  std::vector<Node> Nodes;
};

template <typename GetDistance, typename Visitor>
void FaceTree::Visit(double& nearest, const GetDistance& getDistance, const Visitor& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  struct Pending
  {
    int Node;
    double Distance;
  };
  std::array<Pending, 64> stack; // the depth is 31 for 2^31 faces
  int size = 0;
  stack[size++] = { 0, getDistance(this->Nodes[0].Box, nearest) };
  while (size > 0)
  {
    const Pending pending = stack[--size];
    if (pending.Distance > nearest)
    {
      continue;
    }
    const Node& node = this->Nodes[pending.Node];
    for (int i = 0; i < node.Count; ++i)
    {
      const int face = this->Order[node.First + i];
      if (getDistance(this->Boxes[face], nearest) <= nearest)
      {
        visit(face);
      }
    }
    if (node.Count == 0)
    {
      Pending first = { pending.Node + 1, getDistance(this->Nodes[pending.Node + 1].Box, nearest) };
      Pending second = { node.First, getDistance(this->Nodes[node.First].Box, nearest) };
      if (second.Distance < first.Distance)
      {
        std::swap(first, second);
      }
      stack[size++] = second;
      stack[size++] = first;
    }
  }
}
}

#endif
