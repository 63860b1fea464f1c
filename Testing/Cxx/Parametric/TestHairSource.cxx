// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHairSource promises the number, positions and directions of hairs, the same for any number of
// threads, and errors.
#include "RelevoCheck.h"
#include "RelevoCurves.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkHairSource.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace
{
// Two triangles of areas 6 and 2 in the plane z = 0, and a strip of area 4 in the plane x = 9.
vtkSmartPointer<vtkPolyData> MakeSurface()
{
  vtkNew<vtkPoints> points;
  for (const RelevoPosition& place :
    std::initializer_list<RelevoPosition>{ { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 3, 0 } },
      { { 4, 1, 0 } }, { { 9, 0, 0 } }, { { 9, 2, 0 } }, { { 9, 0, 2 } }, { { 9, 2, 2 } } })
  {
    points->InsertNextPoint(place.data());
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 3, 1 }); // faces down
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 4, 5, 6, 7 });
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polys);
  surface->SetStrips(strips);
  return surface;
}

vtkSmartPointer<vtkHairSource> NewSource(vtkPolyData* surface, double density, double curl)
{
  auto source = vtkSmartPointer<vtkHairSource>::New();
  source->SetInputData(surface);
  source->SetDensity(density);
  source->SetCurl(curl);
  source->SetLength(0.5);
  return source;
}

std::array<RelevoPosition, 4> GetCurve(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  std::array<RelevoPosition, 4> places;
  for (int i = 0; i < 4; ++i)
  {
    grid->GetPoint(ids->GetId(i), places[i].data());
  }
  return { places[0], places[2], places[3], places[1] };
}

// Whether a point is in the given cell of MakeSurface() or on its border.
bool IsOnSurface(const RelevoPosition& place, vtkIdType cell)
{
  const double e = 1e-12;
  const double x = place[0];
  const double y = place[1];
  switch (cell)
  {
    case 0:
      return place[2] == 0.0 && x >= -e && y >= -e && x / 4.0 + y / 3.0 <= 1.0 + e;
    case 1:
      return place[2] == 0.0 && x <= 4.0 + e && y >= -e && y <= x / 4.0 + e;
    default:
      return std::abs(x - 9.0) < e && y >= -e && y <= 2.0 + e && place[2] >= -e &&
        place[2] <= 2.0 + e;
  }
}

void TestRoots(RelevoCheck& check)
{
  auto source = NewSource(MakeSurface(), 50.3, 0.0);
  RelevoErrors errors(source);
  source->Update();
  CHECK(errors.None());
  vtkUnstructuredGrid* hair = source->GetOutput();
  CHECK_EQUAL(hair->GetNumberOfCells(), 604); // 50.3 x 12, rounded
  CHECK_EQUAL(hair->GetNumberOfPoints(), 4 * 604);
  vtkDataArray* cells = hair->GetCellData()->GetArray("vtkOriginalCellIds");
  std::array<int, 3> numbers{};
  std::set<RelevoPosition> roots;
  for (vtkIdType i = 0; i < hair->GetNumberOfCells(); ++i)
  {
    CHECK_EQUAL(hair->GetCellType(i), VTK_BEZIER_CURVE);
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(i, 0));
    const std::array<RelevoPosition, 4> curve = GetCurve(hair, i);
    ++numbers[cell];
    roots.insert(curve[0]);
    CHECK(IsOnSurface(curve[0], cell));
    // Hairs follow the normal, have lengths from 0.4 to 0.5 and sink by a quarter of their length.
    const int axis = cell == 2 ? 0 : 2;
    const double sign = cell == 1 ? -1.0 : 1.0;
    const double size = 3.0 * sign * (curve[1][axis] - curve[0][axis]);
    CHECK_GREATER_EQUAL(size, 0.4 - 1e-9);
    CHECK_LESS_EQUAL(size, 0.5 + 1e-9);
    RelevoPosition tip = curve[0];
    tip[axis] += sign * size;
    tip[2] -= 0.25 * size;
    CHECK_NEAR(RelevoGetDistance(tip, curve[3]), 0.0, 1e-12);
  }
  CHECK_EQUAL(roots.size(), 604);
  // Each hair has an equal share of the area. The number in each cell is exact up to one at both
  // ends.
  CHECK_NEAR(numbers[0], 6.0 * 50.3, 1.5);
  CHECK_NEAR(numbers[1], 2.0 * 50.3, 1.5);
  CHECK_NEAR(numbers[2], 4.0 * 50.3, 1.5);
  // Hairs are distributed evenly within a cell: a quarter of a triangle has a quarter of its hairs.
  int quarter = 0;
  for (const RelevoPosition& root : roots)
  {
    quarter += IsOnSurface(root, 0) && root[0] / 4.0 + root[1] / 3.0 < 0.5 ? 1 : 0;
  }
  CHECK_NEAR(quarter, 75, 4 * 8); // four standard deviations
}

