// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementFilter promises the recipe's levels, triangles that wind as their coarse
// cell does, and an update only after a change.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDepthTagFilter.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkRefinementPatternTable.h"
#include "vtkTriangle.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>

using namespace RelevoMeshes;

namespace
{
void setTags(vtkPolyData* mesh, const std::vector<double>& values)
{
  vtkNew<vtkFloatArray> tags;
  tags->SetName("DepthTag");
  for (double value : values)
  {
    tags->InsertNextValue(static_cast<float>(value));
  }
  mesh->GetPointData()->AddArray(tags);
}

Mesh refine(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(input);
  filter->SetRefinement(recipe);
  filter->Update();
  return filter->GetOutput();
}

Mesh makeTriangle()
{
  return FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
}

// The pattern [d, d, d] has 4^d triangles.
void testUniformLevels(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  CHECK_EQUAL(recipe->GetMaximumLevel(), 3);
  Mesh sphere = Sphere(8, 6);
  const vtkIdType n = sphere->GetNumberOfPolys();
  for (int level = 0; level <= 7; ++level)
  {
    recipe->SetMaximumLevel(level);
    CHECK(refine(makeTriangle(), recipe)->GetNumberOfPolys() == 1 << 2 * level);
    if (level <= 5)
    {
      CHECK(refine(sphere, recipe)->GetNumberOfPolys() == n << 2 * level);
    }
  }
  for (int level = 0; level <= 5; ++level)
  {
    setTags(sphere, std::vector<double>(static_cast<size_t>(sphere->GetNumberOfPoints()), level));
    CHECK(refine(sphere, recipe)->GetNumberOfPolys() == n << 2 * level);
  }
  // Level 0 is the input mesh.
  recipe->SetMaximumLevel(0);
  Mesh same = refine(sphere, recipe);
  CHECK_EQUAL(same->GetNumberOfPoints(), sphere->GetNumberOfPoints());
  vtkNew<vtkIdList> coarse;
  vtkNew<vtkIdList> fine;
  for (vtkIdType cell = 0; cell < n; ++cell)
  {
    sphere->GetCellPoints(cell, coarse);
    same->GetCellPoints(cell, fine);
    int first = 0;
    while (first < 2 && fine->GetId(first) != coarse->GetId(0))
    {
      ++first;
    }
    for (int i = 0; i < 3; ++i)
    {
      CHECK_EQUAL(fine->GetId((first + i) % 3), coarse->GetId(i));
    }
  }
}

// Level of the edge from (0, 0) to (1, 0), from the number of points on it.
void testEdgeLevels(RelevoCheck& check)
{
  const double inf = std::numeric_limits<double>::infinity();
  struct Rule
  {
    double A;
    double B;
    int Level;
  };
  const Rule rules[] = { { 0, 0, 0 }, { 0, 0.98, 0 }, { 0, 1, 1 }, { 1, 2, 2 }, { 2, 2.98, 2 },
    { 2.5, 2.5, 3 }, { 2.49, 2.49, 2 }, { -5, 9, 2 }, { -3, -2, 0 }, { 100, 100, 4 }, { 7, -1, 3 },
    { 3.9, 4, 4 }, { inf, 0, 4 }, { -inf, 3, 0 }, { 1e20, 2, 4 }, { 2e6, -1e6, 4 } };
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  for (const Rule& rule : rules)
  {
    for (double other : { 0.0, 2.0, 5.0 })
    {
      CHECK_CASE(other);
      Mesh triangle = makeTriangle();
      setTags(triangle, { rule.A, rule.B, other });
      Mesh refined = refine(triangle, recipe);
      int points = 0;
      for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
      {
        points += refined->GetPoint(i)[1] == 0.0 ? 1 : 0;
      }
      CHECK_EQUAL(points, (1 << rule.Level) + 1);
    }
  }
  // Coincident points use the larger of their tags, whichever point has it.
  for (int larger = 0; larger < 2; ++larger)
  {
    Mesh pair = FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } },
                                { { 0, 1, 0 } }, { { 1, 1, 0 } } },
      { { { 0, 1, 2 } }, { { 3, 5, 4 } } });
    setTags(pair, { 0, larger ? 3.0 : 1.0, 2, larger ? 1.0 : 3.0, 2, 0 });
    Mesh refined = refine(pair, recipe);
    CHECK(RelevoWatertight::FindError(pair, refined, 4).empty());
    int diagonal = 0;
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      const double* p = refined->GetPoint(i);
      diagonal += p[0] + p[1] == 1.0 ? 1 : 0;
    }
    CHECK_EQUAL(diagonal, 2 * 9); // 8 segments from (3 + 2) / 2, on both sides
  }
  // The array may have any numeric type and any name.
  Mesh triangle = makeTriangle();
  vtkNew<vtkIdTypeArray> integers;
  integers->SetName("Deep");
  for (int i = 0; i < 3; ++i)
  {
    integers->InsertNextValue(2);
  }
  triangle->GetPointData()->AddArray(integers);
  CHECK_EQUAL(refine(triangle, recipe)->GetNumberOfPolys(), 256);
  recipe->SetDepthTagArrayName("Deep");
  CHECK_EQUAL(refine(triangle, recipe)->GetNumberOfPolys(), 16);
}

