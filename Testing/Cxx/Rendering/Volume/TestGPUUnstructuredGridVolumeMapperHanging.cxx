// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on refined cells: rays pass from large cells to smaller ones and back without
// leaving the mesh, and no pixel is dark or doubled.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoRefinedCells.h"
#include "RelevoVolumePieces.h"

#include "vtkCellType.h"
#include "vtkContourValues.h"

namespace
{
constexpr int Width = 80;
constexpr int Height = 60;

RelevoPoint Turn(const RelevoPoint& at)
{
  const double x = 0.8 * at[0] - 0.6 * at[1];
  const double y = 0.6 * at[0] + 0.8 * at[1];
  return { { 0.28 * x - 0.96 * at[2] + 7.0, y, 0.96 * x + 0.28 * at[2] } };
}

// A ray enters the mesh once, as if no points hang.
void TestLinear(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_VOXEL, VTK_WEDGE, VTK_PYRAMID, VTK_TETRA })
  {
    for (int levels = type == VTK_VOXEL ? 1 : 3; levels <= 3; ++levels)
    {
      CHECK_CASE(10 * type + levels);
      RelevoRefinedCells cells;
      cells.Levels = levels;
      const auto mesh = cells.Make(type);
      RelevoVolumeScene scene(mesh, MakeLinearProperty(), Width, Height);
      const auto expected = MakeLinearPicture(scene.GetCamera(), Width, Height);
      CHECK_LESS(RelevoVolumeScene::Compare(scene.Draw(), expected), 1.0);
      CHECK_LESS(RelevoVolumeScene::Compare(scene.Cast(), expected), 0.01);
      CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
      CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
    }
  }
}

// Rays pass exactly through hanging points and along edges.
void TestEdges(RelevoCheck& check)
{
  for (int type : { VTK_VOXEL, VTK_TETRA })
  {
    CHECK_CASE(type);
    RelevoRefinedCells cells;
    cells.Levels = 2;
    RelevoVolumeScene scene(cells.Make(type), MakeLinearProperty(), 97, 97);
    LookAlongEdges(scene);
    const auto expected = MakeLinearPicture(scene.GetCamera(), 97, 97);
    CHECK_LESS(255.0 * FindLargestDifferenceInside(scene.Draw(), expected, 97, 26, 70), 1.0);
    CHECK_LESS(255.0 * FindLargestDifferenceInside(scene.Cast(), expected, 97, 26, 70), 0.01);
  }
}

// Hanging points are next to the edges of larger cells, because they are rounded to floats. The
// picture is that of the mesh that is not refined, also after the points have moved.
void TestRounding(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA })
  {
    CHECK_CASE(type);
    RelevoRefinedCells coarse;
    coarse.Levels = 0;
    coarse.IsFloat = true;
    coarse.Move = Turn;
    RelevoRefinedCells cells = coarse;
    cells.Levels = 3;
    const auto mesh = cells.Make(type);
    const auto whole = coarse.Make(type);
    RelevoVolumeScene scene(mesh, MakeLinearProperty(), Width, Height);
    RelevoVolumeScene expected(whole, MakeLinearProperty(), Width, Height);
    expected.GetRenderer()->SetActiveCamera(scene.GetCamera());
    for (int step = 0; step < 3; ++step)
    {
      CHECK_CASE(step);
      const auto picture = expected.Draw();
      CHECK_LESS(CompareInside(scene.Draw(), picture, Width), 1.0);
      CHECK_LESS(CompareInside(scene.Cast(), picture, Width), 1.0);
      CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
      cells.Move = coarse.Move = [step](const RelevoPoint& at)
      {
        const RelevoPoint turned = Turn(at);
        return RelevoPoint{ { turned[0], turned[1] + 0.2 * (step + 1) * turned[2], turned[2] } };
      };
      mesh->SetPoints(cells.Make(type)->GetPoints());
      whole->SetPoints(coarse.Make(type)->GetPoints());
      scene.GetCamera()->Azimuth(50.0);
      scene.GetRenderer()->ResetCamera();
    }
  }
}

void CheckScene(RelevoCheck& check, RelevoVolumeScene& scene)
{
  const std::vector<RelevoColor> drawn = scene.Draw();
  const std::vector<RelevoColor> cast = scene.Cast();
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast, 0.001), 3.0);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast, 0.01), 1.0);
}

// Both sides of a face keep their values, and cells may have points of their own.
void TestValues(RelevoCheck& check)
{
  RelevoRefinedCells cells;
  cells.Levels = 2;
  cells.Field = GetWaves;
  const int types[][2] = { { VTK_HEXAHEDRON, 0 }, { VTK_TETRA, 0 }, { VTK_VOXEL, VTK_TETRA },
    { VTK_HEXAHEDRON, VTK_PYRAMID }, { VTK_HEXAHEDRON, VTK_WEDGE } };
  for (const auto& type : types)
  {
    CHECK_CASE(100 * type[0] + type[1]);
    const auto mesh = cells.Make(type[0], type[1]);
    for (const bool isDiscontinuous : { false, true })
    {
      CHECK_CASE(isDiscontinuous);
      if (!isDiscontinuous && type[1] != VTK_TETRA)
      {
        continue; // compiling shaders takes long
      }
      RelevoVolumeScene scene(isDiscontinuous ? MakeDiscontinuous(mesh, 0.15) : mesh,
        MakeVolumeProperty(0.0, 1.0, 0.5), Width, Height);
      CheckScene(check, scene);
      CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
      CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
      if (isDiscontinuous || type[1] != VTK_TETRA)
      {
        continue;
      }
      vtkContourValues* surfaces = scene.GetVolume()->GetProperty()->GetIsoSurfaceValues();
      surfaces->SetValue(0, 0.4);
      surfaces->SetValue(1, 0.7);
      scene.GetMapper()->IsoSurfacesOn();
      CHECK_LESS_EQUAL(
        scene.Compare(0.01, [](vtkVolumeRayCastFilter* filter) { filter->IsoSurfacesOn(); }), 3.0);
    }
  }
}

// Cells are missing next to a larger cell, so that smaller faces cover a part of its face.
void TestHoles(RelevoCheck& check)
{
  RelevoRefinedCells cells;
  cells.Levels = 2;
  cells.Field = GetWaves;
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA })
  {
    CHECK_CASE(type);
    const auto pieces = DealCells(cells.Make(type), RelevoDealing::Random, 2);
    RelevoVolumeScene scene(pieces[0], MakeVolumeProperty(0.0, 1.0, 0.5), Width, Height);
    CheckScene(check, scene);
  }
}

void TestPieces(RelevoCheck& check)
{
  RelevoRefinedCells cells;
  cells.Levels = 2;
  cells.Field = GetWaves;
  const auto mesh = cells.Make(VTK_HEXAHEDRON);
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), Width, Height);
  RelevoVolumePieces pieces(scene, DealCells(mesh, RelevoDealing::Slabs, 3));
  const std::vector<RelevoColor> drawn = scene.Draw();
  pieces.Cast();
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(pieces.Merge(false), drawn), 2.0 + 1e-6);
}
}

int TestGPUUnstructuredGridVolumeMapperHanging(int, char*[])
{
  RelevoCheck check;
  TestLinear(check);
  TestEdges(check);
  TestRounding(check);
  TestValues(check);
  TestHoles(check);
  TestPieces(check);
  return check.GetResult();
}
