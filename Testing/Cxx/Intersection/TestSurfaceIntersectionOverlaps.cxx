// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceIntersectionFilter promises correct results for surfaces that only touch or overlap.
#include "RelevoCheck.h"
#include "RelevoIntersections.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSurfaceIntersectionFilter.h"

namespace
{
struct Result
{
  Result(vtkPolyData* first, vtkPolyData* second)
  {
    this->Filter->SetInputData(0, first);
    if (second)
    {
      this->Filter->SetInputData(1, second);
    }
    this->Filter->Update();
  }
  vtkPolyData* GetCurves() { return this->Filter->GetOutput(0); }
  vtkPolyData* GetOverlaps() { return this->Filter->GetOutput(1); }
  bool Has(vtkIdType vertices, vtkIdType lines, vtkIdType polygons)
  {
    return this->GetCurves()->GetNumberOfVerts() == vertices &&
      this->GetCurves()->GetNumberOfLines() == lines &&
      this->GetOverlaps()->GetNumberOfPolys() == polygons;
  }

  vtkNew<vtkSurfaceIntersectionFilter> Filter;
};

vtkSmartPointer<vtkPolyData> MakePlate(double low, double high, double z)
{
  return RelevoMakePolygons(
    { { low, low, z }, { high, low, z }, { high, high, z }, { low, high, z } }, { { 0, 1, 2, 3 } });
}

void TestTouching(RelevoCheck& check)
{
  auto plate = MakePlate(-4, 4, 0);
  // Three faces around a corner that touches the plate, on its diagonal and beside it.
  for (double x : { 1.0, 2.0 })
  {
    CHECK_CASE(x);
    auto corner = RelevoMakePolygons({ { x, 1, 0 }, { 2, 2, 1 }, { 0, 2, 2 }, { 1, 0, 1 } },
      { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 } });
    Result result(plate, corner);
    CHECK(result.Has(1, 0, 0));
    double at[3];
    result.GetCurves()->GetPoint(0, at);
    CHECK(at[0] == x && at[1] == 1.0 && at[2] == 0.0);
  }
  // A roof that touches with its ridge gives one segment of two faces.
  auto roof = RelevoMakePolygons(
    { { 1, 2, 0 }, { 3, 2, 0 }, { 2, 3, 1 }, { 2, 1, 1 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  Result ridge(plate, roof);
  CHECK(ridge.Has(0, 2, 0)); // on both sides of the plate's diagonal
  CHECK_EQUAL(ridge.GetCurves()->GetNumberOfPoints(), 3);
  CHECK_NEAR(RelevoMeasureLength(ridge.GetCurves()), 2.0, 1e-15);
  // These ridges cross.
  auto across = RelevoMakePolygons(
    { { 2, 1, 0 }, { 2, 3, 0 }, { 3, 2, -1 }, { 1, 2, -1 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  Result ridges(roof, across);
  CHECK(ridges.Has(1, 0, 0));
  // These boxes share a corner or an edge.
  auto low = RelevoMakeBox(0, 1);
  auto high = RelevoMakeBox(1, 2);
  CHECK(Result(low, high).Has(1, 0, 0));
}

void TestOverlaps(RelevoCheck& check)
{
  // This box stands on a plate.
  auto plate = MakePlate(-3, 3, 0);
  auto box = RelevoMakeBox(0, 2);
  Result result(plate, box);
  CHECK_NEAR(RelevoMeasureArea(result.GetOverlaps()), 4.0, 1e-14);
  CHECK_NEAR(RelevoMeasureLength(result.GetCurves()), 8.0, 1e-14);
  CHECK_EQUAL(result.GetCurves()->GetNumberOfVerts(), 0);
  for (const auto& ids : RelevoGetCellPairs(result.GetOverlaps()))
  {
    CHECK_EQUAL(ids.first, 0);
    CHECK_EQUAL(ids.second, 0);
  }
  CHECK_EQUAL(
    result.Filter->GetOutput(2)->GetCellData()->GetArray("Contact")->GetComponent(0, 0), 2);
  // Only the box's top cell is free.
  vtkDataArray* contacts = result.Filter->GetOutput(3)->GetCellData()->GetArray("Contact");
  for (vtkIdType i = 0; i < 6; ++i)
  {
    CHECK_EQUAL(contacts->GetComponent(i, 0), (i == 1 ? 0 : 2));
  }

  // Two equal boxes, and a smaller one inside a box.
  Result same(box, RelevoMakeBox(0, 2));
  CHECK_EQUAL(same.GetCurves()->GetNumberOfCells(), 0);
  CHECK_NEAR(RelevoMeasureArea(same.GetOverlaps()), 24.0, 1e-13);
  Result within(plate, MakePlate(-1, 1, 0));
  CHECK_NEAR(RelevoMeasureArea(within.GetOverlaps()), 4.0, 1e-14);
  CHECK(Result(plate, MakePlate(-1, 1, 1e-300)).Has(0, 0, 0));
  // These plates share an edge, or a part of one.
  auto beside = RelevoMakePolygons(
    { { 3, -3, 0 }, { 5, -3, 0 }, { 5, 0, 0 }, { 3, 0, 0 } }, { { 0, 1, 2, 3 } });
  Result edge(plate, beside);
  CHECK(edge.Has(0, 1, 0));
  CHECK_NEAR(RelevoMeasureLength(edge.GetCurves()), 3.0, 1e-15);

  auto sphere = RelevoMakeSphere(30, { 0.1, 0.2, 0.3 }, 1.0);
  Result spheres(sphere, sphere);
  CHECK(spheres.Has(0, 0, sphere->GetNumberOfPolys()));
  CHECK_NEAR(RelevoMeasureArea(spheres.GetOverlaps()), RelevoMeasureArea(sphere), 1e-12);
}

// Duplicate triangles give the same segments.
void TestTwice(RelevoCheck& check)
{
  auto box = RelevoMakeBox(-0.71, 0.73);
  auto once = RelevoMakeSphere(9, { 0, 0, 0 }, 1.0);
  auto twice = vtkSmartPointer<vtkPolyData>::New();
  twice->DeepCopy(once);
  twice->GetPolys()->Append(once->GetPolys());
  Result expected(once, box);
  Result found(twice, box);
  CHECK_GREATER(expected.GetCurves()->GetNumberOfLines(), 50);
  CHECK(RelevoIsSameMesh(expected.GetCurves(), found.GetCurves()));
}

void TestItself(RelevoCheck& check)
{
  // Two triangles on opposite sides of an edge, and on the same side. A box has no
  // self-intersection.
  auto flat = RelevoMakePolygons(
    { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, -1, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  CHECK(Result(flat, nullptr).Has(0, 0, 0));
  auto folded = RelevoMakePolygons(
    { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 0, 1, 3 } });
  Result twice(folded, nullptr);
  CHECK_EQUAL(twice.GetOverlaps()->GetNumberOfPolys(), 1);
  CHECK_NEAR(RelevoMeasureArea(twice.GetOverlaps()), 2.0, 1e-15);
  CHECK(Result(RelevoMakeBox(0, 1), nullptr).Has(0, 0, 0));
  // Coincident points are merged, so a seam is not a contact.
  auto seam = RelevoMakePolygons(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 1 } },
    { { 0, 1, 2 }, { 3, 5, 4 } });
  CHECK(Result(seam, nullptr).Has(0, 0, 0));
}
}

int TestSurfaceIntersectionOverlaps(int, char*[])
{
  RelevoCheck check;
  TestTouching(check);
  TestOverlaps(check);
  TestTwice(check);
  TestItself(check);
  return check.GetResult();
}
