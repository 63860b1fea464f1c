// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/SplitCounts.h"

#include "Bezier/PlaceSet.h"
#include "Mathematics/DisjointSets.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace relevo
{
namespace
{
constexpr int EdgesPerPart = 12;
// The shape tolerance is refined at most by this factor where scalars are steep.
constexpr double MostSteep = 16.0;

// Returns for each direction the error of a single piece, relative to the tolerance.
dvec3 FindErrors(const BezierHexahedron& shape, const SplitTolerances& tolerances)
{
  // An error of position changes the scalar at a position by the gradient.
  Scalars steepness = {};
  for (int i = 0; i < BezierHexahedron::NumberOfSamples; ++i)
  {
    const Gradients gradients = shape.ComputeGradients(BezierHexahedron::GetSample(i));
    for (int c = 0; c < shape.GetNumberOfScalars(); ++c)
    {
      steepness[c] = std::max(steepness[c], length(gradients[c]));
    }
  }
  dvec3 errors;
  for (int direction = 0; direction < 3; ++direction)
  {
    const auto bounds = shape.BoundSecondDerivatives(direction);
    double error = bounds[0] / tolerances.Shape;
    for (int c = 0; c < shape.GetNumberOfScalars(); ++c)
    {
      const double tolerance = tolerances.Values[c];
      const double slope = std::min(steepness[c], MostSteep * tolerance / tolerances.Shape);
      error = std::max(error, (bounds[1 + c] + slope * bounds[0]) / tolerance);
    }
    errors[direction] = std::isfinite(error) ? error / 8.0 : 0.0;
  }
  return errors;
}

// Returns the counts with few pieces for which the sum of error / count^2 is at most 1.
ivec3 FindCounts(const dvec3& errors)
{
  ivec3 counts(1);
  const auto getError = [&](int d, int count) { return errors[d] / (count * count); };
  const auto getSum = [&]
  { return getError(0, counts.x) + getError(1, counts.y) + getError(2, counts.z); };
  while (getSum() > 1.0 + 1e-9)
  {
    int best = -1;
    double most = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      const double gain = (getError(d, counts[d]) - getError(d, counts[d] + 1)) * counts[d];
      if (gain > most && counts[d] <= SplitCounts::LargestCount)
      {
        best = d;
        most = gain;
      }
    }
    if (best < 0)
    {
      break;
    }
    ++counts[best];
  }
  return counts;
}

// The sets of opposite edges of hexahedra. Equal edges, by the places at their ends, are united.
class Sheets
{
public:
  Sheets(const std::vector<CurvedPart>& parts, PlaceSet& places)
    : Sets(static_cast<vtkIdType>(parts.size()) * EdgesPerPart)
  {
    std::map<std::pair<size_t, size_t>, vtkIdType> edges;
    for (size_t part = 0; part < parts.size(); ++part)
    {
      const BezierHexahedron& shape = parts[part].Shape;
      std::array<size_t, 8> corners;
      for (int i = 0; i < 8; ++i)
      {
        corners[i] = places.Find(shape.GetPosition(dvec3(i & 1, i >> 1 & 1, i >> 2 & 1)));
      }
      for (int direction = 0; direction < 3; ++direction)
      {
        const vtkIdType own = this->GetFirst(part, direction);
        for (int i = 0; i < 8; ++i)
        {
          const auto ends = std::minmax(corners[i], corners[i | 1 << direction]);
          if (ends.first != ends.second)
          {
            this->Sets.Unite(own, edges.insert({ ends, own }).first->second);
          }
        }
      }
    }
  }

  vtkIdType Find(size_t part, int direction)
  {
    return this->Sets.Find(this->GetFirst(part, direction));
  }

private:
  vtkIdType GetFirst(size_t part, int direction) const
  {
    return static_cast<vtkIdType>(part) * 3 + direction;
  }

  DisjointSets Sets;
};
}

SplitCounts::SplitCounts(
  const std::vector<CurvedPart>& parts, const SplitTolerances& tolerances, PlaceSet& places)
  : Counts(parts.size(), ivec3(1))
{
  std::vector<dvec3> errors(parts.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        errors[i] = FindErrors(parts[i].Shape, tolerances);
        this->Counts[i] = FindCounts(errors[i]);
      }
    });
  Sheets sheets(parts, places);
  std::unordered_map<vtkIdType, int> all;
  for (size_t part = 0; part < parts.size(); ++part)
  {
    for (int d = 0; d < 3; ++d)
    {
      int& count = all[sheets.Find(part, d)];
      count = std::max(count, this->Counts[part][d]);
    }
  }
  const auto getTotal = [&](double coarsening)
  {
    double total = 0.0;
    for (size_t part = 0; part < parts.size(); ++part)
    {
      double pieces = 1.0;
      for (int d = 0; d < 3; ++d)
      {
        int& count = this->Counts[part][d];
        count = std::max(1, static_cast<int>(std::lround(all[sheets.Find(part, d)] / coarsening)));
        this->HasLimits = this->HasLimits || count > LargestCount;
        count = std::min(count, LargestCount);
        pieces *= count;
      }
      total += pieces;
    }
    return total;
  };
  const double largest = std::max(LargestTotal, PiecesPerPart * parts.size());
  double coarsening = 1.0;
  while (getTotal(coarsening) > largest && coarsening < LargestCount)
  {
    coarsening *= 1.25;
    this->HasLimits = true;
  }
}
}
