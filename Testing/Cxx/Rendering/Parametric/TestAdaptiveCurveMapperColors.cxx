// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveMapper promises the colours that vtkPolyDataMapper gives the filter's output, for
// point and cell scalars.
#include "RelevoCurveScene.h"

#include "vtkCellData.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <array>
#include <set>

namespace
{
using Mapper = vtkAdaptiveCurveMapper;

void Compare(RelevoComparison& comparison, RelevoCurveScene& scene, const std::string& name,
  const RelevoTolerance& tolerance = { 3, 1e-6, 10 })
{
  const RelevoPicture actual = scene.Draw();
  comparison.Compare(name, tolerance, actual, scene.DrawTwin());
}

// Number of different colours.
size_t CountColors(const RelevoPicture& picture)
{
  std::set<std::array<unsigned char, 3>> colors;
  for (size_t i = 0; i < picture.Colors.size(); i += 3)
  {
    colors.insert({ { picture.Colors[i], picture.Colors[i + 1], picture.Colors[i + 2] } });
  }
  return colors.size();
}

void ColorBy(Mapper* mapper, const char* name, bool isOfCells = false)
{
  mapper->ScalarVisibilityOn();
  if (isOfCells)
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  else
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  mapper->SelectColorArray(name);
}

void TestValues(RelevoCheck& check, RelevoComparison& comparison)
{
  for (bool isLagrange : { false, true })
  {
    CHECK_CASE(isLagrange);
    RelevoCurveScene scene(RelevoMakeCurves(3, isLagrange, !isLagrange));
    scene.Actor->GetProperty()->LightingOff();
    scene.Mapper->SetRadius(0.06);
    scene.Mapper->SetRadiusArrayName("Radii");
    for (int representation : { Mapper::LINES, Mapper::RIBBONS, Mapper::TUBES })
    {
      CHECK_CASE(representation);
      scene.Mapper->SetRepresentation(representation);
      const std::string name =
        (isLagrange ? "Lagrange " : "rational ") + std::to_string(representation) + " ";
      for (bool ofFragments : { false, true })
      {
        CHECK_CASE(ofFragments);
        scene.Mapper->SetInterpolateScalarsBeforeMapping(ofFragments);
        ColorBy(scene.Mapper, "Values");
        Compare(comparison, scene, name + (ofFragments ? "fragments" : "values"), { 3, 1e-6, 40 });
        CHECK_GREATER(CountColors(scene.Draw()), 100);
        ColorBy(scene.Mapper, "Vectors");
        Compare(comparison, scene, name + "lengths", { 3, 1e-6, 40 });
      }
      scene.Mapper->InterpolateScalarsBeforeMappingOff();
      ColorBy(scene.Mapper, "Numbers", true);
      Compare(comparison, scene, name + "cells");
      CHECK_GREATER(CountColors(scene.Draw()), 20);
      ColorBy(scene.Mapper, "Colors");
      Compare(comparison, scene, name + "direct");
    }
  }
}

void TestSettings(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto curves = RelevoMakeCurves(3);
  vtkNew<vtkShortArray> whole;
  whole->SetName("Whole");
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    whole->InsertNextValue(static_cast<short>(i % 5));
  }
  curves->GetPointData()->AddArray(whole);
  RelevoCurveScene scene(curves);
  scene.Actor->GetProperty()->LightingOff();
  scene.Actor->GetProperty()->SetLineWidth(4.0f);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(7);
  table->SetHueRange(0.0, 0.8);
  table->Build();
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetScalarRange(0.0, 4.0);
  ColorBy(scene.Mapper, "Whole");
  Compare(comparison, scene, "whole numbers");
  table->SetTableValue(2, 1.0, 1.0, 1.0, 1.0);
  Compare(comparison, scene, "another table");
  scene.Mapper->SetScalarRange(1.0, 3.0);
  Compare(comparison, scene, "another range");
  scene.Mapper->SetArrayComponent(1);
  ColorBy(scene.Mapper, "Vectors");
  scene.Mapper->SetScalarRange(0.0, 1.0);
  Compare(comparison, scene, "a component");
  const vtkIdType builds = scene.Mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = scene.Mapper->GetNumberOfShaderBuilds();
  scene.GetCamera()->Azimuth(3.0);
  scene.Draw();
  CHECK_EQUAL(scene.Mapper->GetNumberOfBufferBuilds(), builds);
  CHECK_EQUAL(scene.Mapper->GetNumberOfShaderBuilds(), shaders);
}

