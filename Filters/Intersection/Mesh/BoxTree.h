// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BoxTree
 * @brief   a bounding volume hierarchy in double precision for moving items
 *
 * A binary tree that is split at the median of the longest axis. When items have moved, Fit()
 * updates the boxes, but not the structure of the tree. Bounds are exact after any motion.
 *
 * Private to the module.
 */
#ifndef BoxTree_h
#define BoxTree_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::min
#include <array>     // for Box
#include <limits>    // for the empty box
#include <vector>    // for members

namespace relevo
{
struct Box
{
  std::array<double, 3> Low{ { Infinity, Infinity, Infinity } };
  std::array<double, 3> High{ { -Infinity, -Infinity, -Infinity } };

  void Add(const double point[3])
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], point[c]);
      this->High[c] = std::max(this->High[c], point[c]);
    }
  }
  void Add(const Box& other)
  {
    this->Add(other.Low.data());
    this->Add(other.High.data());
  }
  bool Intersects(const Box& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }
  double GetSumOfLengths() const
  {
    return (this->High[0] - this->Low[0]) + (this->High[1] - this->Low[1]) +
      (this->High[2] - this->Low[2]);
  }

  static constexpr double Infinity = std::numeric_limits<double>::infinity();
};

class BoxTree
{
public:
  struct Node
  {
    Box Bounds;
    vtkIdType First; // position of the items; for an inner node the second child, the first child
                     // follows the node
    vtkIdType Count; // number of items; 0 for an inner node
  };

  /// Builds a tree of items with these boxes.
  void Build(const std::vector<Box>& boxes);
  /// Updates the boxes of the same items.
  void Fit(const std::vector<Box>& boxes);

  std::size_t GetNumberOfItems() const { return this->Items.size(); }
  const std::vector<Node>& GetNodes() const { return this->Nodes; }
  /// Returns the item at a position.
  vtkIdType GetItem(vtkIdType position) const { return this->Items[position]; }
  const Box& GetBox(vtkIdType position) const { return this->Boxes[position]; }

  /// Whether a box intersects the box of any item.
  bool Intersects(const Box& box) const;

private:
  void Split(const std::vector<std::array<double, 3>>& middles, vtkIdType first, vtkIdType last);

  std::vector<Node> Nodes;
  std::vector<vtkIdType> Items;
  std::vector<Box> Boxes; // by position
};
}

#endif
