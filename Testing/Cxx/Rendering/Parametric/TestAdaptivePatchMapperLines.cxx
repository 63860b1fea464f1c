// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptivePatchMapper promises isolines and cell edges at their exact positions and widths, and
// no other lines.
#include "RelevoMethods.h"
#include "RelevoPatchScene.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <array>
#include <cmath>
#include <vector>

namespace
{
constexpr double PixelsPerUnit = 250.0; // for a scene of size 1

// Length of the black parts in a row of pixels of a white surface, in pixels.
double GetBlack(const RelevoPicture& picture, int row, int from, int to)
{
  double black = 0.0;
  for (int x = from; x < to; ++x)
  {
    black += 1.0 - picture.Colors[3 * (static_cast<size_t>(row) * picture.Size[0] + x)] / 255.0;
  }
  return black;
}

// Whether the pixel at x is black.
bool IsBlackAt(const RelevoPicture& picture, int row, double x)
{
  const int pixel = static_cast<int>((x + 0.1) * PixelsPerUnit);
  return GetBlack(picture, row, pixel - 1, pixel + 2) > 0.9;
}

void SetWhite(RelevoPatchScene& scene)
{
  vtkNew<vtkLookupTable> white;
  white->SetSaturationRange(0.0, 0.0);
  white->SetValueRange(1.0, 1.0);
  scene.Mapper->SetLookupTable(white);
}

// Field = r^2 on the unit square gives vertical lines at square roots.
void TestIsolines(RelevoCheck& check, double offset, double width)
{
  auto grid = RelevoNewFlatCell(VTK_BIQUADRATIC_QUAD, { { 2, 2, 0 } }, 0.0);
  vtkDataArray* field = grid->GetPointData()->GetArray("Field");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double x = grid->GetPoint(i)[0];
    field->SetComponent(i, 0, offset + x * x);
  }
  RelevoPatchScene scene(grid);
  SetWhite(scene);
  scene.Mapper->SetScalarRange(offset + 0.3, offset + 1.0);
  CHECK_EQUAL(GetBlack(scene.Draw(), 150, 30, 270), 0.0);
  scene.Mapper->SetIsolineSpacing(0.25);
  scene.Mapper->SetIsolineWidth(width);
  const RelevoPicture picture = scene.Draw();
  for (int row : { 40, 150, 260 })
  {
    CHECK_CASE(row);
    CHECK(IsBlackAt(picture, row, 0.5));
    CHECK(IsBlackAt(picture, row, std::sqrt(0.5)));
    CHECK(IsBlackAt(picture, row, std::sqrt(0.75)));
    CHECK_NEAR(GetBlack(picture, row, 40, 265), 3.0 * width, 0.15 * width);
  }
  scene.Mapper->SetIsolineColor(0.0, 1.0, 1.0);
  CHECK_NEAR(GetBlack(scene.Draw(), 150, 40, 265), 3.0 * width, 0.15 * width); // red lines
  for (int method : RelevoMethods::GetMethods())
  {
    scene.Mapper->SetMethod(method);
    CHECK_NEAR(GetBlack(scene.Draw(), 150, 40, 265), 3.0 * width, 0.15 * width);
  }
  scene.Mapper->ExactScalarsOff();
  CHECK_EQUAL(GetBlack(scene.Draw(), 150, 40, 265), 0.0);
}

// Cell values have no isolines, which is reported once.
void TestIsolinesOfCells(RelevoCheck& check)
{
  auto grid = RelevoNewFlatGrid(2, 2);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Numbers");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  grid->GetCellData()->AddArray(numbers);
  RelevoPatchScene scene(grid);
  SetWhite(scene);
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectColorArray("Numbers");
  RelevoErrors errors(scene.Mapper);
  scene.Draw();
  CHECK(errors.None());
  scene.Mapper->SetIsolineSpacing(0.5);
  scene.Draw();
  CHECK(errors.Warned("There are no isolines of \"Numbers\": a cell array is constant"));
  scene.Draw();
  CHECK(errors.None());
}

// No value lies on these isolines. Lines at the ends of the range are drawn.
void TestIsolinesOutOfRange(RelevoCheck& check)
{
  auto grid = RelevoNewFlatGrid(1, 1);
  vtkDataArray* field = grid->GetPointData()->GetArray("Field");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    field->SetComponent(i, 0, field->GetComponent(i, 0) + 0.5);
  }
  RelevoPatchScene scene(grid);
  SetWhite(scene);
  scene.Mapper->SetIsolineWidth(8.0);
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetIsolineSpacing(2.0);
  CHECK_EQUAL(GetBlack(scene.Draw(), 150, 26, 274), 0.0);
  CHECK(
    errors.Warned("There are no isolines of \"Field\": no multiple of IsolineSpacing, which is 2, "
                  "is in the range of its values, 0.5 to 1.5."));
  scene.Draw();
  CHECK(errors.None());
  for (const double spacing : { 0.5, 1.5 })
  {
    CHECK_CASE(spacing);
    scene.Mapper->SetIsolineSpacing(spacing);
    CHECK_GREATER(GetBlack(scene.Draw(), 150, 26, 274), 1.0);
    CHECK(errors.None());
  }
}