// Sums of triangle normals, whose length is twice the area, and of their lengths.
struct Area
{
  void Add(const double p[3][3])
  {
    double normal[3];
    vtkTriangle::ComputeNormalDirection(p[0], p[1], p[2], normal);
    vtkMath::Add(this->Vector, normal, this->Vector);
    this->Sum += vtkMath::Norm(normal);
  }
  double Vector[3] = { 0, 0, 0 };
  double Sum = 0.0;
};

// Areas of the pieces of each coarse cell. All pieces lie inside it.
std::vector<Area> getFineAreas(RelevoCheck& check, vtkPolyData* mesh, vtkPolyData* refined)
{
  vtkDataArray* originals = refined->GetCellData()->GetArray("vtkOriginalCellIds");
  CHECK_NOT_EQUAL(vtkIdTypeArray::SafeDownCast(originals), nullptr);
  const vtkIdType n = mesh->GetNumberOfCells();
  std::vector<Area> areas(static_cast<size_t>(n));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    const vtkIdType original = static_cast<vtkIdType>(originals->GetTuple1(cell));
    CHECK_GREATER_EQUAL(original, 0);
    CHECK_LESS(original, n);
    if (refined->GetCellType(cell) != VTK_TRIANGLE)
    {
      CHECK_EQUAL(original, cell);
      continue;
    }
    double p[3][3];
    refined->GetCellPoints(cell, ids);
    double bounds[6];
    mesh->GetCell(original)->GetBounds(bounds);
    for (int i = 0; i < 3; ++i)
    {
      refined->GetPoint(ids->GetId(i), p[i]);
      for (int c = 0; c < 3; ++c)
      {
        CHECK(p[i][c] >= bounds[2 * c] - 1e-6 && p[i][c] <= bounds[2 * c + 1] + 1e-6);
      }
    }
    areas[original].Add(p);
  }
  return areas;
}

// Area of a coarse cell; zero for cells that are neither polygons nor strips.
Area getCoarseArea(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkPolyData> one;
  one->SetPoints(mesh->GetPoints());
  vtkNew<vtkIdList> ids;
  vtkNew<vtkCellArray> cells;
  mesh->GetCellPoints(cell, ids);
  cells->InsertNextCell(ids);
  const int type = mesh->GetCellType(cell);
  if (type == VTK_TRIANGLE_STRIP)
  {
    one->SetStrips(cells);
  }
  else if (mesh->GetCell(cell)->GetCellDimension() == 2)
  {
    one->SetPolys(cells);
  }
  std::vector<vtkIdType> places(static_cast<size_t>(mesh->GetNumberOfPoints()));
  std::iota(places.begin(), places.end(), vtkIdType(0));
  Area area;
  for (const auto& triangle : RelevoWatertight::GetTriangles(one, places))
  {
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(triangle[i], p[i]);
    }
    area.Add(p);
  }
  return area;
}

// The pieces of each coarse cell cover its area and face the same side.
void testWinding(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  for (Mesh mesh :
    { Sphere(8, 6), Cube(), Strips(), Mixed(), NonManifold(), Explode(Sphere(5, 4)) })
  {
    for (unsigned int seed = 0; seed < 5; ++seed)
    {
      AddTags(mesh, seed, 5);
      const auto fine = getFineAreas(check, mesh, refine(mesh, recipe));
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
      {
        const Area area = getCoarseArea(mesh, cell);
        const double sum = area.Sum;
        CHECK_LESS_EQUAL(
          std::sqrt(vtkMath::Distance2BetweenPoints(area.Vector, fine[cell].Vector)), 1e-5 * sum);
        CHECK_NEAR(fine[cell].Sum, sum, 1e-5 * sum);
      }
    }
  }
}

// A metric with a camera gives the same levels as the tags of vtkDepthTagFilter.
void testMetric(RelevoCheck& check)
{
  Mesh sphere = Sphere(20, 16);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.3, 1.2);
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(1.5);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(5);
  recipe->SetMetric(metric);
  recipe->GeomorphingOff(); // an array of tags has no geomorphing either
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(sphere);
  filter->SetRefinement(recipe);
  filter->SetCamera(camera);
  filter->Update();
  Mesh byMetric = Make();
  byMetric->DeepCopy(filter->GetOutput());

  vtkNew<vtkDepthTagFilter> tags;
  tags->SetInputData(sphere);
  tags->SetMetric(metric);
  tags->SetCamera(camera);
  tags->SetMaximumLevel(5);
  tags->Update();
  Mesh byArray = refine(vtkPolyData::SafeDownCast(tags->GetOutputDataObject(0)), recipe);
  CHECK_EQUAL(byMetric->GetNumberOfPolys(), byArray->GetNumberOfPolys());
  CHECK_EQUAL(byMetric->GetNumberOfPoints(), byArray->GetNumberOfPoints());
  CHECK_GREATER(byMetric->GetNumberOfPolys(), sphere->GetNumberOfPolys());
  CHECK_LESS(byMetric->GetNumberOfPolys(), sphere->GetNumberOfPolys() * 1024);
  for (vtkIdType i = 0; i < byArray->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(vtkMath::Distance2BetweenPoints(byArray->GetPoint(i), byMetric->GetPoint(i)), 0.0);
  }
  camera->SetPosition(0.0, 0.0, 100.0);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), sphere->GetNumberOfPolys());
}

