// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/RenderTimeBudget.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr size_t NumberOfFrames = 5;
constexpr double Change = 0.25; // relative change in triangles that invalidates earlier frames
constexpr double Goal = 0.85;   // fraction of the frame time
constexpr double Least = 0.7;   // lowest fraction of the frame time at which a limit is kept
constexpr double Still = 2.0;   // seconds; slower frames are still images
}

void RenderTimeBudget::AddFrame(vtkIdType triangles, double seconds)
{
  if (triangles <= 0 || !(seconds > 0.0) || !std::isfinite(seconds))
  {
    return;
  }
  const auto last = static_cast<double>(this->Triangles);
  const auto count = static_cast<double>(triangles);
  this->Triangles = triangles;
  if (std::abs(count - last) > Change * last)
  {
    this->Costs.clear();
    return;
  }
  if (this->Costs.size() == NumberOfFrames)
  {
    this->Costs.erase(this->Costs.begin());
  }
  this->Costs.push_back(seconds / count);
  // With few costs, the smaller ones are used. A single one is used only if there is no other.
  if (this->Costs.size() > 1 || !(this->Cost > 0.0))
  {
    std::vector<double> sorted = this->Costs;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    this->Cost = *middle;
  }
}

vtkIdType RenderTimeBudget::FindLimit(double seconds, vtkIdType last) const
{
  if (seconds > Still)
  {
    return 0;
  }
  if (!(this->Cost > 0.0) || !(seconds > 0.0))
  {
    return last;
  }
  const double most = seconds / this->Cost;
  if (last == 0 && static_cast<double>(this->Triangles) <= most)
  {
    return 0;
  }
  const auto limit = static_cast<double>(last);
  return limit <= most && limit >= Least * most
    ? last
    : std::max<vtkIdType>(1, static_cast<vtkIdType>(Goal * most));
}
}
