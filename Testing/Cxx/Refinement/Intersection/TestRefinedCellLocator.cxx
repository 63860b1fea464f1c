// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinedCellLocator promises the same intersections, cells and closest points as VTK's locator
// on the filter's output. Lines through edges and vertices hit the surface.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRefinedCellLocator.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>

namespace
{
using namespace RelevoMeshes;
using Point = std::array<double, 3>;

struct Random
{
  std::mt19937 Engine{ 11 };
  double operator()() { return this->Engine() / 2147483648.0 - 1.0; } // in [-1, 1]
  Point operator()(const double bounds[6], double widened)
  {
    Point p;
    for (int c = 0; c < 3; ++c)
    {
      const double middle = 0.5 * (bounds[2 * c] + bounds[2 * c + 1]);
      const double half = 0.5 * (bounds[2 * c + 1] - bounds[2 * c]);
      p[c] = middle + widened * (half + 0.1) * (*this)();
    }
    return p;
  }
};

struct Found
{
  int Hit = 0;
  double T = 0.0;
  Point X{};
  vtkIdType Cell = -1;
};

Found Shoot(vtkAbstractCellLocator* locator, const Point& from, const Point& to, double tol = 0.0)
{
  Found found;
  double pcoords[3];
  int subId;
  vtkNew<vtkGenericCell> cell;
  found.Hit = locator->IntersectWithLine(
    from.data(), to.data(), tol, found.T, found.X.data(), pcoords, subId, found.Cell, cell);
  return found;
}

double Distance(const Point& a, const Point& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

// Holds the locator, and VTK's locator on the filter's output.
struct Twins
{
  Twins(vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
  {
    this->Locator->SetDataSet(mesh);
    this->Locator->SetRefinement(recipe);
    this->Refined = Refine(mesh, recipe);
    this->Oracle->SetDataSet(this->Refined);
    this->Oracle->BuildLocator();
  }
  vtkIdType GetInputCell(vtkIdType cell) const
  {
    return vtkIdTypeArray::SafeDownCast(
      this->Refined->GetCellData()->GetArray("vtkOriginalCellIds"))
      ->GetValue(cell);
  }
  vtkNew<vtkRefinedCellLocator> Locator;
  Mesh Refined;
  vtkNew<vtkStaticCellLocator> Oracle;
};

void Compare(RelevoCheck& check, const std::string& name, vtkPolyData* mesh,
  vtkAdaptiveRefinement* recipe, int lines = 300)
{
  Twins twins(mesh, recipe);
  double bounds[6];
  twins.Refined->GetBounds(bounds);
  const double length = twins.Refined->GetLength();
  Random random;
  int hits = 0;
  int wrong = 0;
  for (int i = 0; i < lines; ++i)
  {
    const Point from = random(bounds, 2.0);
    const Point to = random(bounds, 2.0);
    const Found found = Shoot(twins.Locator, from, to);
    const Found expected = Shoot(twins.Oracle, from, to);
    hits += found.Hit;
    const bool same = found.Hit == expected.Hit &&
      (!found.Hit ||
        (Distance(found.X, expected.X) < 1e-5 * length && std::abs(found.T - expected.T) < 1e-4 &&
          found.Cell == twins.GetInputCell(expected.Cell)));
    wrong += same ? 0 : 1;

    double near1[3];
    double near2[3];
    vtkIdType cell1;
    vtkIdType cell2;
    int subId;
    double distance1;
    double distance2;
    twins.Locator->FindClosestPoint(from.data(), near1, cell1, subId, distance1);
    twins.Oracle->FindClosestPoint(from.data(), near2, cell2, subId, distance2);
    wrong += std::abs(std::sqrt(distance1) - std::sqrt(distance2)) < 1e-5 * length ? 0 : 1;
  }
  // Two in a thousand lines may graze an edge within rounding.
  if (wrong > lines / 300 || hits < lines / 20)
  {
    check.Fail(__FILE__, __LINE__,
      name + ": " + std::to_string(wrong) + " of " + std::to_string(lines) + " wrong, " +
        std::to_string(hits) + " hits");
  }
}

// Lines from the inside of a closed refined surface through its points and edge midpoints must all
// hit it.
void CheckWatertight(RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  Twins twins(mesh, recipe);
  const Point inside{ { 0.01, -0.02, 0.015 } };
  int slipped = 0;
  const auto shoot = [&](const double* through)
  {
    Point to;
    for (int c = 0; c < 3; ++c)
    {
      to[c] = inside[c] + 4.0 * (through[c] - inside[c]);
    }
    slipped += Shoot(twins.Locator, inside, to).Hit ? 0 : 1;
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < twins.Refined->GetNumberOfCells(); ++cell)
  {
    twins.Refined->GetCellPoints(cell, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      twins.Refined->GetPoint(ids->GetId(i), p[i]);
      shoot(p[i]);
    }
    for (int i = 0; i < 3; ++i)
    {
      double middle[3];
      for (int c = 0; c < 3; ++c)
      {
        middle[c] = 0.5 * (p[i][c] + p[(i + 1) % 3][c]);
      }
      shoot(middle);
    }
  }
  CHECK_EQUAL(slipped, 0);
}

// A sphere of PN triangles is hit close to the exact sphere.
void CheckSphere(RelevoCheck& check)
{
  Mesh mesh = Sphere(24, 18);
  vtkNew<vtkPNTriangleSurface> surface;
  const auto recipe = MakeRecipe(4, surface);
  Twins twins(mesh, recipe);
  Random random;
  for (int i = 0; i < 200; ++i)
  {
    Point direction{ { random(), random(), random() } };
    vtkMath::Normalize(direction.data());
    const Point from{ { 2 * direction[0], 2 * direction[1], 2 * direction[2] } };
    const Found found = Shoot(twins.Locator, from, { { 0, 0, 0 } });
    CHECK(found.Hit);
    CHECK_NEAR(vtkMath::Norm(found.X.data()), 0.5, 1e-3);
    CHECK_NEAR(found.T, 0.75, 1e-3);
  }
}

// Vertices, lines, tolerances, ends of lines, and lines within a surface.
void CheckSpecialLines(RelevoCheck& check)
{
  Mesh mesh = Mixed();
  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(mesh);
  const auto recipe = MakeRecipe(2);
  locator->SetRefinement(recipe);
  const double* vertex = mesh->GetPoint(23);
  Found found =
    Shoot(locator, { { vertex[0], vertex[1], 5 } }, { { vertex[0], vertex[1], -5 } }, 1e-3);
  CHECK(found.Hit && found.Cell == 0);

  Mesh plane = Plane(2, 2);
  locator->SetDataSet(plane);
  CHECK_EQUAL(Shoot(locator, { { 0.1, 0.2, 1 } }, { { 0.1, 0.2, 0 } }).T, 1.0);
  CHECK_EQUAL(Shoot(locator, { { 0.1, 0.2, 0 } }, { { 0.1, 0.2, -1 } }).T, 0.0);
  CHECK(!Shoot(locator, { { 0.1, 0.2, 1 } }, { { 0.1, 0.2, 0.01 } }).Hit);
  CHECK(!Shoot(locator, { { 0.501, 0.2, 1 } }, { { 0.501, 0.2, -1 } }).Hit);
  found = Shoot(locator, { { 0.501, 0.2, 1 } }, { { 0.501, 0.2, -1 } }, 0.01);
  CHECK(found.Hit);
  CHECK_NEAR(found.X[0], 0.5, 1e-7);
  CHECK_NEAR(found.T, 0.5, 1e-7);
  found = Shoot(locator, { { -2, 0.2, 0 } }, { { 2, 0.2, 0 } }, 1e-6);
  CHECK(found.Hit);
  CHECK_NEAR(found.X[0], -0.5, 1e-5);
  CHECK(!Shoot(locator, { { 0, 0, 1 } }, { { 0, 0, 1 } }).Hit);

  // The lists contain the cells close to a box and to a line.
  vtkNew<vtkIdList> cells;
  double box[6] = { 0.1, 0.2, 0.1, 0.2, -0.1, 0.1 };
  locator->FindCellsWithinBounds(box, cells);
  CHECK_EQUAL(cells->GetNumberOfIds(), 1);
  CHECK_EQUAL(cells->GetId(0), 3);
  const double p1[3] = { -0.4, -0.3, 0.0 };
  const double p2[3] = { 0.4, -0.3, 0.0 };
  locator->FindCellsAlongLine(p1, p2, 0.0, cells);
  CHECK_EQUAL(cells->GetNumberOfIds(), 2);
  CHECK_EQUAL(cells->GetId(0), 0);
  CHECK_EQUAL(cells->GetId(1), 1);

  vtkNew<vtkPolyData> refined;
  locator->GenerateRepresentation(0, refined);
  CHECK_EQUAL(refined->GetNumberOfCells(), 8 * 16);
}

// Changes take effect, and input that cannot be used is an error.
void CheckChanges(RelevoCheck& check)
{
  Mesh plane = Plane(4, 4);
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(1.0);
  displacement->SetDirection(0, 0, 1);
  const auto recipe = MakeRecipe(2, nullptr, displacement);
  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(plane);
  locator->SetRefinement(recipe);
  const auto heightOf = [&]() {
    return Shoot(locator, { { 0.1, 0.2, 9 } }, { { 0.1, 0.2, -9 } }).X[2];
  };
  CHECK_NEAR(heightOf(), 1.0, 1e-6);
  displacement->SetOffset(2.0);
  CHECK_NEAR(heightOf(), 2.0, 1e-6);
  plane->GetPoints()->SetPoint(12, 0.0, 0.0, 1.0);
  plane->GetPoints()->Modified();
  CHECK_GREATER(heightOf(), 2.1);
  double x[3] = { 0.1, 0.2, 9 };
  double closest[3];
  double distance2;
  vtkIdType cell;
  int subId;
  CHECK_EQUAL(locator->FindClosestPointWithinRadius(x, 5.0, closest, cell, subId, distance2), 0);
  CHECK_EQUAL(locator->FindClosestPointWithinRadius(x, 7.0, closest, cell, subId, distance2), 1);

  // With a view-dependent metric, a curved surface is finer and closer to the sphere near the
  // camera.
  Mesh sphere = Sphere(8, 6);
  vtkNew<vtkPNTriangleSurface> surface;
  const auto viewed = MakeRecipe(5, surface);
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(1.0);
  viewed->SetMetric(metric);
  locator->SetDataSet(sphere);
  locator->SetRefinement(viewed);
  RelevoErrors errors(locator);
  {
    RelevoErrors ofMetric(metric);
    heightOf();
  }
  CHECK(errors.Said("Cannot refine the input"));
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 50.0);
  locator->SetCamera(camera);
  const double coarse = heightOf();
  camera->SetPosition(0.0, 0.0, 0.6);
  CHECK_GREATER(heightOf(), coarse + 1e-4);

  locator->SetRefinement(nullptr);
  heightOf();
  CHECK(errors.Said("no recipe"));
  locator->SetDataSet(nullptr);
  heightOf();
  CHECK(errors.Said("needs a vtkPolyData"));
  locator->SetViewportSize(0, 5);
  CHECK(errors.Said("ViewportSize must be at least 1 x 1 pixels"));
}

// All intersections of a line, compared with a search through all cells of the filter's output.
void CheckAllPoints(RelevoCheck& check)
{
  vtkNew<RelevoHeights> waves;
  waves->FillWaves();
  auto displacement = MakeDisplacement(waves, 0.15);
  Twins twins(Torus(), MakeRecipe(3, nullptr, displacement));
  double bounds[6];
  twins.Refined->GetBounds(bounds);
  Random random;
  vtkDataArray* originals = twins.Refined->GetCellData()->GetArray("vtkOriginalCellIds");
  int differing = 0;
  int most = 0;
  for (int line = 0; line < 60; ++line)
  {
    const Point from = random(bounds, 1.5);
    const Point to = random(bounds, 1.5);
    std::map<double, vtkIdType> expected;
    for (vtkIdType id = 0; id < twins.Refined->GetNumberOfCells(); ++id)
    {
      double t;
      double x[3];
      double pcoords[3];
      int subId;
      if (twins.Refined->GetCell(id)->IntersectWithLine(
            from.data(), to.data(), 0.0, t, x, pcoords, subId))
      {
        expected[t] = static_cast<vtkIdType>(originals->GetTuple1(id));
      }
    }
    vtkNew<vtkPoints> points;
    vtkNew<vtkIdList> cells;
    const int found =
      twins.Locator->IntersectWithLine(from.data(), to.data(), 0.0, points, cells, nullptr);
    CHECK_EQUAL(found, (points->GetNumberOfPoints() > 0 ? 1 : 0));
    CHECK_EQUAL(cells->GetNumberOfIds(), points->GetNumberOfPoints());
    bool same = points->GetNumberOfPoints() == static_cast<vtkIdType>(expected.size());
    vtkIdType i = 0;
    for (auto hit = expected.begin(); same && hit != expected.end(); ++hit, ++i)
    {
      Point p;
      Point q;
      points->GetPoint(i, p.data());
      for (int c = 0; c < 3; ++c)
      {
        q[c] = from[c] + hit->first * (to[c] - from[c]);
      }
      same = Distance(p, q) < 1e-5 && cells->GetId(i) == hit->second;
    }
    differing += same ? 0 : 1;
    most = std::max(most, static_cast<int>(points->GetNumberOfPoints()));
  }
  CHECK_LESS_EQUAL(differing, 1); // a line through an edge may differ by rounding
  CHECK_GREATER_EQUAL(most, 4);

  // Lines that start inside, start outside or miss, with null output lists.
  vtkNew<vtkRefinedCellLocator> ball;
  ball->SetDataSet(Sphere(12, 9));
  ball->SetRefinement(MakeRecipe(2));
  const double inside[3] = { 0.01, 0.02, 0.03 };
  const double outside[3] = { 3.0, 0.1, 0.2 };
  const double beyond[3] = { -3.0, 0.1, 0.2 };
  const double above[3] = { 3.0, 0.1, 2.0 };
  vtkNew<vtkPoints> points;
  CHECK_EQUAL(ball->IntersectWithLine(inside, outside, points, nullptr), -1);
  CHECK_EQUAL(points->GetNumberOfPoints(), 1);
  CHECK_EQUAL(ball->IntersectWithLine(outside, beyond, points, nullptr), 1);
  CHECK_EQUAL(points->GetNumberOfPoints(), 2);
  CHECK_GREATER(points->GetPoint(0)[0], points->GetPoint(1)[0]);
  CHECK_EQUAL(ball->IntersectWithLine(outside, above, points, nullptr), 0);
  CHECK_EQUAL(points->GetNumberOfPoints(), 0);
  CHECK_EQUAL(ball->IntersectWithLine(outside, inside, 0.1, nullptr, nullptr), 1);
}
}

int TestRefinedCellLocator(int, char*[])
{
  RelevoCheck check;
  vtkNew<RelevoHeights> waves;
  waves->FillWaves();
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(40, 30, 3);
  vtkNew<RelevoHeights> holes;
  holes->FillWavesWithHoles();
  const auto displace = [](vtkHeightField* heights, double scale)
  {
    auto displacement = vtkSmartPointer<vtkDisplacement>::New();
    displacement->SetHeightMap(heights);
    displacement->SetScale(scale);
    displacement->SetOffset(0.02);
    return displacement;
  };
  for (const auto& surface : RelevoMakeSurfaces(1.0))
  {
    Mesh mesh = Tagged(Torus(), 4);
    AddRandomScalarTags(mesh, 5);
    Compare(check, surface.first, mesh, MakeRecipe(4, surface.second));
    Compare(check, surface.first + ", displaced", mesh,
      MakeRecipe(4, surface.second, displace(rough, 0.2)));
  }
  Compare(check, "holes", Plane(7, 5), MakeRecipe(4, nullptr, displace(holes, 0.2)), 900);
  Compare(check, "seams", TexturedSphere(12, 9), MakeRecipe(3, nullptr, displace(waves, 0.1)));
  Compare(check, "strips", Tagged(Strips(), 4), MakeRecipe(4));
  Compare(check, "no manifold", NonManifold(), MakeRecipe(3));
  const double offset[3] = { 5e5, -4e6, 1e3 };
  Compare(check, "far away", Moved(Torus(), 100.0, offset, VTK_DOUBLE),
    MakeRecipe(3, nullptr, displace(rough, 30.0)));
  const auto whole = MakeRecipe(4, nullptr, displace(rough, 0.2));
  whole->SetSegmentPolicyToWholeNumbers();
  Compare(check, "whole segments", Tagged(Torus(), 4), whole);

  vtkNew<vtkPNTriangleSurface> pn;
  CheckWatertight(check, Tagged(Sphere(9, 7), 4), MakeRecipe(4, pn));
  CheckWatertight(check, TexturedSphere(9, 7), MakeRecipe(3, pn, displace(waves, 0.05)));
  CheckSphere(check);
  CheckSpecialLines(check);
  CheckChanges(check);
  CheckAllPoints(check);
  return check.GetResult();
}
