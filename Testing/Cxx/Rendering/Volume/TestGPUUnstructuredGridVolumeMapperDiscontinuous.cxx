// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on discontinuous scalars: cells with their own points are neighbours, and each
// keeps its values.
#include "RelevoCheck.h"
#include "RelevoVolumePieces.h"

#include "vtkAppendFilter.h"
#include "vtkCellType.h"
#include "vtkContourValues.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <limits>

namespace
{
constexpr double Jump = 0.15;
constexpr int Kinds[] = { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_TETRA, VTK_QUADRATIC_TETRA,
  VTK_PENTAGONAL_PRISM };

vtkSmartPointer<vtkUnstructuredGrid> MakeCells(int type)
{
  return MakeBlocksOfCells(type, GetWaves);
}

void SetSurfaces(RelevoVolumeScene& scene)
{
  vtkContourValues* values = scene.GetVolume()->GetProperty()->GetIsoSurfaceValues();
  values->SetNumberOfContours(2);
  values->SetValue(0, 0.4);
  values->SetValue(1, 0.7);
}

void CheckScene(RelevoCheck& check, RelevoVolumeScene& scene)
{
  const std::vector<RelevoColor> drawn = scene.Draw();
  const std::vector<RelevoColor> cast = scene.Cast();
  // A ray along a face may take the values of either cell.
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast, 0.001), 3.0);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast, 0.01), 1.0);
}

// A ray enters the mesh once, as if values were continuous.
void TestKinds(RelevoCheck& check)
{
  for (int type : Kinds)
  {
    CHECK_CASE(type);
    const auto mesh = MakeCells(type);
    RelevoVolumeScene scene(
      MakeDiscontinuous(mesh, Jump), MakeVolumeProperty(0.0, 1.0, 0.5), 100, 80);
    CheckScene(check, scene);
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
    scene.GetCamera()->ParallelProjectionOn();
    scene.GetCamera()->Azimuth(130.0);
    scene.GetRenderer()->ResetCameraClippingRange();
    CheckScene(check, scene);
  }
}

// Rays pass between curved cells and tetrahedra; only half of the mesh is discontinuous.
void TestMixed(RelevoCheck& check)
{
  int layers[2];
  for (const bool isDiscontinuous : { false, true })
  {
    CHECK_CASE(isDiscontinuous);
    const double jump = isDiscontinuous ? Jump : 0.0;
    vtkNew<vtkAppendFilter> append;
    append->AddInputData(MakeDiscontinuous(MakeCells(VTK_TETRA), jump));
    append->AddInputData(MakeBlocksOfCells(VTK_WEDGE, GetWaves, 0.0, 3.0));
    append->AddInputData(
      MakeDiscontinuous(MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves, 0.0, 6.0), jump));
    append->AddInputData(MakeBlocksOfCells(VTK_PYRAMID, GetWaves, 0.0, 9.0));
    append->Update();
    RelevoVolumeScene scene(append->GetOutput(), MakeVolumeProperty(0.0, 1.0, 0.5));
    CheckScene(check, scene);
    layers[isDiscontinuous] = scene.GetMapper()->GetNumberOfLayers();
    for (double angle : { 90.0, 170.0 })
    {
      scene.GetCamera()->Azimuth(angle);
      scene.GetRenderer()->ResetCameraClippingRange();
      CheckScene(check, scene);
    }
  }
  CHECK_EQUAL(layers[1], layers[0]);
}

// Cell projection draws tetrahedra by themselves.
void TestProjection(RelevoCheck& check)
{
  RelevoVolumeScene scene(
    MakeDiscontinuous(MakeCells(VTK_TETRA), Jump), MakeVolumeProperty(0.0, 1.0, 0.5), 100, 80);
  scene.GetMapper()->SetMethodToCellProjection();
  CheckScene(check, scene);
}

