// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveMapper promises one error for invalid input. Valid curves are drawn, and so is
// valid input afterwards.
#include "RelevoCurveScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"

#include <string>

namespace
{
using Mapper = vtkAdaptiveCurveMapper;

// The error appears in the first frame, but not in the next.
void ExpectError(RelevoCheck& check, RelevoCurveScene& scene, const char* words)
{
  RelevoErrors errors(scene.Mapper);
  scene.Draw();
  if (!errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, std::string("no error with: ") + words);
  }
  scene.Draw();
  CHECK(errors.None());
}

void TestCells(RelevoCheck& check)
{
  const auto grid = RelevoMakeCurves(3);
  RelevoCurveScene good(grid);
  const RelevoPicture expected = good.Draw();
  const auto bad = RelevoMakeCurves(3);
  const vtkIdType points[3] = { 0, 1, 2 };
  bad->InsertNextCell(VTK_CUBIC_LINE, 3, points);
  RelevoCurveScene scene(grid);
  scene.Mapper->SetInputDataObject(bad);
  ExpectError(check, scene, "Cell 24 has 3 points, but needs 4. It is left out.");
  CHECK_EQUAL(scene.Draw().Colors, expected.Colors);
  bad->GetPoints()->SetPoint(0, vtkMath::Nan(), 0.0, 0.0);
  bad->GetPoints()->Modified();
  ExpectError(check, scene, "Cell 0 has point 0, which is not finite. It and 1 more");
  CHECK_EQUAL(scene.Mapper->GetNumberOfCurves(), 23);
  CHECK(vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds()));
}

void TestInput(RelevoCheck& check)
{
  vtkNew<vtkUnstructuredGrid> empty;
  RelevoCurveScene scene(empty);
  {
    RelevoErrors errors(scene.Mapper);
    CHECK_EQUAL(scene.Draw().CountForeground(), 0);
    CHECK(!vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds()));
    CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), 0);
    CHECK(errors.None());
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  scene.Mapper->SetInputDataObject(sphere->GetOutput());
  ExpectError(check, scene, "None of the input's cells is a curve.");
  vtkNew<vtkTable> table;
  scene.Mapper->SetInputDataObject(table);
  ExpectError(check, scene, "A vtkTable has no curves");
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  blocks->SetBlock(0, RelevoMakeCurves(3));
  blocks->SetBlock(1, image);
  scene.Mapper->SetInputDataObject(blocks);
  ExpectError(check, scene, "Block 2: A vtkImageData has no curves");
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
  scene.Mapper->RemoveAllInputs();
  {
    RelevoErrors errors(scene.Mapper);
    scene.Mapper->Render(scene.Renderer, scene.Actor); // the renderer skips it
    CHECK(errors.Said("There is no input: call SetInputConnection() or SetInputData()."));
  }
  scene.Mapper->SetInputDataObject(RelevoMakeCurves(3));
  scene.Mapper->SetRefinement(nullptr);
  ExpectError(
    check, scene, "There is no recipe: call SetRefinement() with a vtkAdaptiveRefinement.");
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), 0);
  scene.Mapper->SetRefinement(scene.Recipe);
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
}

