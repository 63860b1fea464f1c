// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises distances of cells and which cells are near or inside,
// compared with VTK's functions for points and segments.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoIntersections.h"

#include "vtkAppendPolyData.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSurfaceIntersectionFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Corners = std::array<std::array<double, 3>, 3>;

Corners GetCorners(vtkPolyData* mesh, vtkIdType cell)
{
  Corners corners;
  for (int i = 0; i < 3; ++i)
  {
    mesh->GetCell(cell)->GetPoints()->GetPoint(i, corners[i].data());
  }
  return corners;
}

double GetDistance(vtkPolyData* first, vtkIdType i, vtkPolyData* second, vtkIdType j)
{
  Corners corners[2] = { GetCorners(first, i), GetCorners(second, j) };
  double square = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 2; ++side)
  {
    vtkCell* cell = side == 0 ? second->GetCell(j) : first->GetCell(i);
    for (const auto& corner : corners[side])
    {
      double closest[3], coordinates[3], weights[3], distance;
      int part;
      cell->EvaluatePosition(corner.data(), closest, part, coordinates, distance, weights);
      square = std::min(square, distance);
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      double closest[2][3], t[2];
      square = std::min(square,
        vtkLine::DistanceBetweenLineSegments(corners[0][a].data(), corners[0][(a + 1) % 3].data(),
          corners[1][b].data(), corners[1][(b + 1) % 3].data(), closest[0], closest[1], t[0],
          t[1]));
    }
  }
  return std::sqrt(square);
}

double Get(vtkPolyData* mesh, const char* array, vtkIdType cell)
{
  return mesh->GetCellData()->GetArray(array)->GetComponent(cell, 0);
}

// A sphere that moves through another one.
void TestSpheres(RelevoCheck& check)
{
  auto large = RelevoMakeSphere(9, { 0, 0, 0 }, 1.0);
  auto small = RelevoMakeSphere(6, { 0, 0, 0 }, 0.4);
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, large);
  filter->SetInputData(1, small);
  filter->ClassifyOn();
  filter->SetContactDistance(0.3);
  RelevoErrors errors(filter);
  std::set<double> seen;
  for (double x : { 0.0, 0.3, 0.7, 1.0, 1.3, 1.5, 2.0 })
  {
    auto matrix = RelevoMakeMotion({ x, 0.1, 0.2 }, 20.0, { 1, 2, 3 });
    auto moved = RelevoMove(small, matrix);
    filter->SetMatrix(1, matrix);
    filter->Update();
    vtkPolyData* meshes[2] = { large, moved };
    for (int side = 0; side < 2; ++side)
    {
      vtkPolyData* output = filter->GetOutput(2 + side);
      CHECK_EQUAL(output->GetNumberOfCells(), meshes[side]->GetNumberOfCells());
      for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
      {
        double distance = std::numeric_limits<double>::infinity();
        for (vtkIdType j = 0; j < meshes[1 - side]->GetNumberOfCells(); ++j)
        {
          distance = std::min(distance, GetDistance(meshes[side], i, meshes[1 - side], j));
        }
        const double contact = Get(output, "Contact", i);
        seen.insert(contact);
        if (contact == vtkSurfaceIntersectionFilter::CUT)
        {
          CHECK_EQUAL(Get(output, "Distance", i), 0.0);
          continue;
        }
        // VTK treats nearly parallel edges as parallel.
        CHECK_NEAR(Get(output, "Distance", i), distance, 1e-6);
        CHECK_LESS_EQUAL(Get(output, "Distance", i), distance + 1e-12);
        // Between the corners and the faces of the other sphere, either result is allowed.
        const double center[3] = { side == 0 ? x : 0.0, side == 0 ? 0.1 : 0.0,
          side == 0 ? 0.2 : 0.0 };
        const double radius = (side == 0 ? 2.5 : 1.0) *
          std::sqrt(vtkMath::Distance2BetweenPoints(center, GetCorners(meshes[side], i)[0].data()));
        const int outside = distance < 0.3 ? vtkSurfaceIntersectionFilter::NEAR_BY
                                           : vtkSurfaceIntersectionFilter::FREE;
        CHECK(contact == vtkSurfaceIntersectionFilter::INSIDE ? radius < 1.0
                                                              : radius > 0.9 && contact == outside);
      }
    }
  }
  CHECK(errors.None());
  CHECK_EQUAL(seen, (std::set<double>{ 0, 1, 2, 3 }));
}

