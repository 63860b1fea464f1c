// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on skipped cells: rays to opaque isosurfaces start at the cells that contain
// them, and the picture is that of rays through all cells.
#include "RelevoCheck.h"
#include "RelevoRefinedCells.h"
#include "RelevoVolumePieces.h"
#include "RelevoVolumeScene.h"

#include "vtkActor.h"
#include "vtkCellType.h"
#include "vtkContourValues.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace
{
constexpr int Width = 80;
constexpr int Height = 60;
// Less than the opacity behind which rays end.
constexpr double NearlyOpaque = 0.998;

// From 0 to 1 in blocks of cells.
double GetSlope(const RelevoPoint& at)
{
  return (at[0] + 0.5 * at[1] + 0.3 * at[2] + 0.1 * std::sin(2.0 * at[0] * at[1])) / 5.5;
}

void SetOpacity(vtkVolumeProperty* property, double opacity)
{
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPiecewiseFunction> constant;
    constant->AddPoint(0.0, opacity);
    property->SetScalarOpacity(i, constant);
  }
}

vtkSmartPointer<vtkVolumeProperty> MakeSurfaces(const std::vector<double>& values)
{
  auto property = MakeVolumeProperty(0.0, 1.0);
  property->SetColor(1, property->GetRGBTransferFunction(0));
  SetOpacity(property, 1.0);
  property->GetIsoSurfaceValues()->SetNumberOfContours(static_cast<int>(values.size()));
  for (size_t i = 0; i < values.size(); ++i)
  {
    property->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), values[i]);
  }
  return property;
}

// Compares with rays through all cells, which nearly opaque surfaces need, and with the filter. A
// ray that grazes a surface may hit it or not.
void CompareSkipping(RelevoCheck& check, RelevoVolumeScene& scene, double share = 0.002)
{
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  mapper->SetBlendModeToIsoSurface();
  const auto drawn = scene.Draw();
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  CHECK_GREATER(FindLargestDifference(drawn, std::vector<RelevoColor>(drawn.size())), 0.3);
  const auto cast =
    scene.Cast([](vtkVolumeRayCastFilter* filter) { filter->SetBlendModeToIsoSurface(); });
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast, share), 3.0);
  SetOpacity(scene.GetVolume()->GetProperty(), NearlyOpaque);
  const auto walked = scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfSkippedCells(), 0);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, walked, 0.001), 1.01);
  SetOpacity(scene.GetVolume()->GetProperty(), 1.0);
}

void CompareMesh(RelevoCheck& check, vtkDataObject* mesh, double share = 0.002)
{
  RelevoVolumeScene scene(mesh, MakeSurfaces({ 0.31, 0.52 }), Width, Height);
  CompareSkipping(check, scene, share);
}

void TestMeshes(RelevoCheck& check)
{
  const auto tetrahedra = MakeTetrahedra(5, GetWaves);
  CompareMesh(check, tetrahedra);
  CompareMesh(check, MakeBall(300));
  CompareMesh(check, MakeDiscontinuous(tetrahedra, 0.05), 0.01);
  CompareMesh(check, MakeMixedCells(3, GetWaves), 0.01);
  CompareMesh(check, MakeBlocksOfCells(VTK_QUADRATIC_TETRA, GetSlope), 0.01);
  CompareMesh(check, MakeBlocksOfCells(VTK_QUADRATIC_TETRA, GetSlope, 0.04), 0.01); // curved
  RelevoRefinedCells hanging;
  hanging.Levels = 2;
  hanging.Field = GetWaves;
  CompareMesh(check, hanging.Make(VTK_HEXAHEDRON), 0.01);
}

void TestShading(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetSlope, 0.15);
  RelevoVolumeScene scene(mesh, MakeSurfaces({ 0.31, 0.52 }), Width, Height);
  scene.GetVolume()->GetProperty()->ShadeOn();
  CompareSkipping(check, scene, 0.01);
}

