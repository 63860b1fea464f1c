// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that vtkReliefMapper reports invalid input once and draws the rest.
#include "RelevoCheck.h"
#include "RelevoReliefScene.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkShaderProperty.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>
#include <string>

namespace
{
using relevo::ReliefProjection;

vtkSmartPointer<vtkImageData> MakeFlat(int width, int height, double depth = 1.0)
{
  return RelevoMakeRelief(width, height, ReliefProjection::Parallel, RelevoSmallTexels(),
    [depth](int, int) { return depth; });
}

int CountDrawn(RelevoReliefScene& scene)
{
  const std::vector<float> depths = scene.DrawDepths();
  return static_cast<int>(
    std::count_if(depths.begin(), depths.end(), [](float depth) { return depth < 1.0f; }));
}

void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeFlat(20, 20));
  auto other = MakeFlat(20, 20);
  other->GetPointData()->RemoveArray("Depth");
  blocks->SetBlock(1, other);
  RelevoReliefScene scene(blocks->GetBlock(0), 60, 40);
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetInputDataObject(blocks);
  CHECK_GREATER(CountDrawn(scene), 100);
  CHECK(errors.Said("Block 2: A relief needs the point array 'Depth'"));
  scene.Window->Render();
  CHECK(errors.None()); // reported once
  blocks->SetBlock(1, MakeFlat(20, 20, std::numeric_limits<double>::quiet_NaN()));
  CHECK_GREATER(CountDrawn(scene), 100);
  CHECK(errors.Said("Block 2: No value of the point array 'Depth' is finite"));
  other = MakeFlat(20, 20);
  other->GetFieldData()->RemoveArray("ReliefMatrix");
  blocks->SetBlock(0, other);
  blocks->SetBlock(1, nullptr);
  CHECK_EQUAL(CountDrawn(scene), 0);
  CHECK(errors.Said("Block 1: A relief needs the field array 'ReliefMatrix'"));
}

void TestTypes(RelevoCheck& check)
{
  const auto relief = MakeFlat(20, 20);
  RelevoReliefScene scene(relief, 60, 40);
  RelevoErrors errors(scene.Mapper);
  vtkNew<vtkTable> table;
  scene.Mapper->SetInputDataObject(table);
  CHECK_EQUAL(CountDrawn(scene), 0);
  CHECK(errors.Said("A relief must be a vtkImageData, not a vtkTable."));
  scene.Window->Render();
  CHECK(errors.None()); // reported once
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, table);
  blocks->SetBlock(1, relief);
  scene.Mapper->SetInputDataObject(blocks);
  CHECK_GREATER(CountDrawn(scene), 100);
  CHECK(errors.Said("Block 1: A relief must be a vtkImageData, not a vtkTable."));
  scene.Window->Render();
  CHECK(errors.None());
}

void TestNothing(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  RelevoReliefScene scene(blocks, 60, 40);
  RelevoErrors errors(scene.Mapper);
  CHECK_EQUAL(CountDrawn(scene), 0);
  CHECK(!vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds()));
  for (int method = 0; method < 4; ++method)
  {
    scene.Mapper->SetMethod(method);
    blocks->SetBlock(0, MakeFlat(1, 30));
    CHECK_EQUAL(CountDrawn(scene), 0);
    blocks->SetBlock(0, MakeFlat(30, 1));
    CHECK_EQUAL(CountDrawn(scene), 0);
  }
  CHECK(errors.None());
  scene.Mapper->SetInputDataObject(nullptr);
  scene.Mapper->Render(scene.Renderer, scene.Actor);
  CHECK(errors.Said("There is no input: call SetInputConnection() or SetInputData()."));
}

void TestTooLarge(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeFlat(200000, 2));
  blocks->SetBlock(1, MakeFlat(20, 20));
  RelevoReliefScene scene(blocks, 60, 40);
  RelevoErrors errors(scene.Mapper);
  scene.Window->Render();
  CHECK(errors.Said("Block 1: The image has 200000 x 2 points, but textures"));
  scene.Window->Render();
  CHECK(errors.None()); // reported once
}

void TestSettings(RelevoCheck& check)
{
  vtkNew<vtkReliefMapper> mapper;
  RelevoErrors errors(mapper);
  mapper->SetMethod(4);
  CHECK(
    errors.Said("Method must be one of WARP (0), RAY_MARCH (1), REFINEMENT (2), AUTOMATIC (3)"));
  mapper->SetSearch(-1);
  CHECK(errors.Said("Search must be one of LINEAR_BINARY (0)"));
  mapper->SetShading(2);
  CHECK(errors.Said("Shading must be one of CAPTURED (0), LIT (1), got 2."));
  mapper->SetMaximumStretch(-1.0);
  CHECK(errors.Said("MaximumStretch must be at least 0"));
  mapper->SetMethodToWarp();
  mapper->SetSearchToLinearSecant();
  mapper->SetShadingToLit();
  mapper->SelfShadowOn();
  mapper->SetMaximumStretch(3.0);
  vtkNew<vtkReliefMapper> copy;
  copy->ShallowCopy(mapper);
  CHECK_EQUAL(copy->GetMethod(), vtkReliefMapper::METHOD_WARP);
  CHECK_EQUAL(copy->GetSearch(), vtkReliefMapper::SEARCH_LINEAR_SECANT);
  CHECK_EQUAL(copy->GetShading(), vtkReliefMapper::LIT);
  CHECK_EQUAL(copy->GetMaximumStretch(), 3.0);
  CHECK(copy->GetSelfShadow());
  CHECK(errors.None());
}

// The error is reported once, not in every frame.
void TestShaders(RelevoCheck& check)
{
  RelevoReliefScene scene(MakeFlat(20, 20), 60, 40);
  scene.Mapper->SetMethodToRayMarch();
  RelevoErrors errors(scene.Mapper);
  const std::string mark = "//VTK::Depth::Impl";
  scene.Actor->GetShaderProperty()->AddFragmentShaderReplacement(mark, true, "", true);
  CHECK_EQUAL(CountDrawn(scene), 0);
  CHECK(errors.Said("fragment shader: \"" + mark + "\""));
  scene.Window->Render();
  CHECK(errors.None());
  scene.Actor->GetShaderProperty()->ClearAllFragmentShaderReplacements();
  CHECK_GREATER(CountDrawn(scene), 100);
  CHECK(errors.None());
}
}

int TestReliefMapperErrors(int, char*[])
{
  RelevoCheck check;
  TestBlocks(check);
  TestTypes(check);
  TestNothing(check);
  TestTooLarge(check);
  TestSettings(check);
  TestShaders(check);
  return check.GetResult();
}
