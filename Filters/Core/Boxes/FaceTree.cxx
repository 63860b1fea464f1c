// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/FaceTree.h"

#include <limits>
#include <numeric>
#include <utility>

namespace relevo
{
namespace
{
void Extend(FaceBox& box, const FaceBox& other)
{
  for (int c = 0; c < 3; ++c)
  {
    box.Low[c] = std::min(box.Low[c], other.Low[c]);
    box.High[c] = std::max(box.High[c], other.High[c]);
  }
}
}

BoxSegment::BoxSegment(const double start[3], const double end[3], double margin)
  : Margin(margin)
{
  for (int c = 0; c < 3; ++c)
  {
    this->Start[c] = start[c];
    this->Still[c] = end[c] == start[c];
    this->Inverse[c] = this->Still[c] ? 0.0 : 1.0 / (end[c] - start[c]);
  }
}

double BoxSegment::GetEntry(const FaceBox& box, double last) const
{
  const double never = std::numeric_limits<double>::infinity();
  double entry = 0.0;
  double exit = last;
  for (int c = 0; c < 3; ++c)
  {
    const double low = box.Low[c] - this->Margin - this->Start[c];
    const double high = box.High[c] + this->Margin - this->Start[c];
    if (this->Still[c])
    {
      if (low > 0.0 || high < 0.0)
      {
        return never;
      }
      continue;
    }
    const double a = low * this->Inverse[c];
    const double b = high * this->Inverse[c];
    entry = std::max(entry, std::min(a, b));
    // Rounding of the quotient must not miss the box.
    exit = std::min(exit, std::max(a, b) * (1.0 + 8.0 * std::numeric_limits<double>::epsilon()));
  }
  return entry <= exit ? entry : never;
}

void FaceTree::Build(std::vector<FaceBox> boxes, int maximumPerLeaf)
{
  this->Boxes = std::move(boxes);
  this->Order.resize(this->Boxes.size());
  std::iota(this->Order.begin(), this->Order.end(), 0);
  this->Nodes.clear();
  this->Nodes.reserve(this->Boxes.size());
  if (!this->Boxes.empty())
  {
    this->Split(0, static_cast<int>(this->Boxes.size()), maximumPerLeaf);
  }
}

void FaceTree::Split(int first, int last, int maximumPerLeaf)
{
  Node node = { this->Boxes[this->Order[first]], first, last - first };
  for (int i = first + 1; i < last; ++i)
  {
    Extend(node.Box, this->Boxes[this->Order[i]]);
  }
  const size_t index = this->Nodes.size();
  this->Nodes.push_back(node);
  if (node.Count <= maximumPerLeaf)
  {
    return;
  }
  int axis = 0;
  for (int c = 1; c < 3; ++c)
  {
    axis = node.Box.High[c] - node.Box.Low[c] > node.Box.High[axis] - node.Box.Low[axis] ? c : axis;
  }
  const int middle = first + node.Count / 2;
  const auto center = [this, axis](int face)
  { return this->Boxes[face].Low[axis] + this->Boxes[face].High[axis]; };
  std::nth_element(this->Order.begin() + first, this->Order.begin() + middle,
    this->Order.begin() + last, [&center](int a, int b) { return center(a) < center(b); });
  this->Split(first, middle, maximumPerLeaf);
  this->Nodes[index].First = static_cast<int>(this->Nodes.size());
  this->Nodes[index].Count = 0;
  this->Split(middle, last, maximumPerLeaf);
}
}
