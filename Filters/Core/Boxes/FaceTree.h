// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceTree
 * @brief   a bounding volume hierarchy over the faces, or the cells, of a mesh
 *
 * A binary tree of boxes, split at the median of the longest axis. Faces are visited nearest box
 * first, and no longer once what was found is nearer than the boxes that are left.
 *
 * Private to the modules' own sources.
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

/// A segment that boxes are tested against: points Start + t Direction with t in [0, 1].
struct RELEVOFILTERSCORE_EXPORT BoxSegment
{
  BoxSegment(const double start[3], const double end[3], double margin);
  /// Where the segment enters a box, widened by the margin; more than `last` where it does not
  /// before that.
  double GetEntry(const FaceBox& box, double last) const;

  double Start[3];
  double Inverse[3]; // of the direction
  bool Still[3];     // directions of zero
  double Margin;
};

class RELEVOFILTERSCORE_EXPORT FaceTree
{
public:
  /// Leaves have at most so many faces.
  void Build(std::vector<FaceBox> boxes, int maximumPerLeaf = 4);

  /**
   * Call visit(face) for faces whose boxes `getDistance` finds no farther than `nearest`, which
   * visit may lower. getDistance(box, nearest) gives more than nearest for what need not be
   * visited.
   */
  template <typename GetDistance, typename Visitor>
  void Visit(double& nearest, const GetDistance& getDistance, const Visitor& visit) const;

  struct Node
  {
    FaceBox Box;
    int First; // of its faces in the order; of an inner node the second child, the first follows it
    int Count; // of faces; 0 for an inner node
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
  std::array<Pending, 64> stack; // a median split of 2^31 faces is 31 deep
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
