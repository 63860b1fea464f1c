// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshExtent.h"

#include "Cells/VolumeCells.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
MeshExtent MeshExtent::Of(const VolumeCells& cells, int numberOfComponents)
{
  MeshExtent extent;
  if (cells.GetCells().empty() && !cells.HasCurvedParts())
  {
    return extent;
  }
  extent.NumberOfComponents = numberOfComponents;
  double longest = 0.0; // squared length
  for (const VolumeCells::Cell& cell : cells.GetCells())
  {
    for (int i = 0; i < cells.GetNumberOfCorners(cell); ++i)
    {
      const dvec3& corner = cells.GetPoints()[cells.GetCornerId(cell, i)];
      extent.Points.Add(&corner.x);
      for (int j = 0; j < i; ++j)
      {
        const dvec3 edge = cells.GetPoints()[cells.GetCornerId(cell, j)] - corner;
        longest = std::max(longest, dot(edge, edge));
      }
    }
  }
  for (const CurvedPart& part : cells.GetCurvedParts())
  {
    dvec3 low;
    dvec3 high;
    part.Shape.FindBounds(low, high);
    extent.Points.Add(&low.x);
    extent.Points.Add(&high.x);
    longest = std::max(longest, dot(high - low, high - low));
  }
  extent.LongestEdge = std::sqrt(longest);
  for (int c = 0; c < MaximumComponents; ++c)
  {
    cells.GetRange(c, extent.ScalarLow[c], extent.ScalarHigh[c]);
  }
  return extent;
}

bool MeshExtent::Add(const MeshExtent& other)
{
  if (other.IsEmpty() || this->IsEmpty())
  {
    *this = other.IsEmpty() ? *this : other;
    return true;
  }
  if (this->NumberOfComponents != other.NumberOfComponents)
  {
    return false;
  }
  this->Points.Add(other.Points.Low.data());
  this->Points.Add(other.Points.High.data());
  for (size_t c = 0; c < this->ScalarLow.size(); ++c)
  {
    this->ScalarLow[c] = std::min(this->ScalarLow[c], other.ScalarLow[c]);
    this->ScalarHigh[c] = std::max(this->ScalarHigh[c], other.ScalarHigh[c]);
  }
  this->LongestEdge = std::max(this->LongestEdge, other.LongestEdge);
  return true;
}

bool MeshExtent::operator==(const MeshExtent& other) const
{
  return this->Points == other.Points && this->ScalarLow == other.ScalarLow &&
    this->ScalarHigh == other.ScalarHigh && this->LongestEdge == other.LongestEdge &&
    this->NumberOfComponents == other.NumberOfComponents;
}

double MeshExtent::GetScalarSize(int component) const
{
  // Twice this may be infinite.
  const double half = 0.5 * this->ScalarHigh[component] - 0.5 * this->ScalarLow[component];
  return half > 0.0 && std::isfinite(2.0 * half) ? 2.0 * half : 1.0;
}

double MeshExtent::GetRadius() const
{
  const double diagonal =
    length(dvec3(this->Points.GetSide(0), this->Points.GetSide(1), this->Points.GetSide(2)));
  return diagonal > 0.0 ? 0.5 * diagonal : 1.0;
}
}