// Field = x on a rotated square: the width across the line does not depend on its direction.
void TestSlantedIsolines(RelevoCheck& check)
{
  auto grid = RelevoNewFlatGrid(1, 1);
  RelevoPatchScene scene(grid);
  SetWhite(scene);
  scene.Mapper->SetIsolineSpacing(0.5);
  scene.Mapper->SetIsolineWidth(4.0);
  scene.Actor->SetOrigin(0.5, 0.5, 0.0);
  scene.Actor->RotateZ(30.0);
  const RelevoPicture picture = scene.Draw();
  CHECK_NEAR(GetBlack(picture, 150, 60, 240), 4.0 / std::cos(30.0 / 180.0 * 3.14159265), 0.2);
}

void TestEdges(RelevoCheck& check, int level)
{
  auto grid = RelevoNewFlatGrid(2, 2);
  RelevoPatchScene scene(grid, 2.0);
  SetWhite(scene);
  scene.Mapper->GetRefinement()->SetMaximumLevel(level);
  scene.Mapper->ScalarVisibilityOff();
  CHECK_EQUAL(GetBlack(scene.Draw(), 100, 25, 275), 0.0);
  scene.Mapper->PatchEdgesOn();
  scene.Actor->GetProperty()->SetLineWidth(4.0f);
  const RelevoPicture picture = scene.Draw();
  // An outer edge shows its inner half, the edge between the cells both halves. Diagonals are not
  // drawn.
  CHECK_NEAR(GetBlack(picture, 60, 25, 275), 8.0, 0.2);
  CHECK_NEAR(GetBlack(picture, 60, 140, 160), 4.0, 0.1);
  CHECK_EQUAL(GetBlack(picture, 60, 30, 140), 0.0);
  CHECK_EQUAL(GetBlack(picture, 60, 160, 270), 0.0);
  CHECK_GREATER(GetBlack(picture, 150, 25, 275), 249.0);
  scene.Actor->GetProperty()->SetEdgeColor(1.0, 1.0, 1.0);
  CHECK_EQUAL(GetBlack(scene.Draw(), 60, 25, 275), 0.0);
  scene.Actor->GetProperty()->SetEdgeColor(0.0, 0.0, 0.0);
  scene.Actor->GetProperty()->SetRepresentationToWireframe();
  scene.Mapper->PatchEdgesOff();
  const RelevoPicture wires = scene.Draw();
  scene.Mapper->PatchEdgesOn();
  CHECK_EQUAL(scene.Draw().Colors, wires.Colors);
}

// All edges of a triangle, except those that collapse to a point.
void TestTriangle(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_QUADRATIC_TRIANGLE, { { 2, 2, 0 } }, 0.0);
  RelevoPatchScene scene(grid);
  scene.Mapper->ScalarVisibilityOff();
  scene.Mapper->PatchEdgesOn();
  scene.Actor->GetProperty()->SetLineWidth(4.0f);
  CHECK_NEAR(GetBlack(scene.Draw(), 100, 25, 275), 2.0 + 2.0 * std::sqrt(2.0),
    0.55); // centers of pixels lie on the slanted edge

  auto pole = RelevoNewFlatGrid(1, 1);
  pole->GetPoints()->SetPoint(2, 1.0, 1.0, 0.0); // the upper edge is the point (1, 1)
  RelevoPatchScene poleScene(pole);
  poleScene.Mapper->ScalarVisibilityOff();
  poleScene.Mapper->PatchEdgesOn();
  poleScene.Actor->GetProperty()->SetLineWidth(4.0f);
  // A row of the triangle (0, 0), (1, 0), (1, 1) beside the pole has only its two edges.
  CHECK_NEAR(GetBlack(poleScene.Draw(), 225, 25, 275), 2.0 + 2.0 * std::sqrt(2.0), 0.55);
}

// Only the outer edges of polygons are drawn, not those of their triangles.
void TestPolygons(RelevoCheck& check)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (const std::array<double, 2>& x : std::vector<std::array<double, 2>>{
         { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.3 }, { 1.0, 1.0 }, { 0.4, 1.0 }, { 0.0, 1.0 } })
  {
    points->InsertNextPoint(x[0], x[1], 0.0);
  }
  grid->SetPoints(points);
  const std::array<vtkIdType, 6> corners{ 0, 1, 2, 3, 4, 5 };
  grid->InsertNextCell(VTK_POLYGON, 6, corners.data());
  RelevoPatchScene scene(grid);
  scene.Mapper->ScalarVisibilityOff();
  scene.Mapper->PatchEdgesOn();
  scene.Actor->GetProperty()->SetLineWidth(4.0f);
  const RelevoPicture picture = scene.Draw();
  for (int row : { 60, 100, 150, 200, 240 })
  {
    CHECK_CASE(row);
    CHECK_NEAR(GetBlack(picture, row, 25, 275), 4.0, 0.1);
  }
}
}

int TestAdaptivePatchMapperLines(int, char*[])
{
  RelevoCheck check;
  for (double width : { 1.0, 3.0 })
  {
    TestIsolines(check, 0.0, width);
    TestIsolines(check, 1000.0, width); // far from zero
  }
  TestIsolinesOfCells(check);
  TestIsolinesOutOfRange(check);
  TestSlantedIsolines(check);
  for (int level : { 0, 2, 5 })
  {
    CHECK_CASE(level);
    TestEdges(check, level);
  }
  TestTriangle(check);
  TestPolygons(check);
  return check.GetResult();
}
