// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles/CellOutline.h"

#include <algorithm>
#include <limits>

namespace relevo
{
void CellOutline::Clear()
{
  this->Points.clear();
  this->Low = dvec2(std::numeric_limits<double>::max());
  this->High = -this->Low;
}

void CellOutline::Add(const dvec2& point)
{
  this->Points.push_back(point);
  this->Low = min(this->Low, point);
  this->High = max(this->High, point);
}

// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information
// Processing Letters 9(5), 1979.
void CellOutline::Close(double margin)
{
  this->Margin = margin;
  this->Edges.clear();
  std::vector<dvec2>& p = this->Points;
  if (p.empty())
  {
    return;
  }
  std::sort(p.begin(), p.end(),
    [](const dvec2& a, const dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<dvec2>& hull = this->Hull;
  hull.resize(2 * p.size() + 1);
  size_t size = 0;
  const auto add = [&](const dvec2& point, size_t least)
  {
    while (size >= least)
    {
      const dvec2 a = hull[size - 1] - hull[size - 2];
      const dvec2 b = point - hull[size - 2];
      if (a.x * b.y - a.y * b.x > 0.0)
      {
        break;
      }
      --size;
    }
    hull[size++] = point;
  };
  for (const dvec2& point : p)
  {
    add(point, 2);
  }
  const size_t lower = size + 1;
  for (size_t i = p.size(); i-- > 1;)
  {
    add(p[i - 1], lower);
  }
  // The first point is also the last.
  for (size_t i = 0; i + 1 < std::max<size_t>(size, 2); ++i)
  {
    const dvec2& a = hull[i];
    const dvec2& b = hull[size > 1 ? i + 1 : i];
    const bool rises = b.y >= a.y;
    const double height = b.y - a.y;
    this->Edges.push_back(
      { rises ? a : b, rises ? b : a, height == 0.0 ? 0.0 : (b.x - a.x) / height });
  }
}

bool CellOutline::GetSpan(double row, double& first, double& last) const
{
  first = std::numeric_limits<double>::max();
  last = -first;
  const auto add = [&](double x)
  {
    first = std::min(first, x);
    last = std::max(last, x);
  };
  for (const Edge& edge : this->Edges)
  {
    const double begin = row - this->Margin;
    const double end = row + this->Margin;
    if (edge.Low.y <= end && edge.High.y >= begin)
    {
      add(begin <= edge.Low.y ? edge.Low.x : edge.Low.x + edge.Slope * (begin - edge.Low.y));
      add(end >= edge.High.y ? edge.High.x : edge.Low.x + edge.Slope * (end - edge.Low.y));
    }
  }
  first -= this->Margin;
  last += this->Margin;
  return first <= last;
}
}
