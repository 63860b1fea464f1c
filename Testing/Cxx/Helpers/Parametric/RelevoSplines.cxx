// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoSplines.h"

#include "vtkCell.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

// N(i, p) at u, with 0 / 0 = 0.
double GetBasis(const std::vector<double>& knots, int i, int p, double u, bool fromLeft)
{
  if (p == 0)
  {
    const bool isInside =
      fromLeft ? knots[i] < u && u <= knots[i + 1] : knots[i] <= u && u < knots[i + 1];
    return isInside ? 1.0 : 0.0;
  }
  const double rise = knots[i + p] - knots[i];
  const double fall = knots[i + p + 1] - knots[i + 1];
  double value = 0.0;
  if (rise > 0.0)
  {
    value += (u - knots[i]) / rise * GetBasis(knots, i, p - 1, u, fromLeft);
  }
  if (fall > 0.0)
  {
    value += (knots[i + p + 1] - u) / fall * GetBasis(knots, i + 1, p - 1, u, fromLeft);
  }
  return value;
}

std::vector<double> GetBases(const RelevoSpline& spline, int direction, double u, bool fromLeft)
{
  std::vector<double> values(spline.Dimensions[direction], 1.0);
  for (int i = 0; i < spline.Dimensions[direction] && !spline.Knots[direction].empty(); ++i)
  {
    values[i] = GetBasis(spline.Knots[direction], i, spline.Degrees[direction], u, fromLeft);
  }
  return values;
}
}

double RelevoGetDistance(const RelevoPosition& a, const RelevoPosition& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

RelevoPosition RelevoEvaluateCell(vtkUnstructuredGrid* grid, vtkIdType cell, double u, double v)
{
  vtkCell* curved = grid->GetCell(cell);
  const double coordinates[3] = { u, v, 0.0 };
  std::vector<double> weights(curved->GetNumberOfPoints());
  int part = 0;
  RelevoPosition place{};
  curved->EvaluateLocation(part, coordinates, place.data(), weights.data());
  return place;
}

vtkSmartPointer<vtkNURBSSource> RelevoSpline::NewSource() const
{
  auto source = vtkSmartPointer<vtkNURBSSource>::New();
  for (int direction = 0; direction < 2; ++direction)
  {
    source->SetDegree(direction, this->Degrees[direction]);
    source->SetKnots(
      direction, this->Knots[direction].empty() ? nullptr : MakeArray(this->Knots[direction]));
  }
  source->SetDimensions(this->Dimensions[0], this->Dimensions[1]);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const RelevoPosition& place : this->Points)
  {
    points->InsertNextPoint(place.data());
  }
  source->SetControlPoints(points);
  source->SetWeights(this->Weights.empty() ? nullptr : MakeArray(this->Weights));
  return source;
}

RelevoPosition RelevoSpline::Evaluate(double u, double v, bool fromLeft) const
{
  const std::vector<double> first = GetBases(*this, 0, u, fromLeft);
  const std::vector<double> second = GetBases(*this, 1, v, fromLeft);
  RelevoPosition sum{};
  double whole = 0.0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const double share = first[i % first.size()] * second[i / first.size()] *
      (this->Weights.empty() ? 1.0 : this->Weights[i]);
    whole += share;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += share * this->Points[i][axis];
    }
  }
  return { sum[0] / whole, sum[1] / whole, sum[2] / whole };
}

std::vector<std::array<double, 2>> RelevoSpline::GetSpans(int direction) const
{
  std::vector<std::array<double, 2>> spans;
  if (this->Knots[direction].empty())
  {
    return { { 0.0, 1.0 } };
  }
  for (int k = this->Degrees[direction]; k < this->Dimensions[direction]; ++k)
  {
    const double begin = this->Knots[direction][k];
    const double end = this->Knots[direction][k + 1];
    if (begin < end)
    {
      spans.push_back({ begin, end });
    }
  }
  return spans;
}

RelevoSpline RelevoMakeRandomSpline(std::mt19937& random, const std::array<int, 2>& degrees,
  const std::array<std::vector<double>, 2>& knots, bool isRational)
{
  RelevoSpline spline;
  spline.Degrees = degrees;
  spline.Knots = knots;
  for (int direction = 0; direction < 2; ++direction)
  {
    const int number = static_cast<int>(knots[direction].size());
    spline.Dimensions[direction] = number ? number - degrees[direction] - 1 : 1;
  }
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::uniform_real_distribution<double> weight(0.2, 3.0);
  for (int i = 0; i < spline.Dimensions[0] * spline.Dimensions[1]; ++i)
  {
    spline.Points.push_back({ place(random), place(random), place(random) });
    if (isRational)
    {
      spline.Weights.push_back(weight(random));
    }
  }
  return spline;
}

RelevoSpline RelevoMakeCircle()
{
  const double corner = std::sqrt(0.5);
  RelevoSpline circle;
  circle.Degrees = { 2, 3 };
  circle.Dimensions = { 9, 1 };
  circle.Knots[0] = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
  circle.Points = { { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { -1, 1, 0 }, { -1, 0, 0 },
    { -1, -1, 0 }, { 0, -1, 0 }, { 1, -1, 0 }, { 1, 0, 0 } };
  circle.Weights = { 1, corner, 1, corner, 1, corner, 1, corner, 1 };
  return circle;
}

RelevoSpline RelevoMakeTorus(double radius, double tube)
{
  const RelevoSpline circle = RelevoMakeCircle();
  RelevoSpline torus;
  torus.Degrees = { 2, 2 };
  torus.Dimensions = { 9, 9 };
  torus.Knots = { circle.Knots[0], circle.Knots[0] };
  for (int j = 0; j < 9; ++j)
  {
    const double out = radius + tube * circle.Points[j][0];
    for (int i = 0; i < 9; ++i)
    {
      torus.Points.push_back(
        { out * circle.Points[i][0], out * circle.Points[i][1], tube * circle.Points[j][1] });
      torus.Weights.push_back(circle.Weights[i] * circle.Weights[j]);
    }
  }
  return torus;
}
