// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveFilter promises closed tubes of the given radius without twist, with normals
// outwards, and ribbons of the same width that face the camera.
#include "RelevoCheck.h"
#include "RelevoCurves.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace
{
constexpr double Radius = 0.05;

vtkSmartPointer<vtkUnstructuredGrid> MakeRandomCurve(std::mt19937& random, int degree)
{
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<RelevoPosition> points;
  std::vector<vtkIdType> ids;
  for (int i = 0; i <= degree; ++i)
  {
    points.push_back({ place(random), place(random), place(random) });
    ids.push_back(i);
  }
  auto grid = RelevoNewGrid(points);
  grid->InsertNextCell(VTK_BEZIER_CURVE, degree + 1, ids.data());
  return grid;
}

RelevoPosition GetPoint(vtkPolyData* mesh, vtkIdType id)
{
  RelevoPosition place;
  mesh->GetPoint(id, place.data());
  return place;
}

RelevoPosition GetDifference(const RelevoPosition& a, const RelevoPosition& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

// Compares the rings of a single tube with the points of its curve.
void CheckRings(RelevoCheck& check, vtkPolyData* tube, vtkPolyData* line, int sides)
{
  const std::vector<RelevoPosition> axis = RelevoGetCellPoints(line, 0);
  CHECK_EQUAL(
    tube->GetNumberOfPoints(), static_cast<vtkIdType>((axis.size() + 2) * sides)); // two caps
  vtkDataArray* normals = tube->GetPointData()->GetNormals();
  CHECK(normals && normals->GetDataType() == VTK_FLOAT);
  double worst = 1.0;
  for (std::size_t row = 0; row < axis.size(); ++row)
  {
    for (int side = 0; side < sides; ++side)
    {
      const vtkIdType id = static_cast<vtkIdType>(row * sides + side);
      const RelevoPosition place = GetPoint(tube, id);
      const RelevoPosition out = GetDifference(place, axis[row]);
      CHECK_NEAR(vtkMath::Norm(out.data()), Radius, 1e-14);
      double normal[3];
      normals->GetTuple(id, normal);
      CHECK_NEAR(vtkMath::Norm(normal), 1.0, 1e-6);
      CHECK_NEAR(vtkMath::Dot(normal, out.data()), Radius, 1e-7);
      if (row > 0)
      {
        const RelevoPosition last = GetDifference(GetPoint(tube, id - sides), axis[row - 1]);
        worst = std::min(worst, vtkMath::Dot(last.data(), out.data()) / (Radius * Radius));
      }
    }
  }
  // The frame rotates from ring to ring no more than the curve.
  CHECK_GREATER(worst, 0.5);
}

void TestSingleTubes(RelevoCheck& check)
{
  std::mt19937 random(5);
  for (int degree = 1; degree <= 8; ++degree)
  {
    for (int trial = 0; trial < 4; ++trial)
    {
      const int sides = 3 + 2 * trial;
      auto grid = MakeRandomCurve(random, degree);
      auto lines = RelevoNewCurveFilter(grid, 7);
      lines->Update();
      auto tubes = RelevoNewCurveFilter(grid, 7);
      tubes->SetRepresentationToTubes();
      tubes->SetRadius(Radius);
      tubes->SetNumberOfSides(sides);
      tubes->Update();
      vtkPolyData* tube = tubes->GetOutput();
      CheckRings(check, tube, lines->GetOutput(), sides);
      CHECK_EQUAL(tube->GetNumberOfPolys(), 2 * 128 * sides + 2 * (sides - 2));
      CHECK_EQUAL(RelevoCountOpenEdges(tube), 0);
      CHECK_GREATER(RelevoGetVolume(tube), 0.0);
    }
  }
}

// Joined curves, with and without corners, and rings form one closed surface.
void TestJoinedTubes(RelevoCheck& check)
{
  auto circle = RelevoMakeCircle().NewSource();
  circle->Update();
  auto knot =
    RelevoNewGrid({ { { 0, 0, 0 } }, { { 2, 0, 1 } }, { { 2, 2, -1 } }, { { 0, 2, 2 } } });
  const std::array<vtkIdType, 5> ring{ 0, 1, 2, 3, 0 };
  knot->InsertNextCell(VTK_POLY_LINE, 5, ring.data());
  for (vtkUnstructuredGrid* grid : { circle->GetOutput(), knot.Get() })
  {
    auto filter = RelevoNewCurveFilter(grid, 4);
    filter->SetRepresentationToTubes();
    filter->SetRadius(Radius);
    filter->Update();
    vtkPolyData* tube = filter->GetOutput();
    CHECK_EQUAL(tube->GetNumberOfPoints(), 4 * 17 * 8); // no caps
    CHECK_EQUAL(RelevoCountOpenEdges(tube), 0);
    CHECK(tube->GetCellData()->GetArray("vtkOriginalCellIds"));
    const double length = grid == circle->GetOutput() ? 2.0 * vtkMath::Pi() : 10.0;
    CHECK_GREATER(RelevoGetVolume(tube), 0.8 * length * vtkMath::Pi() * Radius * Radius);
  }
  // The circle becomes a torus.
  auto filter = RelevoNewCurveFilter(circle->GetOutput(), 6);
  filter->SetRepresentationToTubes();
  filter->SetRadius(0.25);
  filter->SetNumberOfSides(64);
  filter->Update();
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const RelevoPosition place = GetPoint(filter->GetOutput(), i);
    CHECK_NEAR(std::hypot(std::hypot(place[0], place[1]) - 1.0, place[2]), 0.25, 1e-14);
  }
  CHECK_NEAR(
    RelevoGetVolume(filter->GetOutput()), 2.0 * vtkMath::Pi() * vtkMath::Pi() / 16.0, 0.01);
}

// A trefoil knot of cubic curves. After one turn the frame has rotated, and all curves share this
// rotation.
void TestKnot(RelevoCheck& check)
{
  constexpr int curves = 9;
  constexpr int sides = 6;
  const double step = 2.0 * vtkMath::Pi() / curves;
  const auto getPlace = [](double t)
  {
    return RelevoPosition{ std::sin(t) + 2.0 * std::sin(2.0 * t),
      std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t) };
  };
  const auto getHandle = [&](double t, double way)
  {
    const RelevoPosition place = getPlace(t);
    return RelevoPosition{ place[0] + way * (std::cos(t) + 4.0 * std::cos(2.0 * t)),
      place[1] + way * (4.0 * std::sin(2.0 * t) - std::sin(t)),
      place[2] - way * 3.0 * std::cos(3.0 * t) };
  };
  std::vector<RelevoPosition> places;
  for (int i = 0; i < curves; ++i)
  {
    places.push_back(getPlace(step * i));
    places.push_back(getHandle(step * i, step / 3.0));
    places.push_back(getHandle(step * (i + 1), -step / 3.0));
  }
  auto grid = RelevoNewGrid(places);
  for (vtkIdType i = 0; i < curves; ++i)
  {
    const std::array<vtkIdType, 4> ids{ 3 * i, 3 * ((i + 1) % curves), 3 * i + 1, 3 * i + 2 };
    grid->InsertNextCell(VTK_BEZIER_CURVE, 4, ids.data());
  }
  auto filter = RelevoNewCurveFilter(grid, 5);
  filter->SetRepresentationToTubes();
  filter->SetRadius(0.2);
  filter->SetNumberOfSides(sides);
  filter->Update();
  vtkPolyData* tube = filter->GetOutput();
  CHECK_EQUAL(tube->GetNumberOfPoints(), curves * 33 * sides);
  CHECK_EQUAL(RelevoCountOpenEdges(tube), 0);
  // The sides rotate equally from ring to ring.
  auto lines = RelevoNewCurveFilter(grid, 5);
  lines->Update();
  std::vector<double> turns;
  for (vtkIdType c = 0; c < curves; ++c)
  {
    const std::vector<RelevoPosition> axis = RelevoGetCellPoints(lines->GetOutput(), c);
    for (int row = 0; row < 32; ++row)
    {
      const vtkIdType id = (33 * c + row) * sides;
      const RelevoPosition out = GetDifference(GetPoint(tube, id), axis[row]);
      const RelevoPosition next = GetDifference(GetPoint(tube, id + sides), axis[row + 1]);
      const RelevoPosition way = GetDifference(axis[row + 1], axis[row]);
      double turned[3];
      vtkMath::Cross(out.data(), next.data(), turned);
      turns.push_back(vtkMath::Dot(turned, way.data()) / (vtkMath::Norm(way.data()) * 0.04));
    }
  }
  const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
  CHECK_LESS(*most - *least, 0.02);
}