void TestArrays(RelevoCheck& check)
{
  const auto curves = RelevoMakeCurves(3);
  vtkNew<vtkDoubleArray> tags;
  tags->SetName("DepthTag");
  tags->SetNumberOfValues(curves->GetNumberOfPoints());
  tags->FillValue(2.0);
  tags->SetValue(5, vtkMath::Nan());
  curves->GetPointData()->AddArray(tags);
  RelevoCurveScene scene(curves);
  ExpectError(check, scene, "DepthTag");
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  tags->SetValue(5, 2.0);
  tags->Modified();
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), 24 * 4);

  scene.Mapper->SetRadiusArrayName("Nowhere");
  {
    RelevoErrors errors(scene.Mapper);
    scene.Draw(); // lines need no radii
    CHECK(errors.None());
  }
  scene.Mapper->SetRepresentationToTubes();
  ExpectError(check, scene, "Cannot read the radii: ");
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), 0);
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawCalls(), 0);
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("Nowhere");
  ofCells->SetNumberOfValues(curves->GetNumberOfCells());
  ofCells->FillValue(0.1);
  curves->GetCellData()->AddArray(ofCells);
  curves->Modified();
  ExpectError(check, scene,
    "Cannot read the radii: there is no point array \"Nowhere\", but a cell array of "
    "that name. Convert it with vtkCellDataToPointData.");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Nowhere");
  radii->SetNumberOfValues(curves->GetNumberOfPoints());
  radii->FillValue(0.1);
  radii->SetValue(3, -1.0);
  curves->GetPointData()->AddArray(radii);
  ExpectError(
    check, scene, "Cannot read the radii: point array \"Nowhere\" is negative at point 3.");
  radii->SetValue(3, 0.1);
  radii->Modified();
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
}

void TestScalars(RelevoCheck& check)
{
  const auto curves = RelevoMakeCurves(3);
  vtkNew<vtkDoubleArray> few;
  few->SetName("Few");
  few->InsertNextValue(1.0);
  curves->GetPointData()->AddArray(few);
  RelevoCurveScene scene(curves);
  scene.Mapper->ScalarVisibilityOn();
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectColorArray("Few");
  ExpectError(check, scene, "Cannot colour by the array \"Few\": it has values for 1 of ");
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
  scene.Mapper->SelectColorArray("Values");
  RelevoErrors errors(scene.Mapper);
  scene.Draw();
  CHECK(errors.None());
}

void TestShaders(RelevoCheck& check)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Actor->GetShaderProperty()->AddVertexShaderReplacement(
    "in vec4 vertexMC;", true, "in vec4 otherMC;", false);
  ExpectError(check, scene, "do not contain text that Relevo replaces");
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  scene.Actor->GetShaderProperty()->ClearAllVertexShaderReplacements();
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
}

// Without OpenGL 4.0, instances are drawn and an error reports it.
void TestMethod(RelevoCheck& check)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  const RelevoPicture expected = scene.Draw();
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetMethodToHardwareTessellation();
  CHECK_EQUAL(scene.Draw().Colors, expected.Colors);
  if (scene.Mapper->GetMethodInUse() == Mapper::METHOD_INSTANCING)
  {
    CHECK(errors.Said("The method HARDWARE_TESSELLATION cannot be used: it needs OpenGL 4.0, which "
                      "this OpenGL context does not have. The method INSTANCING is used instead."));
  }
  scene.Draw();
  CHECK(errors.None());
}

void TestSettings(RelevoCheck& check)
{
  vtkNew<Mapper> mapper;
  RelevoErrors errors(mapper);
  mapper->SetMethod(2);
  CHECK(errors.Said("Method must be one of INSTANCING (0), HARDWARE_TESSELLATION (1), got 2."));
  mapper->SetRepresentation(-1);
  CHECK(errors.Said("Representation must be one of LINES (0), RIBBONS (1), TUBES (2), got -1."));
  mapper->SetRadius(-1.0);
  CHECK(errors.Said("Radius must be at least 0 and finite, got -1."));
  mapper->SetNumberOfSides(2);
  CHECK(errors.Said("NumberOfSides must be in [3, 64], got 2."));
  CHECK_EQUAL(mapper->GetMethod(), 0);
  CHECK_EQUAL(mapper->GetRepresentation(), 0);
  CHECK_EQUAL(mapper->GetRadius(), 0.5);
  CHECK_EQUAL(mapper->GetNumberOfSides(), 8);
}
}

int TestAdaptiveCurveMapperErrors(int, char*[])
{
  RelevoCheck check;
  TestCells(check);
  TestInput(check);
  TestArrays(check);
  TestScalars(check);
  TestShaders(check);
  TestMethod(check);
  TestSettings(check);
  return check.GetResult();
}