// Nested boxes with whole coordinates, so that rays hit corners and edges.
void TestNested(RelevoCheck& check)
{
  vtkNew<vtkAppendPolyData> shells;
  for (double size : { 4.0, 3.0 }) // hollow
  {
    shells->AddInputData(RelevoMakeBox(-size, size));
  }
  vtkNew<vtkAppendPolyData> boxes;
  const double places[3][2] = { { -1, 1 }, { 3.25, 3.75 }, { 5, 6 } };
  for (const auto& place : places)
  {
    boxes->AddInputData(RelevoMakeBox(place[0], place[1]));
  }
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputConnection(0, boxes->GetOutputPort());
  filter->SetInputConnection(1, shells->GetOutputPort());
  filter->ClassifyOn();
  filter->Update();
  for (vtkIdType i = 0; i < 18; ++i)
  {
    CHECK_EQUAL(Get(filter->GetOutput(2), "Contact", i), (i >= 6 && i < 12 ? 3 : 0));
  }
  CHECK_EQUAL(Get(filter->GetOutput(2), "Distance", 0), 2.0);
  CHECK_EQUAL(Get(filter->GetOutput(2), "Distance", 6), 0.25);
  // The matrices bring coordinates close to the largest double.
  filter->SetMatrix(0, RelevoMakeMotion({ 0, 0, 0 }, 0.0, { 0, 0, 1 }, 1e299));
  filter->SetMatrix(1, RelevoMakeMotion({ 0, 0, 0 }, 0.0, { 0, 0, 1 }, 1e299));
  filter->Update();
  for (vtkIdType i = 0; i < 18; ++i)
  {
    CHECK_EQUAL(Get(filter->GetOutput(2), "Contact", i), (i >= 6 && i < 12 ? 3 : 0));
  }
  CHECK_NEAR(Get(filter->GetOutput(2), "Distance", 0) / 2e299, 1.0, 1e-14);
}

// Cells that are not classified, and surfaces that cannot be.
void TestWithout(RelevoCheck& check)
{
  auto sphere = RelevoMakeSphere(6, { 0, 0, 0 }, 0.5);
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  filter->SetInputData(0, sphere);
  filter->SetInputData(1, RelevoMakeBox(-1, 1));
  filter->Update();
  CHECK(!filter->GetOutput(2)->GetCellData()->HasArray("Distance"));
  CHECK_EQUAL(Get(filter->GetOutput(2), "Contact", 0), 0);
  CHECK(!sphere->GetCellData()->HasArray("Contact"));
  filter->ClassifyOn();
  filter->Update();
  CHECK_EQUAL(Get(filter->GetOutput(2), "Contact", 0), 3);
  CHECK_EQUAL(Get(filter->GetOutput(3), "Contact", 0), 0);

  // The mesh has five sides of a box, and a duplicate face.
  auto open = RelevoMakeBox(-1, 1);
  open->BuildCells();
  open->DeleteCell(5);
  open->RemoveDeletedCells();
  auto twice = RelevoMakeBox(-1, 1);
  const vtkIdType again[4] = { 0, 2, 3, 1 };
  twice->GetPolys()->InsertNextCell(4, again);
  for (vtkPolyData* box : { open.Get(), twice.Get() })
  {
    filter->SetInputData(1, box);
    RelevoErrors errors(filter);
    filter->Update();
    CHECK(errors.Warned("No cell is classified as inside a surface that is not closed: input 1."));
    CHECK_EQUAL(Get(filter->GetOutput(2), "Contact", 0), 0);
    CHECK_GREATER(Get(filter->GetOutput(2), "Distance", 0), 0.4);
  }
}
}

int TestSurfaceIntersectionContacts(int, char*[])
{
  RelevoCheck check;
  TestSpheres(check);
  TestNested(check);
  TestWithout(check);
  return check.GetResult();
}
