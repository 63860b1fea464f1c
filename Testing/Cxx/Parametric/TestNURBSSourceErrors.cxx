// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkNURBSSource promises an error that names the cause, and an empty output, for invalid NURBS.
#include "RelevoCheck.h"
#include "RelevoSplines.h"

#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
// A surface of 5 x 6 control points and degrees 2 and 3, with one invalid property.
void ExpectError(
  RelevoCheck& check, const std::function<void(RelevoSpline&)>& spoil, const char* words)
{
  std::mt19937 random(1);
  const std::vector<double> first{ 0, 0, 0, 1, 2, 3, 3, 3 };
  const std::vector<double> second{ 0, 0, 0, 0, 1, 2, 3, 3, 3, 3 };
  RelevoSpline spline = RelevoMakeRandomSpline(random, { 2, 3 }, { first, second }, true);
  auto source = spline.NewSource();
  CHECK(source->GetExecutive()->Update() == 1 && source->GetOutput()->GetNumberOfCells() == 9);
  spoil(spline);
  source = spline.NewSource();
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  CHECK_EQUAL(source->GetExecutive()->Update(), 0);
  if (!errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, std::string("no error with: ") + words);
  }
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 0);
  CHECK_EQUAL(source->GetOutput()->GetNumberOfPoints(), 0);
}

void TestKnots(RelevoCheck& check)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ExpectError(
    check, [](RelevoSpline& s) { s.Knots[0].clear(); }, "There are no knots of direction 0");
  ExpectError(
    check, [](RelevoSpline& s) { s.Knots[1].clear(); }, "There are no knots of direction 1");
  ExpectError(
    check, [](RelevoSpline& s) { s.Knots[0].pop_back(); },
    "Knots of direction 0: there are 7, but 5 control points of degree 2 need 8.");
  ExpectError(
    check, [](RelevoSpline& s) { s.Knots[1].push_back(4.0); },
    "Knots of direction 1: there are 11, but 6 control points of degree 3 need 10.");
  ExpectError(
    check, [](RelevoSpline& s) { s.Knots[1][5] = 0.5; },
    "Knots of direction 1: knots must not decrease, but knot 5 is 0.5, after 1.");
  ExpectError(
    check, [](RelevoSpline& s) { s.Knots[0][3] = 0.0; },
    "Knots of direction 0: the knot 0 occurs more than 3 times.");
  ExpectError(
    check,
    [](RelevoSpline& s) {
      s.Knots[1] = { 0, 1, 1, 1, 1, 1, 2, 3, 4, 5 };
    },
    "Knots of direction 1: the knot 1 occurs more than 4 times.");
  ExpectError(
    check, [=](RelevoSpline& s) { s.Knots[0][4] = nan; }, "Knots of direction 0: knot 4 is nan");
  ExpectError(
    check, [=](RelevoSpline& s) { s.Knots[0][7] = infinity; },
    "Knots of direction 0: knot 7 is inf");
  ExpectError(
    check,
    [](RelevoSpline& s)
    {
      s.Knots[0] = { 0, 1, 1, 1, 2, 3, 4, 5 };
      s.Degrees[0] = 4;
      s.Dimensions[0] = 3;
      s.Points.resize(18);
      s.Weights.resize(18);
    },
    "Direction 0 has 3 control points, but degree 4 needs at least 5.");
  ExpectError(
    check,
    [](RelevoSpline& s)
    {
      s.Dimensions = { 3, 6 };
      s.Points.resize(18);
      s.Weights.resize(18);
      s.Knots[0] = { 0, 0, 1, 1, 2, 2 };
    },
    "Knots of direction 0: knot 2 and knot 3 are equal");
}

void TestPoints(RelevoCheck& check)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectError(
    check, [](RelevoSpline& s) { s.Points.pop_back(); },
    "There are 29 control points, but the dimensions are 5 x 6.");
  ExpectError(
    check, [=](RelevoSpline& s) { s.Points[7][2] = nan; }, "Control point 7 is not finite.");
  ExpectError(
    check, [](RelevoSpline& s) { s.Weights.pop_back(); },
    "There are 29 weights, but 30 control points.");
  for (double weight : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    ExpectError(
      check, [=](RelevoSpline& s) { s.Weights[3] = weight; },
      "weights must be positive and finite.");
  }
  for (double weight : { 1e308, 5e-324 })
  {
    ExpectError(
      check,
      [=](RelevoSpline& s)
      {
        s.Points[3][0] = 100.0;
        std::fill(s.Weights.begin(), s.Weights.end(), weight);
      },
      "The weights are too large or too small: ");
  }
  ExpectError(
    check, [](RelevoSpline& s) { s.Degrees[1] = 6; },
    "Direction 1 has 6 control points, but degree 6 needs at least 7.");
}

void TestSettings(RelevoCheck& check)
{
  vtkNew<vtkNURBSSource> source;
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  CHECK_EQUAL(source->GetExecutive()->Update(), 0);
  CHECK(errors.Said("There are no control points: call SetControlPoints()."));
  for (int degree : { 0, 9, -1 })
  {
    CHECK_CASE(degree);
    source->SetDegree(1, degree);
    CHECK(errors.Said("Degree must be in [1, 8], got " + std::to_string(degree) + "."));
    CHECK_EQUAL(source->GetDegree(1), 3);
  }
  source->SetDegree(2, 3);
  CHECK(errors.Said("Direction must be in [0, 1], got 2."));
  source->SetKnots(-1, nullptr);
  CHECK(errors.Said("Direction must be in [0, 1], got -1."));
  CHECK(!source->GetKnots(2) && errors.Said("Direction must be in [0, 1], got 2."));
  CHECK(source->GetDegree(-1) == 0 && errors.Said("Direction must be in [0, 1], got -1."));
  source->SetDimensions(4, 0);
  CHECK(errors.Said("Dimensions must be at least 1, got 0."));
  CHECK(source->GetDimensions()[0] == 1 && source->GetDimensions()[1] == 1);
}
}

int TestNURBSSourceErrors(int, char*[])
{
  RelevoCheck check;
  TestKnots(check);
  TestPoints(check);
  TestSettings(check);
  return check.GetResult();
}
