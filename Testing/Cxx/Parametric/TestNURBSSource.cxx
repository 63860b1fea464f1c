// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkNURBSSource promises Bézier cells that equal the NURBS, compared with the Cox-de Boor
// recursion.
#include "RelevoCheck.h"
#include "RelevoSplines.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Decompose(RelevoCheck& check, const RelevoSpline& spline)
{
  auto source = spline.NewSource();
  RelevoErrors errors(source);
  source->Update();
  CHECK(errors.None());
  return source->GetOutput();
}

// Largest distance between cells and spline, inside spans and at their ends.
double GetError(vtkUnstructuredGrid* grid, const RelevoSpline& spline)
{
  constexpr int steps = 7;
  double error = 0.0;
  vtkIdType cell = 0;
  for (const auto& second : spline.GetSpans(1))
  {
    for (const auto& first : spline.GetSpans(0))
    {
      for (int k = 0; k < (steps + 1) * (steps + 1); ++k)
      {
        const double a = k % (steps + 1) / static_cast<double>(steps);
        const double b = k / (steps + 1) / static_cast<double>(steps);
        const double u = a < 1.0 ? first[0] + a * (first[1] - first[0]) : first[1];
        const double v = b < 1.0 ? second[0] + b * (second[1] - second[0]) : second[1];
        // If the spline jumps at a knot, the two sides have different values.
        if ((a == 0.0 && b == 1.0) || (a == 1.0 && b == 0.0))
        {
          continue;
        }
        const bool fromLeft = a == 1.0 || b == 1.0;
        error = std::max(error,
          RelevoGetDistance(RelevoEvaluateCell(grid, cell, a, b), spline.Evaluate(u, v, fromLeft)));
      }
      ++cell;
    }
  }
  return error;
}

// Clamped and unclamped, with knots of every multiplicity, including discontinuities.
std::vector<std::vector<double>> MakeKnots(int p)
{
  std::vector<double> bezier(p + 1, -2.0);
  bezier.insert(bezier.end(), p + 1, 5.0);
  std::vector<double> uniform;
  for (int i = 0; i < 2 * p + 5; ++i)
  {
    uniform.push_back(0.25 * i - 1.0);
  }
  std::vector<double> multiple(p + 1, 0.0);
  double knot = 0.0;
  for (int times = 1; times <= p + 1; ++times)
  {
    knot += 0.3 + 0.1 * times;
    multiple.insert(multiple.end(), times, knot);
  }
  multiple.insert(multiple.end(), p + 1, knot + 0.7);
  std::vector<double> half(uniform.begin(), uniform.end() - 1); // clamped at one end only
  half.insert(half.end(), p + 1, uniform.back());
  return { bezier, uniform, multiple, half };
}

void TestCurves(RelevoCheck& check)
{
  std::mt19937 random(7);
  for (int p = 1; p <= 8; ++p)
  {
    for (const std::vector<double>& knots : MakeKnots(p))
    {
      for (bool isRational : { false, true })
      {
        CHECK_CASE(isRational);
        const RelevoSpline spline =
          RelevoMakeRandomSpline(random, { p, 3 }, { knots, std::vector<double>() }, isRational);
        auto grid = Decompose(check, spline);
        CHECK_EQUAL(grid->GetNumberOfCells(), static_cast<vtkIdType>(spline.GetSpans(0).size()));
        CHECK_EQUAL(grid->GetCellType(0), VTK_BEZIER_CURVE);
        CHECK_EQUAL((grid->GetPointData()->GetRationalWeights() != nullptr), isRational);
        CHECK_NEAR(GetError(grid, spline), 0.0, 1e-11);
      }
    }
  }
}

void TestSurfaces(RelevoCheck& check)
{
  std::mt19937 random(11);
  for (int p = 1; p <= 8; ++p)
  {
    const int q = 1 + (3 * p) % 8; // each degree once, usually different from p
    const auto first = MakeKnots(p);
    const auto second = MakeKnots(q);
    for (int i = 0; i < static_cast<int>(first.size()); ++i)
    {
      const RelevoSpline spline = RelevoMakeRandomSpline(
        random, { p, q }, { first[i], second[(i + p) % second.size()] }, i % 2 == p % 2);
      auto grid = Decompose(check, spline);
      CHECK_EQUAL(grid->GetNumberOfCells(),
        static_cast<vtkIdType>(spline.GetSpans(0).size() * spline.GetSpans(1).size()));
      CHECK_EQUAL(grid->GetCellType(0), VTK_BEZIER_QUADRILATERAL);
      double degrees[3];
      grid->GetCellData()->GetHigherOrderDegrees()->GetTuple(0, degrees);
      CHECK(degrees[0] == p && degrees[1] == q && degrees[2] == 0.0);
      CHECK_NEAR(GetError(grid, spline), 0.0, 1e-11);
    }
  }
}

void TestCircle(RelevoCheck& check)
{
  const RelevoSpline circle = RelevoMakeCircle();
  auto grid = Decompose(check, circle);
  CHECK_EQUAL(grid->GetNumberOfCells(), 4);
  CHECK_EQUAL(grid->GetNumberOfPoints(), 8);
  double error = 0.0;
  for (int k = 0; k <= 4000; ++k)
  {
    const RelevoPosition place =
      RelevoEvaluateCell(grid, std::min(k / 1000, 3), (k - 1000 * std::min(k / 1000, 3)) / 1e3, 0);
    error = std::max(error, std::abs(std::hypot(place[0], place[1]) - 1.0));
  }
  CHECK_NEAR(error, 0.0, 1e-14);
}

