// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceRegions.h"

#include <algorithm>
#include <cstddef>

namespace relevo
{
namespace
{
using Boxes = std::vector<vtkBoundingBox>;
using Indices = std::vector<std::size_t>;

// A plane perpendicular to an axis, with the first `Below` of the boxes, sorted along it, on its
// lower side.
struct Cut
{
  int Axis = -1;
  std::size_t Below = 0;
  double Position = 0.0;
  double Gap = 0.0;     // between the boxes of both sides, negative if they overlap
  double Centers = 0.0; // distance of the centres next to it

  bool IsBetterThan(const Cut& other) const
  {
    return other.Axis < 0 || this->Gap > other.Gap ||
      (this->Gap == other.Gap && this->Centers > other.Centers);
  }
};

double GetCenter(const vtkBoundingBox& box, int axis)
{
  return 0.5 * (box.GetBound(2 * axis) + box.GetBound(2 * axis + 1));
}

void Sort(const Boxes& boxes, int axis, Indices& indices)
{
  std::stable_sort(indices.begin(), indices.end(),
    [&boxes, axis](std::size_t a, std::size_t b)
    { return GetCenter(boxes[a], axis) < GetCenter(boxes[b], axis); });
}

// Return the best cut; it has no axis if all boxes coincide.
Cut FindCut(const Boxes& boxes, Indices& indices)
{
  Cut best;
  for (int axis = 0; axis < 3; ++axis)
  {
    Sort(boxes, axis, indices);
    double high = boxes[indices[0]].GetBound(2 * axis + 1);
    for (std::size_t i = 1; i < indices.size(); ++i)
    {
      double low = boxes[indices[i]].GetBound(2 * axis);
      for (std::size_t k = i + 1; k < indices.size(); ++k)
      {
        low = std::min(low, boxes[indices[k]].GetBound(2 * axis));
      }
      const Cut cut = { axis, i, 0.5 * (low + high), low - high,
        GetCenter(boxes[indices[i]], axis) - GetCenter(boxes[indices[i - 1]], axis) };
      if (cut.Centers > 0.0 && cut.IsBetterThan(best))
      {
        best = cut;
      }
      high = std::max(high, boxes[indices[i]].GetBound(2 * axis + 1));
    }
  }
  return best;
}

// `all` contains all boxes.
void Share(const Boxes& boxes, const vtkBoundingBox& all, Indices indices,
  const vtkBoundingBox& space, Boxes& regions)
{
  const Cut cut = indices.size() > 1 ? FindCut(boxes, indices) : Cut();
  if (cut.Axis < 0)
  {
    if (!indices.empty())
    {
      regions[indices[0]] = space;
    }
    return;
  }
  Sort(boxes, cut.Axis, indices);
  const auto middle = indices.begin() + static_cast<std::ptrdiff_t>(cut.Below);
  const double position = cut.Position + 1e-5 * all.GetLength(cut.Axis);
  double below[6];
  double above[6];
  space.GetBounds(below);
  space.GetBounds(above);
  below[2 * cut.Axis + 1] = above[2 * cut.Axis] = position;
  Share(boxes, all, Indices(indices.begin(), middle), vtkBoundingBox(below), regions);
  Share(boxes, all, Indices(middle, indices.end()), vtkBoundingBox(above), regions);
}
}

std::vector<vtkBoundingBox> ShareSpace(const std::vector<vtkBoundingBox>& boxes)
{
  vtkBoundingBox all;
  Indices indices;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (boxes[i].IsValid())
    {
      all.AddBox(boxes[i]);
      indices.push_back(i);
    }
  }
  constexpr double far = VTK_DOUBLE_MAX;
  Boxes regions(boxes.size());
  Share(boxes, all, indices, vtkBoundingBox(-far, far, -far, far, -far, far), regions);
  return regions;
}
}
