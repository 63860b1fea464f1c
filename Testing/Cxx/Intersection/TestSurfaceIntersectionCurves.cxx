// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises closed curves that do not depend on the number of threads
// or on the motion of both inputs. Pairs of cells are those of VTK's filters.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoIntersections.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntersectionPolyDataFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPTools.h"
#include "vtkStripper.h"
#include "vtkSurfaceIntersectionFilter.h"

namespace
{
std::array<double, 3> MakeVector(RelevoDice& dice, double size)
{
  return { size * dice.Signed(), size * dice.Signed(), size * dice.Signed() };
}

// Whether each point is the end of an even number of segments.
bool IsClosed(vtkPolyData* curves)
{
  std::vector<int> degrees(curves->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> points;
    curves->GetCellPoints(i, points);
    ++degrees[points->GetId(0)];
    ++degrees[points->GetId(points->GetNumberOfIds() - 1)];
  }
  bool isClosed = true;
  for (int degree : degrees)
  {
    isClosed = isClosed && degree % 2 == 0;
  }
  return isClosed;
}

void CheckJoined(RelevoCheck& check, vtkSurfaceIntersectionFilter* filter)
{
  const double length = RelevoMeasureLength(filter->GetOutput());
  const vtkIdType numberOfPoints = filter->GetOutput()->GetNumberOfPoints();
  filter->JoinSegmentsOn();
  filter->Update();
  vtkPolyData* curves = filter->GetOutput();
  CHECK_NEAR(RelevoMeasureLength(curves), length, 1e-9);
  CHECK_EQUAL(curves->GetNumberOfPoints(), numberOfPoints);
  auto components = vtkIdTypeArray::SafeDownCast(curves->GetCellData()->GetArray("ComponentId"));
  CHECK(components && components->GetNumberOfValues() == curves->GetNumberOfCells());
  // For two convex surfaces, each curve is closed, and no two curves meet.
  for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> points;
    curves->GetCellPoints(i, points);
    CHECK_EQUAL(points->GetId(0), points->GetId(points->GetNumberOfIds() - 1));
    CHECK_EQUAL(components->GetValue(i), i);
  }
  filter->JoinSegmentsOff();
}

void TestSpheres(RelevoCheck& check)
{
  RelevoDice dice(1);
  auto fine = RelevoMakeSphere(20, { 0, 0, 0 }, 1.0);
  auto coarse = RelevoMakeSphere(7, { 0, 0, 0 }, 1.2);
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, fine);
  filter->SetInputData(1, coarse);
  int crossed = 0;
  for (int i = 0; i < 40; ++i)
  {
    auto matrix =
      RelevoMakeMotion(MakeVector(dice, 0.9), 360.0 * dice.Share(), MakeVector(dice, 1.0));
    filter->SetMatrix(1, matrix);
    filter->Update();
    vtkPolyData* curves = filter->GetOutput();
    CHECK(curves->GetNumberOfVerts() == 0 && filter->GetOutput(1)->GetNumberOfCells() == 0);
    CHECK(IsClosed(curves));
    crossed += curves->GetNumberOfLines() > 0;

    auto moved = RelevoMove(coarse, matrix);
    vtkNew<vtkSurfaceIntersectionFilter> other;
    other->SetInputData(0, fine);
    other->SetInputData(1, moved);
    other->Update();
    CHECK(RelevoIsSameMesh(curves, other->GetOutput()));

    vtkNew<vtkIntersectionPolyDataFilter> vtk;
    vtk->SetInputData(0, fine);
    vtk->SetInputData(1, moved);
    vtk->SplitFirstOutputOff();
    vtk->SplitSecondOutputOff();
    vtk->Update();
    CHECK_EQUAL(RelevoGetCellPairs(curves), RelevoGetCellPairs(vtk->GetOutput()));
    CHECK_NEAR(RelevoMeasureLength(curves), RelevoMeasureLength(vtk->GetOutput()), 1e-4);
    CheckJoined(check, filter);
  }
  CHECK_GREATER(crossed, 20);
  CHECK_EQUAL(filter->GetNumberOfTreeBuilds(), 2);
  fine->GetPoints()->SetPoint(0, 0.0, 0.0, 1.01);
  fine->GetPoints()->Modified();
  fine->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfTreeBuilds(), 3);
}