// The filter executes again only if something that it uses has changed.
void testModified(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(3, 3, 1);
  vtkNew<vtkDisplacement> displacement;
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(5);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(Plane(2, 2));
  filter->SetRefinement(recipe);
  filter->Update();
  auto runs = [&]()
  {
    const vtkMTimeType before = filter->GetOutput()->GetMTime();
    filter->Update();
    return filter->GetOutput()->GetMTime() != before;
  };
  CHECK(!runs());
  recipe->SetMaximumLevel(5);
  CHECK(!runs());
  recipe->SetMaximumLevel(3);
  CHECK(runs());
  recipe->GetPatternTable()->SetMaximumLevel(2);
  CHECK(runs());
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 8 * 16);
  recipe->SetSurface(surface);
  CHECK(runs());
  surface->QuadraticNormalsOff();
  CHECK(runs());
  recipe->SetDisplacement(displacement);
  CHECK(runs());
  displacement->SetHeightMap(heights);
  CHECK(runs());
  displacement->SetScale(2.0);
  CHECK(runs());
  heights->FillRandom(3, 3, 2);
  CHECK(runs());
  recipe->SetDepthTagArrayName("Tags");
  CHECK(runs());
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(5.0);
  vtkNew<vtkCamera> camera;
  filter->SetCamera(camera);
  recipe->SetMetric(metric);
  CHECK(runs());
  camera->SetPosition(0.0, 0.0, 2.0);
  CHECK(runs());
  metric->SetMaximumDistance(6.0);
  CHECK(runs());
  CHECK(!runs());
}

// The composite pipeline passes one block at a time.
void testBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(0, makeTriangle());
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetNumberOfBlocks(1);
  inner->SetBlock(0, Cube());
  blocks->SetBlock(2, inner);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputDataObject(blocks);
  filter->SetRefinement(recipe);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  CHECK(output && output->GetNumberOfBlocks() == 3);
  auto* first = vtkPolyData::SafeDownCast(output->GetBlock(0));
  CHECK(first && first->GetNumberOfPolys() == 16);
  CHECK_EQUAL(output->GetBlock(1), nullptr);
  auto* last = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  auto* cube = last ? vtkPolyData::SafeDownCast(last->GetBlock(0)) : nullptr;
  CHECK(cube && cube->GetNumberOfPolys() == 12 * 16);
}

// Progress rises from 0 to 1. After an abort the output is empty.
void testProgress(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(5);
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(8, 8, 1);
  heights->Punch([](int x, int y) { return x == 3 && y == 3; });
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  recipe->SetDisplacement(displacement);
  struct Watch : vtkCommand
  {
    static Watch* New() { return new Watch; }
    void Execute(vtkObject* caller, unsigned long, void* data) override
    {
      const double progress = *static_cast<double*>(data);
      this->Rises &= progress >= this->Last;
      this->Last = progress;
      ++this->Calls;
      if (progress >= this->AbortAt)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    }
    double AbortAt = 2.0;
    double Last = -1.0;
    bool Rises = true;
    int Calls = 0;
  };
  for (double abortAt : { 2.0, 0.0, 0.15, 0.3, 0.5, 0.8 })
  {
    CHECK_CASE(abortAt);
    vtkNew<Watch> watch;
    watch->AbortAt = abortAt;
    vtkNew<vtkAdaptiveRefinementFilter> filter;
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->SetInputData(Plane(10, 10));
    filter->SetRefinement(recipe);
    filter->Update();
    CHECK(watch->Rises);
    if (abortAt > 1.0)
    {
      CHECK_EQUAL(watch->Last, 1.0);
      CHECK_GREATER(watch->Calls, 10);
      CHECK_GREATER(filter->GetOutput()->GetNumberOfPolys(), 0);
    }
    else
    {
      CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 0);
      CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
      CHECK_EQUAL(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
    }
  }
}
}

int TestAdaptiveRefinementFilter(int, char*[])
{
  RelevoCheck check;
  testUniformLevels(check);
  testEdgeLevels(check);
  testWinding(check);
  testMetric(check);
  testModified(check);
  testBlocks(check);
  testProgress(check);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->Print(std::cout);
  return check.GetResult();
}
