// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinedCellLocator promises: after BuildLocator(), concurrent queries give the results of one
// thread and rebuild nothing. ForceBuildLocator() includes changes made without Modified().
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPoints.h"
#include "vtkRefinedCellLocator.h"

#include <array>
#include <thread>
#include <vector>

namespace
{
using namespace RelevoMeshes;
using Point = std::array<double, 3>;

struct Ray
{
  Point From;
  Point To;
};

// Intersections of a ray, cells close to it, cells in a box at its start, and the closest point.
std::vector<double> Query(vtkRefinedCellLocator* locator, const Ray& ray)
{
  const double tolerance = 1e-3;
  std::vector<double> answer;
  const auto append = [&answer](const Point& point)
  { answer.insert(answer.end(), point.begin(), point.end()); };
  const auto appendCells = [&answer](vtkIdList* ids)
  { answer.insert(answer.end(), ids->GetPointer(0), ids->GetPointer(ids->GetNumberOfIds())); };
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> cells;
  double t = -1.0;
  Point x{};
  double pcoords[3];
  int subId;
  vtkIdType id;
  locator->IntersectWithLine(
    ray.From.data(), ray.To.data(), tolerance, t, x.data(), pcoords, subId, id, cell);
  answer.insert(answer.end(), { t, static_cast<double>(id) });
  append(x);

  vtkNew<vtkPoints> points;
  locator->IntersectWithLine(ray.From.data(), ray.To.data(), points, cells);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, x.data());
    append(x);
  }

  double distance2;
  locator->FindClosestPoint(ray.From.data(), x.data(), cell, id, subId, distance2);
  answer.insert(answer.end(), { distance2, static_cast<double>(id) });
  append(x);

  double box[6];
  for (int c = 0; c < 3; ++c)
  {
    box[2 * c] = ray.From[c] - 0.1;
    box[2 * c + 1] = ray.From[c] + 0.1;
  }
  locator->FindCellsWithinBounds(box, cells);
  appendCells(cells);
  locator->FindCellsAlongLine(ray.From.data(), ray.To.data(), tolerance, cells);
  appendCells(cells);
  return answer;
}

std::vector<Ray> MakeRays(int count)
{
  RelevoDice dice(5);
  const auto point = [&dice](double extent) {
    return Point{ { extent * dice.Signed(), extent * dice.Signed(), extent * dice.Signed() } };
  };
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
  {
    rays.push_back({ point(0.7), point(0.3) });
  }
  return rays;
}

// Some points are also vertices, which are found without the search structure.
Mesh MakeInput()
{
  Mesh mesh = Tagged(Sphere(15, 11), 3);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    vertices->InsertNextCell(1, &point);
  }
  mesh->SetVerts(vertices);
  return mesh;
}

void TestThreads(RelevoCheck& check)
{
  const Mesh mesh = MakeInput();
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->SetRefinement(MakeRecipe(3, surface));
  locator->BuildLocator();
  const vtkMTimeType built = locator->GetBuildTime();
  const std::vector<Ray> rays = MakeRays(250);
  std::vector<std::vector<double>> expected;
  for (const Ray& ray : rays)
  {
    expected.push_back(Query(locator, ray));
  }

  std::array<int, 4> wrong{};
  std::vector<std::thread> threads;
  for (int& count : wrong)
  {
    threads.emplace_back(
      [&]
      {
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          count += Query(locator, rays[i]) == expected[i] ? 0 : 1;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (int count : wrong)
  {
    CHECK_EQUAL(count, 0);
  }
  CHECK_EQUAL(locator->GetBuildTime(), built);
}

// Vertices are tested one by one. Threads must not share a buffer for their points.
void TestVertices(RelevoCheck& check)
{
  const Mesh mesh = MakeInput();
  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->SetRefinement(MakeRecipe(1));
  locator->BuildLocator();
  const auto count = [&locator]
  {
    vtkNew<vtkIdList> cells;
    double box[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
    locator->FindCellsWithinBounds(box, cells);
    return cells->GetNumberOfIds();
  };
  std::array<int, 4> wrong{};
  std::vector<std::thread> threads;
  const vtkIdType expected = count();
  for (int& number : wrong)
  {
    threads.emplace_back(
      [&]
      {
        for (int i = 0; i < 2000; ++i)
        {
          number += count() == expected ? 0 : 1;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (int number : wrong)
  {
    CHECK_EQUAL(number, 0);
  }
}

double GetHeight(vtkRefinedCellLocator* locator)
{
  const double from[3] = { 0.1, 0.2, 9.0 };
  const double to[3] = { 0.1, 0.2, -9.0 };
  double t;
  double x[3] = { 0.0, 0.0, 0.0 };
  double pcoords[3];
  int subId;
  vtkIdType id;
  vtkNew<vtkGenericCell> cell;
  locator->IntersectWithLine(from, to, 0.0, t, x, pcoords, subId, id, cell);
  return x[2];
}

// Points that were moved without Modified().
void TestForced(RelevoCheck& check)
{
  const Mesh plane = Plane(4, 4);
  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(plane);
  locator->SetRefinement(MakeRecipe(2));
  CHECK_NEAR(GetHeight(locator), 0.0, 1e-6);
  for (vtkIdType point = 0; point < plane->GetNumberOfPoints(); ++point)
  {
    double x[3];
    plane->GetPoint(point, x);
    plane->GetPoints()->SetPoint(point, x[0], x[1], 1.0);
  }
  locator->BuildLocator();
  CHECK_NEAR(GetHeight(locator), 0.0, 1e-6);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  locator->ForceBuildLocator();
#else
  locator->FreeSearchStructure();
  locator->BuildLocator();
#endif
  CHECK_NEAR(GetHeight(locator), 1.0, 1e-6);
}
}

int TestRefinedCellLocatorThreads(int, char*[])
{
  RelevoCheck check;
  TestThreads(check);
  TestVertices(check);
  TestForced(check);
  return check.GetResult();
}