// The curl determines the number of cubic curves, joined with C1 continuity. The radius decreases.
void TestCurl(RelevoCheck& check)
{
  for (double curl : { 0.25, 0.5, 0.75, 3.0 })
  {
    CHECK_CASE(curl);
    const int cubics = static_cast<int>(std::ceil(2.0 * curl));
    auto source = NewSource(MakeSurface(), 2.0, curl);
    source->Update();
    vtkUnstructuredGrid* hair = source->GetOutput();
    CHECK_EQUAL(hair->GetNumberOfCells(), 24 * cubics);
    CHECK_EQUAL(hair->GetNumberOfPoints(), 24 * (3 * cubics + 1));
    vtkDataArray* radii = hair->GetPointData()->GetArray("HairRadius");
    for (vtkIdType i = 0; i < hair->GetNumberOfCells(); ++i)
    {
      const std::array<RelevoPosition, 4> curve = GetCurve(hair, i);
      vtkNew<vtkIdList> ids;
      hair->GetCellPoints(i, ids);
      CHECK_GREATER(radii->GetComponent(ids->GetId(0), 0), radii->GetComponent(ids->GetId(1), 0));
      if (i % cubics > 0)
      {
        const std::array<RelevoPosition, 4> last = GetCurve(hair, i - 1);
        CHECK_EQUAL(last[3], curve[0]);
        for (int c = 0; c < 3; ++c)
        {
          CHECK_NEAR(last[3][c] - last[2][c], curve[1][c] - curve[0][c], 1e-13);
        }
      }
      else
      {
        CHECK_NEAR(radii->GetComponent(ids->GetId(0), 0), 0.005, 1e-9);
      }
      if (i % cubics == cubics - 1)
      {
        CHECK_NEAR(radii->GetComponent(ids->GetId(1), 0), 0.0005, 1e-9);
      }
    }
  }
}

// Smallest ratio between the distance from root to tip and the length, by 100 chords per cubic
// curve.
double GetStraightness(double curl)
{
  const int cubics = std::max(1, static_cast<int>(std::ceil(2.0 * curl)));
  auto source = NewSource(MakeSurface(), 2.0, curl);
  source->SetGravity(0.0, 0.0, 0.0);
  source->Update();
  vtkUnstructuredGrid* hair = source->GetOutput();
  double least = 2.0;
  for (vtkIdType first = 0; first < hair->GetNumberOfCells(); first += cubics)
  {
    double sum = 0.0;
    const RelevoPosition root = GetCurve(hair, first)[0];
    RelevoPosition last = root;
    for (int step = 1; step <= 100 * cubics; ++step)
    {
      const std::array<RelevoPosition, 4> curve = GetCurve(hair, first + (step - 1) / 100);
      const double t = ((step - 1) % 100 + 1) / 100.0;
      RelevoPosition place;
      for (int c = 0; c < 3; ++c)
      {
        place[c] = std::pow(1.0 - t, 3) * curve[0][c] +
          3.0 * t * std::pow(1.0 - t, 2) * curve[1][c] + 3.0 * t * t * (1.0 - t) * curve[2][c] +
          t * t * t * curve[3][c];
      }
      sum += std::sqrt(vtkMath::Distance2BetweenPoints(last.data(), place.data()));
      last = place;
    }
    least =
      std::min(least, std::sqrt(vtkMath::Distance2BetweenPoints(root.data(), last.data())) / sum);
  }
  return least;
}

// One turn of curl brings root and tip 7 percent closer.
void TestStraightness(RelevoCheck& check)
{
  CHECK_NEAR(GetStraightness(0.0), 1.0, 1e-12);
  CHECK_LESS(GetStraightness(0.5), 0.994);
  CHECK_LESS(GetStraightness(1.0), 0.94);
  CHECK_GREATER(GetStraightness(1.0), 0.85);
  CHECK_LESS(GetStraightness(2.0), 0.75);
}

bool AreSame(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  bool areSame = a->GetNumberOfPoints() == b->GetNumberOfPoints();
  for (vtkIdType i = 0; areSame && i < a->GetNumberOfPoints(); ++i)
  {
    RelevoPosition first;
    RelevoPosition second;
    a->GetPoint(i, first.data());
    b->GetPoint(i, second.data());
    areSame = first == second;
  }
  return areSame;
}