// Clipping planes, opaque props, another number of rays, and several components.
void TestFeatures(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(5, GetWaves);
  RelevoVolumeScene scene(mesh, MakeSurfaces({ 0.31, 0.52 }), Width, Height);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.5, 0.5);
  plane->SetNormal(-0.3, 0.5, -0.8);
  mapper->AddClippingPlane(plane);
  mapper->SetBlendModeToIsoSurface();
  const auto clipped = scene.Draw();
  const auto cast = scene.Cast(
    [&](vtkVolumeRayCastFilter* filter)
    {
      filter->SetBlendModeToIsoSurface();
      filter->AddClippingPlane(plane);
    });
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(clipped, cast, 0.002), 1.0);
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  mapper->RemoveAllClippingPlanes();
  // A sphere in the middle hides what is behind it.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.5, 0.5, 0.5);
  sphere->SetRadius(0.45);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);
  scene.GetRenderer()->AddActor(actor);
  const auto hidden = scene.Draw();
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  SetOpacity(scene.GetVolume()->GetProperty(), NearlyOpaque);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(hidden, scene.Draw(), 0.001), 1.01);
  scene.GetRenderer()->RemoveActor(actor);
  mapper->SetImageSampleDistance(2.0);
  const auto walked = scene.Draw();
  SetOpacity(scene.GetVolume()->GetProperty(), 1.0);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(scene.Draw(), walked, 0.005), 1.0);
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  mesh->GetPointData()->SetScalars(MakeBusyArray(mesh, 2));
  RelevoVolumeScene components(mesh, MakeSurfaces({ 0.31 }), Width, Height);
  CompareSkipping(check, components);
}

// Where rays must walk through the whole mesh.
void TestWalks(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(5, GetWaves), MakeSurfaces({ 0.41 }), Width, Height);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  CompareSkipping(check, scene);
  // The camera is inside of the mesh.
  scene.GetCamera()->SetPosition(0.52, 0.47, 0.55);
  scene.GetCamera()->SetFocalPoint(0.1, 0.2, 0.3);
  scene.GetCamera()->SetClippingRange(0.01, 5.0);
  CHECK_LESS_EQUAL(scene.Compare(0.002,
                     [](vtkVolumeRayCastFilter* filter) { filter->SetBlendModeToIsoSurface(); }),
    1.0);
  CHECK_EQUAL(mapper->GetNumberOfSkippedCells(), 0);
  RelevoVolumeScene tangled(
    MakeBlocksOfCells(VTK_QUADRATIC_TETRA, GetSlope, 0.15), MakeSurfaces({ 0.41 }), Width, Height);
  tangled.GetMapper()->SetBlendModeToIsoSurface();
  tangled.Draw();
  CHECK_EQUAL(tangled.GetMapper()->GetNumberOfSkippedCells(), 0);
  scene.GetRenderer()->ResetCamera();
  scene.GetVolume()->GetProperty()->GetIsoSurfaceValues()->SetNumberOfContours(0);
  const auto nothing = scene.Draw();
  CHECK_EQUAL(FindLargestDifference(nothing, std::vector<RelevoColor>(nothing.size())), 0.0);
}

// Edits find other cells without a new mesh or shader.
void TestEdits(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetSlope, 0.1);
  RelevoVolumeScene scene(mesh, MakeSurfaces({ 0.3 }), Width, Height);
  CompareSkipping(check, scene, 0.01);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  const vtkIdType skipped = mapper->GetNumberOfSkippedCells();
  scene.GetVolume()->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 0.6);
  CompareSkipping(check, scene, 0.01);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 1);
  scene.Draw();
  CHECK_NOT_EQUAL(mapper->GetNumberOfSkippedCells(), skipped);
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 1.0 - values->GetComponent(i, 0));
  }
  values->Modified();
  mesh->Modified();
  CompareSkipping(check, scene, 0.01);
  CHECK_EQUAL(mapper->GetNumberOfValueUploads(), 1);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
}
}

int TestGPUUnstructuredGridVolumeMapperSkipping(int, char*[])
{
  RelevoCheck check;
  TestMeshes(check);
  TestShading(check);
  TestFeatures(check);
  TestWalks(check);
  TestEdits(check);
  return check.GetResult();
}
