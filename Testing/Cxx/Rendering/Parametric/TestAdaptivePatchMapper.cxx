// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptivePatchMapper promises at each pixel the colour of the value that VTK's cell
// interpolates there, for all kinds of cells, methods and colour mappings.
#include "RelevoMethods.h"
#include "RelevoPatchScene.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellType.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr double MaximumOthers = 1e-3;

double GetFirst(const RelevoPatchScene::Tuple& tuple)
{
  return tuple[0];
}

double GetLength(const RelevoPatchScene::Tuple& tuple)
{
  double sum = 0.0;
  for (double component : tuple)
  {
    sum += component * component;
  }
  return std::sqrt(sum);
}

// Many similar colours.
void SetSmoothTable(RelevoPatchScene& scene, double low, double high)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(1024);
  table->SetHueRange(0.0, 0.8);
  table->SetTableRange(low, high);
  table->Build();
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->UseLookupTableScalarRangeOn();
}

void TestKinds(RelevoCheck& check)
{
  const struct
  {
    int Type;
    std::array<int, 3> Degrees;
    bool IsRational;
  } kinds[] = { { VTK_LAGRANGE_QUADRILATERAL, { { 4, 4, 0 } }, false },
    { VTK_LAGRANGE_QUADRILATERAL, { { 8, 3, 0 } }, false },
    { VTK_BEZIER_QUADRILATERAL, { { 3, 2, 0 } }, true },
    { VTK_LAGRANGE_TRIANGLE, { { 5, 5, 0 } }, false },
    { VTK_BEZIER_TRIANGLE, { { 4, 4, 0 } }, true },
    { VTK_QUADRATIC_TRIANGLE, { { 2, 2, 0 } }, false },
    { VTK_QUADRATIC_QUAD, { { 2, 2, 0 } }, false },
    { VTK_BIQUADRATIC_QUAD, { { 2, 2, 0 } }, false }, { VTK_QUAD, { { 1, 1, 0 } }, false } };
  for (const auto& kind : kinds)
  {
    auto grid = RelevoNewFlatCell(kind.Type, kind.Degrees, 0.005, kind.IsRational);
    RelevoPatchScene scene(grid);
    SetSmoothTable(scene, -1.0, 1.0);
    const double others = scene.GetShareOfOthers(grid, "Field", scene.ByTable(GetFirst));
    if (others > MaximumOthers)
    {
      std::cerr << "type " << kind.Type << ": " << others << "\n";
    }
    CHECK_LESS_EQUAL(others, MaximumOthers);
  }
}

void TestMethods(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_LAGRANGE_QUADRILATERAL, { { 4, 3, 0 } }, 0.02);
  std::vector<int> methods = RelevoMethods::GetMethods();
  if (RelevoMethods::HasTessellation())
  {
    methods.push_back(vtkAdaptiveRefinementMapper::METHOD_HARDWARE_TESSELLATION);
  }
  for (int method : methods)
  {
    for (bool byTexture : { false, true })
    {
      RelevoPatchScene scene(grid);
      scene.Mapper->SetMethod(method);
      scene.Mapper->SetInterpolateScalarsBeforeMapping(byTexture);
      SetSmoothTable(scene, -1.0, 1.0);
      const double others = scene.GetShareOfOthers(grid, "Field", scene.ByTable(GetFirst));
      if (others > MaximumOthers)
      {
        std::cerr << RelevoMethods::GetName(method) << ": " << others << "\n";
      }
      CHECK_LESS_EQUAL(others, MaximumOthers);
      CHECK_EQUAL(scene.Mapper->GetMethodInUse(), method);
      // Negative control: the interpolated picture differs.
      scene.Mapper->ExactScalarsOff();
      CHECK_GREATER(scene.GetShareOfOthers(grid, "Field", scene.ByTable(GetFirst)), 0.5);
      scene.Mapper->ExactScalarsOn();
      CHECK_LESS_EQUAL(
        scene.GetShareOfOthers(grid, "Field", scene.ByTable(GetFirst)), MaximumOthers);
    }
  }
}

void TestVectors(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_BEZIER_QUADRILATERAL, { { 3, 3, 0 } }, 0.005, true);
  for (const char* name : { "Vector", "Long" })
  {
    CHECK_CASE(name);
    RelevoPatchScene scene(grid);
    SetSmoothTable(scene, -1.0, 3.0);
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectColorArray(name);
    scene.Mapper->GetLookupTable()->SetVectorModeToMagnitude();
    const double others = scene.GetShareOfOthers(grid, name, scene.ByTable(GetLength));
    if (others > MaximumOthers)
    {
      std::cerr << name << ": " << others << "\n";
    }
    CHECK_LESS_EQUAL(others, MaximumOthers);
    scene.Mapper->GetLookupTable()->SetVectorModeToComponent();
    scene.Mapper->GetLookupTable()->SetVectorComponent(2);
    const auto second = [](const RelevoPatchScene::Tuple& tuple) { return tuple[2]; };
    CHECK_LESS_EQUAL(scene.GetShareOfOthers(grid, name, scene.ByTable(second)), MaximumOthers);
  }
}