// Octahedra that share four triangles. The curve bounds these and continues from one to the next.
void TestOctahedra(RelevoCheck& check)
{
  std::vector<std::array<double, 3>> points{ { 2, 0, 0 }, { -2, 0, 0 }, { 0, 2, 0 }, { 0, -2, 0 },
    { 0, 0, 2 }, { 0, 0, -2 } };
  const std::vector<std::vector<vtkIdType>> cells{ { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 },
    { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  auto first = RelevoMakePolygons(points, cells);
  for (auto& point : points)
  {
    point[0] += 1.0;
    point[1] += 1.0;
  }
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, first);
  filter->SetInputData(1, RelevoMakePolygons(points, cells));
  filter->Update();
  CHECK_EQUAL(filter->GetOutput(1)->GetNumberOfCells(), 4);
  CHECK_EQUAL(filter->GetOutput(1)->GetNumberOfPoints(), 8);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfVerts(), 0);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), 4 * 2 + 2);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 8);
  filter->JoinSegmentsOn();
  filter->Update();
  // Three lines meet at four of the points.
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), 6);
  vtkDataArray* components = filter->GetOutput()->GetCellData()->GetArray("ComponentId");
  CHECK_EQUAL(components->GetRange(0)[1], 0.0);
}

void TestItself(RelevoCheck& check)
{
  auto first = RelevoMakeSphere(12, { 0, 0, 0 }, 1.0);
  auto second = RelevoMakeSphere(9, { 0.7, 0.4, 0.3 }, 1.0);
  vtkNew<vtkSurfaceIntersectionFilter> pair;
  pair->SetInputData(0, first);
  pair->SetInputData(1, second);
  pair->Update();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(first);
  both->AddInputData(second);
  vtkNew<vtkSurfaceIntersectionFilter> self;
  self->SetInputConnection(both->GetOutputPort());
  self->Update();
  CHECK_GREATER(pair->GetOutput()->GetNumberOfLines(), 50);
  CHECK_EQUAL(self->GetOutput()->GetNumberOfCells(), pair->GetOutput()->GetNumberOfCells());
  CHECK_EQUAL(self->GetOutput()->GetNumberOfPoints(), pair->GetOutput()->GetNumberOfPoints());
  CHECK(IsClosed(self->GetOutput()));
  std::set<std::pair<vtkIdType, vtkIdType>> expected;
  for (const auto& ids : RelevoGetCellPairs(pair->GetOutput()))
  {
    expected.emplace(ids.first, first->GetNumberOfCells() + ids.second);
  }
  CHECK_EQUAL(RelevoGetCellPairs(self->GetOutput()), expected);
  self->SetInputData(first);
  self->Update();
  CHECK(self->GetOutput()->GetNumberOfCells() == 0 && self->GetOutput(1)->GetNumberOfCells() == 0);
  CHECK_EQUAL(self->GetOutput(2)->GetNumberOfCells(), first->GetNumberOfCells());
  CHECK_EQUAL(self->GetOutput(3)->GetNumberOfCells(), 0);
}

void TestThreads(RelevoCheck& check)
{
  auto first = RelevoMakeSphere(40, { 0, 0, 0 }, 1.0);
  auto second = RelevoMakeBox(-0.75, 0.75);
  std::vector<vtkSmartPointer<vtkPolyData>> outputs[2];
  for (int run = 0; run < 4; ++run)
  {
    vtkSMPTools::Initialize(run < 2 ? 4 : 1);
    for (int i = 0; i < 2; ++i)
    {
      // A box and a sphere, with settings that must not change the result.
      vtkNew<vtkSurfaceIntersectionFilter> filter;
      filter->SetInputData(0, first);
      filter->SetInputData(1, i == 0 ? second : first);
      filter->ClassifyOn();
      filter->SetContactDistance(0.1);
      filter->Update();
      for (int port = 0; port < 4; ++port)
      {
        auto copy = vtkSmartPointer<vtkPolyData>::New();
        copy->DeepCopy(filter->GetOutput(port));
        if (run == 0)
        {
          outputs[i].push_back(copy);
        }
        CHECK(RelevoIsSameMesh(outputs[i][port], copy));
      }
    }
  }
  vtkSMPTools::Initialize();
  CHECK_GREATER(outputs[0][0]->GetNumberOfLines(), 100);
  CHECK_EQUAL(outputs[1][1]->GetNumberOfPolys(), first->GetNumberOfPolys());
}

void TestStrips(RelevoCheck& check)
{
  auto first = RelevoMakeSphere(15, { 0, 0, 0 }, 1.0);
  auto second = RelevoMakeBox(-0.71, 0.73);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(first);
  stripper->Update();
  CHECK_GREATER(stripper->GetOutput()->GetNumberOfStrips(), 0);
  double lengths[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSurfaceIntersectionFilter> filter;
    filter->SetInputData(0, i == 0 ? first.Get() : stripper->GetOutput());
    filter->SetInputData(1, second);
    filter->Update();
    CHECK(IsClosed(filter->GetOutput()));
    lengths[i] = RelevoMeasureLength(filter->GetOutput());
  }
  CHECK_GREATER(lengths[0], 10.0);
  CHECK_NEAR(lengths[1], lengths[0], 1e-9);
}
}

int TestSurfaceIntersectionCurves(int, char*[])
{
  RelevoCheck check;
  TestSpheres(check);
  TestOctahedra(check);
  TestItself(check);
  TestThreads(check);
  TestStrips(check);
  return check.GetResult();
}
