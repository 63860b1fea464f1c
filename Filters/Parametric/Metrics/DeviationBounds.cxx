// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/DeviationBounds.h"

#include "Metrics/SecondDerivatives.h"
#include "Metrics/TriangleForm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
// Directions over half a turn. Directions between two of them are positive sums of both, so that it
// is sufficient to test the form for each direction and for each pair of consecutive directions.
constexpr int NumberOfDirections = 12;
constexpr int NumberOfDemands = 2 * NumberOfDirections;
using Directions = std::array<dvec3, NumberOfDirections + 1>;
using Demands = std::array<double, NumberOfDemands>;

const Directions& GetDirections()
{
  static const Directions directions = []
  {
    Directions result;
    for (int k = 0; k <= NumberOfDirections; ++k)
    {
      const double angle = std::acos(-1.0) * k / NumberOfDirections;
      result[k] = std::cos(angle) * dvec3(1.0, -1.0, 0.0) / std::sqrt(2.0) +
        std::sin(angle) * dvec3(1.0, 1.0, -2.0) / std::sqrt(6.0);
    }
    return result;
  }();
  return directions;
}

// A lower bound for the form, in a direction or along a coordinate.
struct Demand
{
  dvec3 Row;
  double Least;
};

// Returns the form with the smallest sum that meets the demands. It meets three with equality.
dvec3 FindLeastForm(const std::vector<Demand>& demands, double slack)
{
  dvec3 best(std::numeric_limits<double>::infinity());
  const std::size_t n = demands.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        const dmat3 rows(demands[i].Row, demands[j].Row, demands[k].Row);
        if (!(std::abs(determinant(rows)) > 1e-9))
        {
          continue;
        }
        const dvec3 form =
          dvec3(demands[i].Least, demands[j].Least, demands[k].Least) * inverse(rows);
        if (form.x + form.y + form.z < best.x + best.y + best.z &&
          std::all_of(demands.begin(), demands.end(),
            [&](const Demand& demand) { return dot(demand.Row, form) >= demand.Least - slack; }))
        {
          best = form;
        }
      }
    }
  }
  return best;
}

// Solves a linear program of three unknowns by adding the most violated demands.
dvec3 FitForm(const Demands& demands)
{
  const double largest = *std::max_element(demands.begin(), demands.end());
  if (!(largest > 0.0))
  {
    return dvec3(0.0);
  }
  if (!(largest <= 1e150))
  {
    return dvec3(std::numeric_limits<double>::infinity());
  }
  const Directions& directions = GetDirections();
  const auto getDemand = [&](int i)
  {
    const int k = i / 2;
    return Demand{ directions[k] * directions[k + i % 2], demands[i] / largest };
  };
  constexpr double slack = 1e-9;
  std::vector<Demand> chosen{ { dvec3(1.0, 0.0, 0.0), 0.0 }, { dvec3(0.0, 1.0, 0.0), 0.0 },
    { dvec3(0.0, 0.0, 1.0), 0.0 } };
  for (;;)
  {
    const dvec3 form = FindLeastForm(chosen, slack);
    Demand missed{ dvec3(0.0), 2.0 * slack };
    double most = 2.0 * slack;
    for (int i = 0; i < NumberOfDemands; ++i)
    {
      const Demand demand = getDemand(i);
      const double lack = demand.Least - dot(demand.Row, form);
      if (lack > most)
      {
        most = lack;
        missed = demand;
      }
    }
    if (!(most > 2.0 * slack))
    {
      // A little more than the slack, because directions are normalized.
      return largest * (max(form, dvec3(0.0)) + dvec3(4.0 * slack));
    }
    chosen.push_back(missed);
  }
}

// Adds the demands of the derivatives of a part, `scale` times as long as the whole.
void AddDemands(const TriangleForm& form, double scale, Demands& demands)
{
  const SecondDerivatives derivatives(form);
  const Directions& directions = GetDirections();
  for (int i = 0; i < NumberOfDirections; ++i)
  {
    const dvec3& d = directions[i];
    double& one = demands[2 * i];
    one = std::max(one, scale * scale * derivatives.Bound(d, d));
    double& two = demands[2 * i + 1];
    two = std::max(two, scale * scale * derivatives.Bound(d, directions[i + 1]));
  }
}

// Nets of parts are closer bounds, especially if weights differ. Products of high degree are
// expensive.
int GetNumberOfSplits(const TriangleForm& form)
{
  return form.IsRational() ? (form.GetDegree() > 6 ? 1 : 2) : (form.GetDegree() > 2 ? 1 : 0);
}

void AddPieces(const TriangleForm& form, int splits, double scale, Demands& demands)
{
  if (splits == 0)
  {
    AddDemands(form, scale, demands);
    return;
  }
  const dmat3 corners(1.0);
  const dvec3 middles[3] = { 0.5 * (corners[1] + corners[2]), 0.5 * (corners[0] + corners[2]),
    0.5 * (corners[0] + corners[1]) };
  for (int c = 0; c < 3; ++c)
  {
    dvec3 piece[3] = { middles[0], middles[1], middles[2] };
    std::swap(piece[(c + 1) % 3], piece[(c + 2) % 3]);
    piece[c] = corners[c];
    AddPieces(TriangleForm(form, piece), splits - 1, 2.0 * scale, demands);
  }
  // The coordinates of this part are reversed, which does not affect lengths.
  AddPieces(TriangleForm(form, middles), splits - 1, 2.0 * scale, demands);
}
}

dvec3 ComputeDeviationForm(const TriangleForm& triangle)
{
  Demands demands{};
  AddPieces(triangle, GetNumberOfSplits(triangle), 1.0, demands);
  return FitForm(demands);
}
}
