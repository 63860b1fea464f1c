// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/BoxTree.h"

#include "vtkSMPTools.h"

#include <cmath>
#include <numeric>

namespace relevo
{
namespace
{
constexpr vtkIdType MaximumPerLeaf = 4;
}

void BoxTree::Build(const std::vector<Box>& boxes)
{
  this->Items.resize(boxes.size());
  std::iota(this->Items.begin(), this->Items.end(), 0);
  std::vector<std::array<double, 3>> middles(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double middle = 0.5 * boxes[i].Low[c] + 0.5 * boxes[i].High[c];
      middles[i][c] = std::isfinite(middle) ? middle : 0.0; // NaN cannot be sorted
    }
  }
  this->Nodes.clear();
  if (!boxes.empty())
  {
    this->Split(middles, 0, static_cast<vtkIdType>(boxes.size()));
  }
  this->Fit(boxes);
}

void BoxTree::Split(
  const std::vector<std::array<double, 3>>& middles, vtkIdType first, vtkIdType last)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.push_back({ {}, first, last - first });
  if (last - first <= MaximumPerLeaf)
  {
    return;
  }
  Box box;
  for (vtkIdType i = first; i < last; ++i)
  {
    box.Add(middles[this->Items[i]].data());
  }
  int axis = 0;
  for (int c = 1; c < 3; ++c)
  {
    axis = box.High[c] - box.Low[c] > box.High[axis] - box.Low[axis] ? c : axis;
  }
  const vtkIdType half = first + (last - first) / 2;
  std::nth_element(this->Items.begin() + first, this->Items.begin() + half,
    this->Items.begin() + last,
    [&](vtkIdType a, vtkIdType b)
    { return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b; });
  this->Split(middles, first, half);
  this->Nodes[index].First = static_cast<vtkIdType>(this->Nodes.size());
  this->Nodes[index].Count = 0;
  this->Split(middles, half, last);
}

void BoxTree::Fit(const std::vector<Box>& boxes)
{
  this->Boxes.resize(boxes.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        this->Boxes[i] = boxes[this->Items[i]];
      }
    });
  // Children follow their parents.
  for (std::size_t n = this->Nodes.size(); n-- > 0;)
  {
    Node& node = this->Nodes[n];
    node.Bounds = {};
    for (vtkIdType i = node.First; i < node.First + node.Count; ++i)
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

bool BoxTree::Intersects(const Box& box) const
{
  // The tree is balanced, so that this depth is sufficient for any number of boxes.
  std::array<vtkIdType, 128> stack;
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const vtkIdType n = stack[--size];
    const Node& node = this->Nodes[n];
    if (!node.Bounds.Intersects(box))
    {
      continue;
    }
    for (vtkIdType i = node.First; i < node.First + node.Count; ++i)
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
}
