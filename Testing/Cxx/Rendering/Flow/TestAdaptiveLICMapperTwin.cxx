// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that streaks on a mesh refined by the mapper equal those on the output of
// vtkAdaptiveRefinementFilter, for every surface and method, over displaced terrain, and for
// blocks.
#include "RelevoDisplacements.h"
#include "RelevoSurfaceFields.h"
#include "RelevoSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"

#include <iostream>

namespace
{
using RelevoMeshes::Mesh;

constexpr int Width = 320;
constexpr int Height = 240;

Mesh MakeTorus()
{
  Mesh mesh = WithNormals(RelevoMeshes::Torus(), NormalOfTorus);
  mesh = WithField(mesh, MakeSurfaceFields(NormalOfTorus)[3].Field);
  RelevoMeshes::AddRandomScalarTags(mesh, 3);
  return RelevoMeshes::Tagged(mesh, 3);
}

// Wind over the unit square, and its recipe for terrain.
Mesh MakeWind(int resolution)
{
  return WithField(RelevoMeshes::Plane(resolution, resolution),
    [](const std::array<double, 3>& p) {
      return std::array<double, 3>{ { 1.0, 0.4 + p[0] - 2.0 * p[1], 0.0 } };
    });
}

RelevoLICPicture Draw(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr, int method = 0)
{
  RelevoLICScene scene(Width, Height);
  vtkAdaptiveLICMapper* mapper = scene.Add(mesh, recipe);
  mapper->SetMethod(method);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.4, -2.0, 3.2);
  camera->SetViewAngle(40.0);
  scene.Renderer->ResetCameraClippingRange(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
  return scene.Render();
}

void Expect(RelevoCheck& check, const std::string& name, const RelevoLICPicture& actual,
  const RelevoLICPicture& expected, double different)
{
  const RelevoLikeness likeness = CompareLIC(actual, expected);
  std::cout << name << ": " << likeness << "\n";
  CHECK_GREATER(likeness.Count, 4000);
  CHECK_GREATER_EQUAL(likeness.SSIM, 0.99);
  CHECK_LESS_EQUAL(likeness.Different, different * likeness.Count);
  CHECK_LESS_EQUAL(likeness.OneSided, 0.002 * likeness.Count);
}

void TestSurfaces(RelevoCheck& check)
{
  const Mesh torus = MakeTorus();
  for (const auto& surface : RelevoMakeSurfaces())
  {
    const auto recipe = RelevoMeshes::MakeRecipe(3, surface.second);
    Expect(
      check, surface.first, Draw(torus, recipe), Draw(RelevoMeshes::Refine(torus, recipe)), 0.01);
  }
}

void TestTerrain(RelevoCheck& check)
{
  const Mesh wind = MakeWind(8);
  vtkNew<RelevoHeights> heights;
  heights->FillWavesWithHoles();
  auto displacement = RelevoMeshes::MakeDisplacement(heights, 0.1);
  const auto recipe = RelevoMeshes::MakeRecipe(4, nullptr, displacement);
  Expect(check, "terrain", Draw(wind, recipe), Draw(RelevoMeshes::Refine(wind, recipe)), 0.01);
}

// Tags differ from point to point, except for methods with one level.
void TestMethods(RelevoCheck& check)
{
  using M = vtkAdaptiveLICMapper;
  const Mesh torus = MakeTorus();
  vtkNew<vtkPNTriangleSurface> surface;
  const auto recipe = RelevoMeshes::MakeRecipe(3, surface);
  const RelevoLICPicture adaptive = Draw(torus, recipe);
  Expect(check, "ARK", Draw(torus, recipe, M::METHOD_ARK), adaptive, 0.01);

  const auto even = RelevoMeshes::MakeRecipe(3, surface);
  even->SetDepthTagArrayName("");
  const RelevoLICPicture expected = Draw(torus, even);
  const std::pair<std::string, int> methods[] = { { "DMR", M::METHOD_DMR },
    { "SUAPT", M::METHOD_SUAPT }, { "uniform", M::METHOD_UNIFORM },
    { "hardware tessellation", M::METHOD_HARDWARE_TESSELLATION } };
  for (const auto& method : methods)
  {
    // Hardware tessellation has other triangles inside a face.
    Expect(check, method.first, Draw(torus, even, method.second), expected,
      method.second == M::METHOD_HARDWARE_TESSELLATION ? 0.04 : 0.01);
  }
}

// Each block has every second face.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(vtkPolyData* mesh)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int part = 0; part < 2; ++part)
  {
    vtkNew<vtkPolyData> block;
    block->ShallowCopy(mesh);
    vtkNew<vtkCellArray> polys;
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = part; cell < mesh->GetNumberOfCells(); cell += 2)
    {
      mesh->GetCellPoints(cell, points);
      polys->InsertNextCell(points);
    }
    block->SetPolys(polys);
    block->GetCellData()->Initialize();
    blocks->SetBlock(part, block);
  }
  return blocks;
}

void TestBlocks(RelevoCheck& check)
{
  const Mesh torus = MakeTorus();
  vtkNew<vtkPNTriangleSurface> surface;
  const auto recipe = RelevoMeshes::MakeRecipe(3, surface);
  Expect(check, "blocks", Draw(MakeBlocks(torus), recipe), Draw(torus, recipe), 0.01);
}

// If the surface is flat and fields are linear, levels have no effect and there is no seam between
// them.
void TestLevels(RelevoCheck& check)
{
  const Mesh wind = MakeWind(6);
  const RelevoLICPicture expected = Draw(wind);
  Expect(check, "levels side by side",
    Draw(RelevoMeshes::Tagged(wind, 5), RelevoMeshes::MakeRecipe(5)), expected, 0.001);
}
}

int TestAdaptiveLICMapperTwin(int, char*[])
{
  RelevoCheck check;
  TestSurfaces(check);
  TestTerrain(check);
  TestMethods(check);
  TestBlocks(check);
  TestLevels(check);
  return check.GetResult();
}