// A cone: the radius comes from an array, and normals are tilted.
void TestRadii(RelevoCheck& check)
{
  auto grid = RelevoNewGrid({ { { 0, 0, 0 } }, { { 0, 0, 4 } }, { { 0, 0, 1 } } });
  const std::array<vtkIdType, 3> ids{ 0, 1, 2 };
  grid->InsertNextCell(VTK_BEZIER_CURVE, 3, ids.data());
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radii");
  for (double radius : { 3.0, 0.0, 2.25 })
  {
    radii->InsertNextValue(radius);
  }
  grid->GetPointData()->AddArray(radii);
  auto filter = RelevoNewCurveFilter(grid, 4);
  filter->SetRepresentationToTubes();
  filter->SetRadiusArrayName("Radii");
  filter->Update();
  vtkPolyData* cone = filter->GetOutput();
  for (vtkIdType i = 0; i < 17 * 8; ++i)
  {
    const RelevoPosition place = GetPoint(cone, i);
    CHECK_NEAR(std::hypot(place[0], place[1]), 3.0 - 0.75 * place[2], 1e-14);
    CHECK_NEAR(cone->GetPointData()->GetNormals()->GetComponent(i, 2), 0.6, 1e-6);
    CHECK_NEAR(
      cone->GetPointData()->GetArray("Radii")->GetComponent(i, 0), 3.0 - 0.75 * place[2], 1e-14);
  }
}