void TestRepetition(RelevoCheck& check)
{
  std::array<vtkSmartPointer<vtkUnstructuredGrid>, 3> hairs;
  for (int i = 0; i < 3; ++i)
  {
    vtkSMPTools::Initialize(i + 1);
    auto source = NewSource(MakeSurface(), 400.0, 1.0);
    source->SetSeed(i == 2 ? 2 : 1);
    source->Update();
    hairs[i] = source->GetOutput();
  }
  vtkSMPTools::Initialize();
  CHECK(AreSame(hairs[0], hairs[1]));
  CHECK(!AreSame(hairs[0], hairs[2]));
}

// Valid point normals are used. Ghost cells have no hairs.
void TestNormals(RelevoCheck& check)
{
  auto surface = MakeSurface();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    normals->InsertNextTuple3(0.0, i < 4 ? 3.0 : 0.0, 0.0);
  }
  surface->GetPointData()->SetNormals(normals);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int type : { 0, static_cast<int>(vtkDataSetAttributes::DUPLICATECELL), 0 })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(type));
  }
  surface->GetCellData()->AddArray(ghosts);
  auto source = NewSource(surface, 10.0, 0.0);
  source->SetGravity(0.0, 0.0, 0.0);
  source->Update();
  vtkUnstructuredGrid* hair = source->GetOutput();
  CHECK_EQUAL(hair->GetNumberOfCells(), 100);
  for (vtkIdType i = 0; i < hair->GetNumberOfCells(); ++i)
  {
    const std::array<RelevoPosition, 4> curve = GetCurve(hair, i);
    const bool isStrip =
      hair->GetCellData()->GetArray("vtkOriginalCellIds")->GetComponent(i, 0) == 2.0;
    const int axis = isStrip ? 0 : 1; // the strip's normals are 0, so that of its triangle is used
    CHECK_NEAR(
      RelevoGetDistance(curve[0], curve[3]), std::abs(curve[3][axis] - curve[0][axis]), 1e-12);
  }
}

// As tubes, each hair is closed.
void TestTubes(RelevoCheck& check)
{
  auto source = NewSource(MakeSurface(), 1.0, 1.0);
  source->Update();
  auto filter = RelevoNewCurveFilter(source->GetOutput(), 4);
  filter->SetRepresentationToTubes();
  filter->SetRadiusArrayName("HairRadius");
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.None());
  vtkPolyData* tubes = filter->GetOutput();
  CHECK_EQUAL(tubes->GetNumberOfPolys(), 12 * (2 * 16 * 16 + 2 * 6));
  CHECK_EQUAL(RelevoCountOpenEdges(tubes), 0);
  CHECK_GREATER(RelevoGetVolume(tubes), 0.0);
}

void ExpectError(RelevoCheck& check, vtkPolyData* surface, double density, const char* words)
{
  auto source = NewSource(surface, density, 0.0);
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  CHECK_EQUAL(source->GetExecutive()->Update(), 0);
  CHECK(errors.Said(words));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 0);
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkUnstructuredGrid>());
  auto ofBlocks = NewSource(nullptr, 1.0, 0.0);
  ofBlocks->SetInputDataObject(blocks);
  RelevoErrors errorsOfBlocks(ofBlocks);
  RelevoErrors executive(ofBlocks->GetExecutive());
  ofBlocks->Update();
  CHECK(errorsOfBlocks.Said("The input is a vtkUnstructuredGrid; a vtkPolyData is needed."));
  vtkNew<vtkPolyData> empty;
  ExpectError(check, empty, 1.0, "The input has no polygons for hair to grow on.");
  ExpectError(check, MakeSurface(), 1e9, "Not enough memory for the hairs");
  auto surface = MakeSurface();
  for (vtkIdType i = 0; i < 8; ++i)
  {
    surface->GetPoints()->SetPoint(i, i, i, i);
  }
  ExpectError(check, surface, 1.0, "The input's polygons have no area for hair to grow on.");

  surface = MakeSurface();
  surface->GetPoints()->SetPoint(2, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  auto source = NewSource(surface, 1.0, 0.0);
  RelevoErrors errors(source);
  source->Update();
  CHECK(errors.Warned("1 triangles have no hair"));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 6);
  const vtkMTimeType time = source->GetMTime();
  source->SetDensity(0.0);
  CHECK(errors.Said("Density must be in [1e-12, 1e+12], got 0."));
  source->SetLength(-1.0);
  CHECK(errors.Said("Length must be in"));
  source->SetCurl(std::numeric_limits<double>::quiet_NaN());
  CHECK(errors.Said("Curl must be in [0, 16], got nan."));
  CHECK_EQUAL(source->GetMTime(), time);
}
}

int TestHairSource(int, char*[])
{
  RelevoCheck check;
  TestRoots(check);
  TestCurl(check);
  TestStraightness(check);
  TestRepetition(check);
  TestNormals(check);
  TestTubes(check);
  TestErrors(check);
  return check.GetResult();
}
