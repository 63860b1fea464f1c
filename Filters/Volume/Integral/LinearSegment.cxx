// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/LinearSegment.h"

#include <array>
#include <cmath>

namespace relevo
{
namespace
{
// Optical depth beyond which less than 1e-17 of the light passes.
constexpr double Opaque = 40.0;
// Limit of optical depths whose square does not overflow.
constexpr double LargestDepth = 1e150;

// Nodes (of one half) and weights of 8-point Gauss-Legendre quadrature on [-1, 1].
constexpr std::array<double, 4> Nodes = { { 0.18343464249564980494, 0.52553240991632898582,
  0.79666647741362673959, 0.96028985649753623168 } };
constexpr std::array<double, 4> Weights = { { 0.36268378337836198297, 0.31370664587788728734,
  0.22238103445337447054, 0.10122853629037625915 } };

// Nodes and weights of Gauss-Legendre quadrature on [0, 1].
template <size_t Count>
struct Rule
{
  std::array<double, Count> Nodes;
  std::array<double, Count> Weights;
};
constexpr Rule<4> FourPoints = { { { 0.06943184420297371239, 0.33000947820757186760,
                                   0.66999052179242813240, 0.93056815579702628761 } },
  { { 0.17392742256872692869, 0.32607257743127307131, 0.32607257743127307131,
    0.17392742256872692869 } } };
constexpr Rule<6> SixPoints = { { { 0.03376524289842398609, 0.16939530676686774317,
                                  0.38069040695840154568, 0.61930959304159845432,
                                  0.83060469323313225683, 0.96623475710157601391 } },
  { { 0.08566224618958517252, 0.18038078652406930378, 0.23395696728634552369,
    0.23395696728634552369, 0.18038078652406930378, 0.08566224618958517252 } } };
// Optical depths up to which these are sufficient. The error of few points depends on the change of
// extinction.
constexpr double ThinDepth = 0.25;
constexpr double ThinnestDepth = 0.1;
constexpr double SmallChange = 0.01;

// exp(-x) for x from 0 to ThinDepth by its series, with a relative error below 1e-15.
double ExpThin(double x)
{
  constexpr std::array<double, 11> factors = { { 1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0,
    1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362880.0, 1.0 / 3628800.0 } };
  double sum = factors[10];
  for (size_t i = 10; i-- > 0;)
  {
    sum = factors[i] - x * sum;
  }
  return sum;
}

template <size_t Count>
double IntegrateThin(double a, double k, const Rule<Count>& rule)
{
  double sum = 0.0;
  for (size_t i = 0; i < Count; ++i)
  {
    const double t = rule.Nodes[i];
    sum += rule.Weights[i] * ExpThin((a + k * t) * t);
  }
  return sum;
}
}

// The inner integral is the optical depth a t + (b - a) t^2 / 2, which is monotonic. Between
// positions where it grows by at most 1, the exponential is smooth enough for Gaussian quadrature.
double linearSegmentPsi(double front, double back)
{
  const double a = std::min(front, LargestDepth);
  const double k = 0.5 * (std::min(back, LargestDepth) - a);
  const auto getPosition = [=](double depth)
  { return 2.0 * depth / (a + std::sqrt(std::max(a * a + 4.0 * k * depth, 0.0))); };
  if (a + k <= ThinDepth)
  {
    return a + k <= ThinnestDepth && std::abs(k) <= SmallChange ? IntegrateThin(a, k, FourPoints)
                                                                : IntegrateThin(a, k, SixPoints);
  }
  const double last = std::min(a + k, Opaque);
  const int pieces = std::max(static_cast<int>(std::ceil(last)), 1);
  double sum = 0.0;
  double begin = 0.0;
  for (int i = 1; i <= pieces; ++i)
  {
    const double end = i == pieces && last < Opaque ? 1.0 : getPosition(last * i / pieces);
    const double middle = 0.5 * (begin + end);
    const double half = 0.5 * (end - begin);
    for (size_t j = 0; j < Nodes.size(); ++j)
    {
      const double t0 = middle - half * Nodes[j];
      const double t1 = middle + half * Nodes[j];
      sum += half * Weights[j] * (std::exp(-(a + k * t0) * t0) + std::exp(-(a + k * t1) * t1));
    }
    begin = end;
  }
  return sum;
}
}
