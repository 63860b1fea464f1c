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
}

// The inner integral is the optical depth a t + (b - a) t^2 / 2, which is monotonic. Between
// positions where it grows by at most 1, the exponential is smooth enough for Gaussian quadrature.
double linearSegmentPsi(double front, double back)
{
  const double a = std::min(front, LargestDepth);
  const double k = 0.5 * (std::min(back, LargestDepth) - a);
  const auto getPosition = [=](double depth)
  { return 2.0 * depth / (a + std::sqrt(std::max(a * a + 4.0 * k * depth, 0.0))); };
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
