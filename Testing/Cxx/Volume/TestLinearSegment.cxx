// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves the integral over a segment with linear colour and extinction, compared with closed forms
// or with the sum of many short segments.
#include "Integral/LinearSegment.h"
#include "RelevoCheck.h"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace
{
using relevo::dvec3;
using relevo::dvec4;
using relevo::linearSegmentPsi;

constexpr double Pi = 3.14159265358979323846;

void TestPsi(RelevoCheck& check)
{
  CHECK_EQUAL(linearSegmentPsi(0.0, 0.0), 1.0);
  for (double a : { 1e-9, 1e-3, 0.5, 3.0, 39.9, 40.1, 1e3, 1e9 })
  {
    CHECK_NEAR(linearSegmentPsi(a, a) * a / -std::expm1(-a), 1.0, 1e-13);
    // The integral of exp(-a t^2 / 2).
    const double gaussian = std::sqrt(Pi / (2.0 * a)) * std::erf(std::sqrt(0.5 * a));
    CHECK_NEAR(linearSegmentPsi(0.0, a) / gaussian, 1.0, 1e-13);
  }
  CHECK_LESS(linearSegmentPsi(1e300, 1e300), 1e-149);
  CHECK_LESS(linearSegmentPsi(0.0, 1e300), 1e-74);
  CHECK_NEAR(linearSegmentPsi(1e300, 0.0), 0.0, 1e-149);
}

// Sums segments so short that colour and extinction are constant in each.
dvec4 Sum(const dvec4& front, const dvec4& back, double length)
{
  const int count = 200000;
  dvec3 color(0.0);
  double light = 1.0;
  for (int i = 0; i < count; ++i)
  {
    const double t = (i + 0.5) / count;
    const dvec4 here = (1.0 - t) * front + t * back;
    const double passes = std::exp(-here.w * length / count);
    color += light * (1.0 - passes) * dvec3(here);
    light *= passes;
  }
  return dvec4(color, 1.0 - light);
}

void TestSegments(RelevoCheck& check)
{
  const std::initializer_list<std::pair<double, double>> ends = { { 0.0, 2.0 }, { 2.0, 0.0 },
    { 0.1, 0.3 }, { 7.0, 1.0 }, { 1.0, 50.0 }, { 80.0, 30.0 }, { 1e-6, 2e-6 }, { 1.5, 1.5 } };
  for (const auto& end : ends)
  {
    const dvec4 front(1.0, 0.2, 0.0, end.first);
    const dvec4 back(0.0, 0.6, 1.0, end.second);
    const dvec4 exact = relevo::linearSegment(front, back, 1.25);
    const dvec4 sum = Sum(front, back, 1.25);
    for (int i = 0; i < 4; ++i)
    {
      CHECK_NEAR(exact[i], sum[i], 1e-8);
    }
    CHECK_NEAR(exact.w, 1.0 - std::exp(-0.625 * (end.first + end.second)), 1e-15);
  }
  // A slab has one colour.
  const dvec4 slab =
    relevo::linearSegment(dvec4(0.25, 0.5, 1.0, 3.0), dvec4(0.25, 0.5, 1.0, 3.0), 0.5);
  const double alpha = 1.0 - std::exp(-1.5);
  CHECK_NEAR(slab.x, 0.25 * alpha, 1e-14);
  CHECK_NEAR(slab.y, 0.5 * alpha, 1e-14);
  CHECK_NEAR(slab.z, alpha, 1e-14);
  CHECK_NEAR(slab.w, alpha, 1e-14);
}

// A segment equals its parts composited.
void TestParts(RelevoCheck& check)
{
  const dvec4 front(1.0, 0.2, 0.0, 4.0);
  const dvec4 back(0.0, 0.6, 1.0, 0.5);
  const dvec4 middle = 0.7 * front + 0.3 * back;
  const dvec4 whole = relevo::linearSegment(front, back, 2.0);
  const dvec4 parts = relevo::frontOverBack(
    relevo::linearSegment(front, middle, 0.6), relevo::linearSegment(middle, back, 1.4));
  for (int i = 0; i < 4; ++i)
  {
    CHECK_NEAR(parts[i], whole[i], 1e-14);
  }
}
}

int TestLinearSegment(int, char*[])
{
  RelevoCheck check;
  TestPsi(check);
  TestSegments(check);
  TestParts(check);
  return check.GetResult();
}