void TestColors(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_LAGRANGE_TRIANGLE, { { 4, 4, 0 } }, 0.02);
  RelevoPatchScene scene(grid);
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectColorArray("Color");
  const auto asTheyAre = [](const RelevoPatchScene::Tuple& tuple) -> RelevoPatchScene::Color
  {
    const auto limit = [](double value) { return std::min(std::max(value, 0.0), 255.0); };
    return { { limit(tuple[0]), limit(tuple[1]), limit(tuple[2]) } };
  };
  CHECK_LESS_EQUAL(scene.GetShareOfOthers(grid, "Color", asTheyAre), MaximumOthers);
  // Colours of blocks, levels and actors are not replaced.
  scene.Mapper->ScalarVisibilityOff();
  scene.Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
  const auto green = [](const RelevoPatchScene::Tuple&) -> RelevoPatchScene::Color {
    return { { 0.0, 255.0, 0.0 } };
  };
  CHECK_EQUAL(scene.GetShareOfOthers(grid, "Color", green), 0.0);
  scene.Mapper->ScalarVisibilityOn();
  scene.Mapper->SetBlockColor(0, 0.0, 1.0, 0.0);
  CHECK_EQUAL(scene.GetShareOfOthers(grid, "Color", green), 0.0);
}

void TestTables(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_LAGRANGE_QUADRILATERAL, { { 4, 4, 0 } }, 0.02);
  RelevoPatchScene scene(grid);
  SetSmoothTable(scene, 0.5, 20.0);
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectColorArray("Vector");
  vtkLookupTable::SafeDownCast(scene.Mapper->GetLookupTable())->SetScaleToLog10();
  scene.Mapper->GetLookupTable()->SetVectorModeToMagnitude();
  CHECK_LESS_EQUAL(scene.GetShareOfOthers(grid, "Vector", scene.ByTable(GetLength)), MaximumOthers);
  // Integers are rounded.
  SetSmoothTable(scene, 0.0, 20.0);
  scene.Mapper->SelectColorArray("Whole");
  const auto round = [](const RelevoPatchScene::Tuple& tuple) { return std::round(tuple[0]); };
  CHECK_LESS_EQUAL(scene.GetShareOfOthers(grid, "Whole", scene.ByTable(round)), MaximumOthers);
  // A patch with a missing node value has no values.
  grid->GetPointData()->GetArray("Field")->SetComponent(7, 0, std::nan(""));
  grid->GetPointData()->GetArray("Field")->Modified();
  scene.Mapper->SelectColorArray("Field");
  vtkLookupTable::SafeDownCast(scene.Mapper->GetLookupTable())->SetNanColor(0.0, 0.0, 1.0, 1.0);
  const auto blue = [](const RelevoPatchScene::Tuple&) -> RelevoPatchScene::Color {
    return { { 0.0, 0.0, 255.0 } };
  };
  CHECK_EQUAL(scene.GetShareOfOthers(grid, "Field", blue), 0.0);
}

// Blocks of grids are drawn, too. Input of another type gives one error.
void TestTypes(RelevoCheck& check)
{
  auto grid = RelevoNewFlatCell(VTK_LAGRANGE_QUADRILATERAL, { { 4, 3, 0 } }, 0.02);
  RelevoPatchScene scene(grid);
  const RelevoPicture expected = scene.Draw();
  RelevoErrors errors(scene.Mapper);
  vtkNew<vtkTable> table;
  scene.Mapper->SetInputDataObject(table);
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  CHECK(errors.Said("The input is a vtkTable; a vtkPolyData or a vtkCompositeDataSet or a "
                    "vtkUnstructuredGrid is needed."));
  scene.Draw();
  CHECK(errors.None());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  blocks->SetBlock(1, table);
  scene.Mapper->SetInputDataObject(blocks);
  CHECK_EQUAL(scene.Draw().Colors, expected.Colors);
  CHECK(errors.Said("Block 2 is a vtkTable; a vtkPolyData or a vtkUnstructuredGrid is needed; it "
                    "is left out."));
  CHECK_EQUAL(scene.Draw().Colors, expected.Colors);
  CHECK(errors.None());
}
}

int TestAdaptivePatchMapper(int, char*[])
{
  RelevoCheck check;
  TestKinds(check);
  TestMethods(check);
  TestVectors(check);
  TestColors(check);
  TestTables(check);
  TestTypes(check);
  return check.GetResult();
}