// Categories cannot be interpolated, but colours of the points can, by the curve's basis.
void TestCategories(RelevoCheck& check)
{
  const auto curves = RelevoMakeCurves(2);
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    names->InsertNextValue(i % 2 ? "odd" : "even");
  }
  curves->GetPointData()->AddArray(names);
  RelevoCurveScene scene(curves);
  scene.Actor->GetProperty()->LightingOff();
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 0.0, 1.0);
  table->SetAnnotation(vtkVariant("even"), "even");
  table->SetAnnotation(vtkVariant("odd"), "odd");
  table->IndexedLookupOn();
  scene.Mapper->SetLookupTable(table);
  ColorBy(scene.Mapper, "Names");
  RelevoErrors errors(scene.Mapper);
  const RelevoPicture picture = scene.Draw();
  CHECK(errors.None());
  size_t reds = 0;
  size_t blues = 0;
  for (size_t i = 0; i < picture.Colors.size(); i += 3)
  {
    CHECK_EQUAL(picture.Colors[i + 1], 0);
    reds += picture.Colors[i] > 200 ? 1 : 0;
    blues += picture.Colors[i + 2] > 200 ? 1 : 0;
  }
  CHECK_GREATER(reds, 20);
  CHECK_GREATER(blues, 20);
}

// Each block has the colours of its cells.
void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 1.0, 0.0);
  for (unsigned int block = 0; block < 2; ++block)
  {
    blocks->SetBlock(block, RelevoMakeCurves(3 + static_cast<int>(block)));
    vtkPointSet::SafeDownCast(blocks->GetBlock(block))
      ->GetCellData()
      ->GetArray("Numbers")
      ->Fill(block);
  }
  RelevoCurveScene scene(blocks);
  scene.Actor->GetProperty()->LightingOff();
  scene.Mapper->SetLookupTable(table);
  ColorBy(scene.Mapper, "Numbers", true);
  const RelevoPicture picture = scene.Draw();
  size_t reds = 0;
  size_t greens = 0;
  for (size_t i = 0; i < picture.Colors.size(); i += 3)
  {
    reds += picture.Colors[i] == 255 ? 1 : 0;
    greens += picture.Colors[i + 1] == 255 ? 1 : 0;
  }
  CHECK_GREATER(reds, 100);
  CHECK_GREATER(greens, 100);
}

// A translucent lookup table is drawn in the translucent pass.
void TestOpacity(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.2, 0.6);
  table->Build();
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetRadius(0.06);
  scene.Mapper->SetRepresentationToTubes();
  scene.Renderer->SetUseDepthPeeling(true);
  ColorBy(scene.Mapper, "Values");
  CHECK(scene.Mapper->HasTranslucentPolygonalGeometry());
  CHECK(!scene.Mapper->HasOpaqueGeometry());
  Compare(comparison, scene, "translucent table", { 3, 1e-6, 30 });
  const RelevoPicture alone = scene.Draw();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, RelevoMakeCurves(3));
  scene.Mapper->SetInputDataObject(blocks);
  CHECK(scene.Mapper->HasTranslucentPolygonalGeometry());
  CHECK_EQUAL(scene.Draw().Colors, alone.Colors);
  scene.Mapper->ScalarVisibilityOff();
  CHECK(!scene.Mapper->HasTranslucentPolygonalGeometry());
}
}

int TestAdaptiveCurveMapperColors(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestValues(check, comparison);
  TestSettings(check, comparison);
  TestCategories(check);
  TestBlocks(check);
  TestOpacity(check, comparison);
  return check.GetResult();
}