// Blend modes, shading, gradient opacity, isosurfaces and several components.
void TestFeatures(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA })
  {
    CHECK_CASE(type);
    const auto property = MakeVolumeProperty(0.0, 1.0, 0.5);
    RelevoVolumeScene scene(MakeDiscontinuous(MakeCells(type), Jump), property, 60, 48);
    SetSurfaces(scene);
    for (int mode = 1; mode <= 5; ++mode)
    {
      CHECK_CASE(mode);
      scene.GetMapper()->SetBlendMode(mode);
      CHECK_LESS_EQUAL(
        scene.Compare(0.01, [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); }),
        3.0);
    }
    scene.GetMapper()->SetBlendMode(0);
    vtkNew<vtkPiecewiseFunction> gradientOpacity;
    gradientOpacity->AddPoint(0.1, 0.0);
    gradientOpacity->AddPoint(0.6, 1.0);
    property->SetGradientOpacity(gradientOpacity);
    CHECK_LESS_EQUAL(scene.Compare(0.02), 6.0);
    property->SetDisableGradientOpacity(1);
    property->ShadeOn();
    property->SetAmbient(0.2);
    property->SetDiffuse(0.8);
    property->SetSpecular(0.4);
    CHECK_LESS_EQUAL(scene.Compare(0.01), 3.0);
    scene.GetMapper()->IsoSurfacesOn();
    CHECK_LESS_EQUAL(
      scene.Compare(0.01, [](vtkVolumeRayCastFilter* filter) { filter->IsoSurfacesOn(); }), 3.0);
  }
}

void TestComponents(RelevoCheck& check)
{
  for (int components = 2; components <= 4; ++components)
  {
    CHECK_CASE(components);
    const auto ball = MakeBall(200);
    ball->GetPointData()->SetScalars(MakeBusyArray(ball, components));
    RelevoVolumeScene scene(
      MakeDiscontinuous(ball, Jump), MakeBusyProperty(0.3, components), 100, 75);
    CheckScene(check, scene);
  }
}

// Nodes that are close together: the walk finds the piece of the function after each jump.
void TestNodes(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA })
  {
    CHECK_CASE(type);
    RelevoVolumeScene scene(
      MakeDiscontinuous(MakeCells(type), 0.5), MakeBusyProperty(0.3), 100, 75);
    CheckScene(check, scene);
    scene.GetMapper()->SetIntegrationToPreIntegrated();
    scene.GetMapper()->SetTableSize(256);
    CHECK_LESS_EQUAL(scene.Compare(0.02), 6.0);
  }
}

void TestPieces(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA })
  {
    CHECK_CASE(type);
    const auto mesh = MakeDiscontinuous(MakeCells(type), Jump);
    RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), 100, 75);
    RelevoVolumePieces pieces(scene, DealCells(mesh, RelevoDealing::Random, 4));
    const std::vector<RelevoColor> drawn = scene.Draw();
    pieces.Cast();
    CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(pieces.Merge(false), drawn), 2.0 + 1e-6);
  }
}

// The corners of tetrahedra have values, and points at one place are merged. New values are
// uploaded without building the mesh.
void TestCorners(RelevoCheck& check)
{
  const auto cells = MakeCells(VTK_TETRA);
  const auto mesh = MakeDiscontinuous(cells, Jump);
  const auto property = MakeVolumeProperty(0.0, 1.0, 0.5);
  RelevoVolumeScene scene(mesh, property, 60, 48);
  scene.Draw();
  RelevoVolumeScene continuous(cells, property, 60, 48);
  continuous.Draw();
  CHECK_LESS_EQUAL(scene.GetMapper()->GetGraphicsMemorySize(),
    continuous.GetMapper()->GetGraphicsMemorySize() + 16 * cells->GetNumberOfCells() + 64);
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 1.0 - values->GetComponent(i, 0));
  }
  values->Modified();
  mesh->Modified();
  CheckScene(check, scene);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfValueUploads(), 1);
}

// Many points without finite values at one place.
void TestNaN(RelevoCheck& check)
{
  const auto mesh = MakeDiscontinuous(MakeCells(VTK_HEXAHEDRON), Jump);
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (int i = 0; i < 8; ++i)
  {
    values->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
  }
  for (int i = 0; i < 100000; ++i)
  {
    mesh->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
    values->InsertNextTuple1(i % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e-6 * i);
  }
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.0, 1.0, 0.5), 100, 80);
  CheckScene(check, scene);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells() - 1);
}
}

int TestGPUUnstructuredGridVolumeMapperDiscontinuous(int, char*[])
{
  RelevoCheck check;
  TestKinds(check);
  TestMixed(check);
  TestProjection(check);
  TestFeatures(check);
  TestComponents(check);
  TestNodes(check);
  TestPieces(check);
  TestCorners(check);
  TestNaN(check);
  return check.GetResult();
}