void TestTorus(RelevoCheck& check)
{
  constexpr double radius = 2.0;
  constexpr double tube = 0.5;
  const RelevoSpline torus = RelevoMakeTorus(radius, tube);
  auto grid = Decompose(check, torus);
  // The torus is closed in both directions.
  CHECK(grid->GetNumberOfCells() == 16 && grid->GetNumberOfPoints() == 64);
  double error = 0.0;
  for (vtkIdType cell = 0; cell < 16; ++cell)
  {
    for (int k = 0; k < 21 * 21; ++k)
    {
      const RelevoPosition x = RelevoEvaluateCell(grid, cell, k % 21 / 20.0, k / 21 / 20.0);
      error = std::max(error, std::abs(std::hypot(std::hypot(x[0], x[1]) - radius, x[2]) - tube));
    }
  }
  CHECK_NEAR(error, 0.0, 1e-14);
}

// Neighbours share the points on their border, however many knots were inserted.
void TestBorders(RelevoCheck& check)
{
  std::mt19937 random(3);
  const std::vector<double> knots{ 0.0, 0.1, 0.25, 0.3, 0.7, 0.75, 1.2, 1.7, 1.9, 2.0 };
  for (bool isRational : { false, true })
  {
    const RelevoSpline spline =
      RelevoMakeRandomSpline(random, { 3, 3 }, { knots, knots }, isRational);
    auto grid = Decompose(check, spline);
    CHECK_EQUAL(grid->GetNumberOfCells(), 9);
    CHECK_EQUAL(grid->GetNumberOfPoints(), 100); // 10 x 10 with shared borders
  }
  // At a discontinuity, points are not merged.
  const std::vector<double> jumping{ 0, 0, 1, 1, 2, 2 };
  const RelevoSpline jump =
    RelevoMakeRandomSpline(random, { 1, 3 }, { jumping, std::vector<double>() }, false);
  CHECK_EQUAL(Decompose(check, jump)->GetNumberOfPoints(), 4);
}

// If all weights are 1, there is no array of weights.
void TestWeights(RelevoCheck& check)
{
  std::mt19937 random(5);
  RelevoSpline spline =
    RelevoMakeRandomSpline(random, { 3, 3 }, { MakeKnots(3)[1], MakeKnots(3)[2] }, false);
  auto without = Decompose(check, spline);
  spline.Weights.assign(spline.Points.size(), 1.0);
  CHECK(!Decompose(check, spline)->GetPointData()->GetRationalWeights());
  spline.Weights.assign(spline.Points.size(), 4.0);
  auto with = Decompose(check, spline);
  CHECK_EQUAL(with->GetPointData()->GetRationalWeights(), with->GetPointData()->GetArray(0));
  CHECK_EQUAL(std::string(with->GetPointData()->GetArrayName(0)), "RationalWeights");
  CHECK_NEAR(with->GetPointData()->GetArray(0)->GetTuple1(5), 4.0, 1e-14);
  CHECK_EQUAL(with->GetNumberOfPoints(), without->GetNumberOfPoints());
  double error = 0.0;
  for (vtkIdType i = 0; i < with->GetNumberOfPoints(); ++i)
  {
    RelevoPosition a;
    RelevoPosition b;
    with->GetPoint(i, a.data());
    without->GetPoint(i, b.data());
    error = std::max(error, RelevoGetDistance(a, b));
  }
  CHECK_NEAR(error, 0.0, 1e-14);
}

// A closed curve has one common end point, unless the weights of its ends differ.
void TestEnds(RelevoCheck& check)
{
  RelevoSpline spline;
  spline.Degrees[0] = 2;
  spline.Dimensions[0] = 3;
  spline.Knots[0] = { 0, 0, 0, 1, 1, 1 };
  spline.Points = { { 1, 2, 3 }, { 4, 5, 7 }, { 1, 2, 3 } };
  for (double weight : { 1.0, 2.0 })
  {
    CHECK_CASE(weight);
    spline.Weights = { 1.0, 0.5, weight };
    auto grid = Decompose(check, spline);
    CHECK_EQUAL(grid->GetNumberOfPoints(), (weight == 1.0 ? 2 : 3));
    CHECK_NEAR(GetError(grid, spline), 0.0, 1e-14);
  }
}

// Changes of an array's values take effect.
void TestTimes(RelevoCheck& check)
{
  const RelevoSpline circle = RelevoMakeCircle();
  auto source = circle.NewSource();
  source->Update();
  const vtkMTimeType made = source->GetOutput()->GetMTime();
  source->Update();
  CHECK_EQUAL(source->GetOutput()->GetMTime(), made);
  source->GetWeights()->SetValue(1, 5.0);
  source->GetWeights()->Modified();
  source->Update();
  CHECK_GREATER(source->GetOutput()->GetMTime(), made);
  const RelevoPosition place = RelevoEvaluateCell(source->GetOutput(), 0, 0.5, 0.0);
  CHECK_GREATER(std::hypot(place[0], place[1]), 1.1);
}
}

int TestNURBSSource(int, char*[])
{
  RelevoCheck check;
  TestCurves(check);
  TestSurfaces(check);
  TestCircle(check);
  TestTorus(check);
  TestBorders(check);
  TestWeights(check);
  TestEnds(check);
  TestTimes(check);
  return check.GetResult();
}
