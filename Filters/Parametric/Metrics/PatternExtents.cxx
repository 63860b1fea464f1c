// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/PatternExtents.h"

#include "Patterns/PatternLibrary.h"
#include "Patterns/RefinementPattern.h"

#include <algorithm>
#include <map>
#include <utility>

namespace relevo
{
namespace
{
// The pattern corner opposite to each edge; edges have their steps in descending order.
constexpr int OppositeCorners[3] = { 2, 0, 1 };

bool IsCovered(const dvec3& a, const dvec3& b)
{
  return a.x <= b.x && a.y <= b.y && a.z <= b.z;
}

// Returns the squared ranges of the triangles that no other triangle dominates.
std::vector<dvec3> FindLargest(const RefinementPattern& pattern)
{
  std::vector<dvec3> squares;
  for (std::size_t t = 0; t < pattern.Triangles.size(); t += 3)
  {
    dvec3 low(1.0);
    dvec3 high(0.0);
    for (std::size_t k = t; k < t + 3; ++k)
    {
      const float* w = &pattern.Vertices[3 * pattern.Triangles[k]];
      low = min(low, dvec3(w[0], w[1], w[2]));
      high = max(high, dvec3(w[0], w[1], w[2]));
    }
    const dvec3 square = (high - low) * (high - low);
    if (std::none_of(squares.begin(), squares.end(),
          [&](const dvec3& other) { return IsCovered(square, other); }))
    {
      squares.erase(std::remove_if(squares.begin(), squares.end(),
                      [&](const dvec3& other) { return IsCovered(other, square); }),
        squares.end());
      squares.push_back(square);
    }
  }
  return squares;
}

std::shared_ptr<const PatternFamily> GetUsualFamily()
{
  static const PatternLibrary library;
  return library.GetFamily(PatternLibrary::WHOLE_NUMBERS);
}
}

std::shared_ptr<const PatternExtents> PatternExtents::Find(
  std::shared_ptr<const PatternFamily> family)
{
  static std::mutex mutex;
  static std::map<vtkMTimeType, std::weak_ptr<const PatternExtents>> known;
  if (!family)
  {
    family = GetUsualFamily();
  }
  const std::lock_guard<std::mutex> lock(mutex);
  auto& place = known[family->GetMTime()];
  auto extents = place.lock();
  if (!extents)
  {
    extents = std::make_shared<const PatternExtents>(std::move(family));
    place = extents;
  }
  return extents;
}

PatternExtents::PatternExtents(std::shared_ptr<const PatternFamily> family)
  : Family(std::move(family))
{
  const auto n = static_cast<std::size_t>(this->GetSegmentSteps().GetNumberOfSteps());
  this->Places = std::vector<Extents>(n * (n + 1) * (n + 2) / 6);
}

double PatternExtents::Measure(const Steps& steps, const dvec3& form) const
{
  std::array<int, 3> corners{ { 0, 1, 2 } }; // in the order of pattern edges 1 to 3
  std::sort(corners.begin(), corners.end(), [&](int a, int b) { return steps[a] > steps[b]; });
  const Steps descending{ { steps[corners[0]], steps[corners[1]], steps[corners[2]] } };
  dvec3 turned;
  for (int edge = 0; edge < 3; ++edge)
  {
    turned[OppositeCorners[edge]] = form[corners[edge]];
  }
  // Edges with equal steps can be exchanged.
  dvec3 first = turned;
  dvec3 second = turned;
  if (descending[0] == descending[1])
  {
    std::swap(first[OppositeCorners[0]], first[OppositeCorners[1]]);
  }
  if (descending[1] == descending[2])
  {
    std::swap(second[OppositeCorners[1]], second[OppositeCorners[2]]);
  }
  double largest = 0.0;
  for (const dvec3& square : this->Get(descending))
  {
    const double sum = std::max({ dot(turned, square), dot(first, square), dot(second, square) });
    largest = sum <= largest ? largest : sum;
  }
  return largest;
}

const std::vector<dvec3>& PatternExtents::Get(const Steps& s) const
{
  const int index = s[0] * (s[0] + 1) * (s[0] + 2) / 6 + s[1] * (s[1] + 1) / 2 + s[2];
  Extents& place = this->Places[static_cast<std::size_t>(index)];
  std::call_once(place.Filled, [&] { place.Squares = this->Compute(s); });
  return place.Squares;
}

std::vector<dvec3> PatternExtents::Compute(const Steps& descending) const
{
  const auto find = [this](const Steps& s)
  {
    const unsigned int entry = this->Family->GetEntry(0, s[0], s[1], s[2]);
    return FindLargest(*this->Family->GetPattern(static_cast<int>(entry >> 3)));
  };
  if (!this->Family->IsMorphing())
  {
    return find(descending);
  }
  // The order of the face's corners determines the orientation of these patterns, but is not known
  // here. Use the maximum over all orders.
  double largest = 0.0;
  Steps steps = descending;
  std::sort(steps.begin(), steps.end());
  do
  {
    for (const dvec3& square : find(steps))
    {
      largest = std::max({ largest, square.x, square.y, square.z });
    }
  } while (std::next_permutation(steps.begin(), steps.end()));
  return { dvec3(largest) };
}
}