// If control points coincide at an end, the curve still has a direction there.
void TestCoincident(RelevoCheck& check)
{
  auto grid = RelevoNewGrid({ { { 0, 0, 0 } }, { { 1, 1, 0 } } });
  const std::array<vtkIdType, 4> ids{ 0, 1, 0, 1 };
  grid->InsertNextCell(VTK_BEZIER_CURVE, 4, ids.data());
  auto filter = RelevoNewCurveFilter(grid, 3);
  filter->SetRepresentationToTubes();
  filter->SetRadius(Radius);
  filter->SetNumberOfSides(5);
  filter->Update();
  auto lines = RelevoNewCurveFilter(grid, 3);
  lines->Update();
  CheckRings(check, filter->GetOutput(), lines->GetOutput(), 5);
  CHECK_EQUAL(RelevoCountOpenEdges(filter->GetOutput()), 0);
}

void TestRibbons(RelevoCheck& check)
{
  auto grid = RelevoNewGrid(
    { { { -1, 0, 0 } }, { { 1, 0, -1 } }, { { -0.5, 0.5, 0 } }, { { 0.2, -0.3, 0.1 } } });
  const std::array<vtkIdType, 4> ids{ 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_BEZIER_CURVE, 4, ids.data());
  auto lines = RelevoNewCurveFilter(grid, 5);
  lines->Update();
  auto filter = RelevoNewCurveFilter(grid, 5);
  filter->SetRepresentationToRibbons();
  filter->SetRadius(Radius);
  for (bool isParallel : { false, true })
  {
    CHECK_CASE(isParallel);
    vtkNew<vtkCamera> camera;
    camera->SetPosition(4.0, 5.0, 6.0);
    camera->SetParallelProjection(isParallel);
    filter->SetCamera(camera);
    filter->Update();
    vtkPolyData* ribbon = filter->GetOutput();
    const std::vector<RelevoPosition> axis = RelevoGetCellPoints(lines->GetOutput(), 0);
    CHECK_EQUAL(ribbon->GetNumberOfPoints(), 66);
    CHECK_EQUAL(ribbon->GetNumberOfPolys(), 64);
    for (vtkIdType i = 0; i < 66; ++i)
    {
      const RelevoPosition out = GetDifference(GetPoint(ribbon, i), axis[i / 2]);
      const RelevoPosition toEye =
        GetDifference({ 4.0, 5.0, 6.0 }, isParallel ? RelevoPosition{} : axis[i / 2]);
      CHECK_NEAR(vtkMath::Norm(out.data()), Radius, 1e-14);
      CHECK_NEAR(vtkMath::Dot(out.data(), toEye.data()), 0.0, 1e-13);
      double normal[3];
      ribbon->GetPointData()->GetNormals()->GetTuple(i, normal);
      CHECK_GREATER(vtkMath::Dot(normal, toEye.data()), 0.0);
    }
    for (vtkIdType cell = 0; cell < 64; ++cell)
    {
      const std::vector<RelevoPosition> corners = RelevoGetCellPoints(ribbon, cell);
      double normal[3];
      vtkMath::Cross(GetDifference(corners[1], corners[0]).data(),
        GetDifference(corners[2], corners[0]).data(), normal);
      const RelevoPosition toEye =
        GetDifference({ 4.0, 5.0, 6.0 }, isParallel ? RelevoPosition{} : corners[0]);
      CHECK_GREATER(vtkMath::Dot(normal, toEye.data()), 0.0);
    }
  }
}
}

int TestAdaptiveCurveFilterTubes(int, char*[])
{
  RelevoCheck check;
  TestSingleTubes(check);
  TestJoinedTubes(check);
  TestKnot(check);
  TestRadii(check);
  TestCoincident(check);
  TestRibbons(check);
  return check.GetResult();
}
