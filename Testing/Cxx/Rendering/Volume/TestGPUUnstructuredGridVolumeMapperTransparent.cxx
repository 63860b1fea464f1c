// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on transparent cells: from the second frame on, rays walk only between the
// first and the last visible cell, and the picture is that of rays through all cells.
#include "RelevoCheck.h"
#include "RelevoRefinedCells.h"
#include "RelevoVolumePieces.h"
#include "RelevoVolumeScene.h"

#include "vtkActor.h"
#include "vtkAppendFilter.h"
#include "vtkCellType.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace
{
constexpr int Width = 80;
constexpr int Height = 60;

// From 0 to 1 in blocks of cells.
double GetSlope(const RelevoPoint& at)
{
  return (at[0] + 0.5 * at[1] + 0.3 * at[2] + 0.1 * std::sin(2.0 * at[0] * at[1])) / 5.5;
}

// Opacity above a scalar, and below another.
vtkSmartPointer<vtkVolumeProperty> MakeProperty(double above, double below)
{
  auto property = MakeVolumeProperty(0.0, 0.0, 0.3);
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  if (below > 0.0)
  {
    opacity->AddPoint(0.5 * below, 0.6);
    opacity->AddPoint(below, 0.0);
  }
  opacity->AddPoint(above, 0.0);
  opacity->AddPoint(0.5 + 0.5 * above, 0.8);
  return property;
}

// Compares with the first frame, in which rays walk through all cells.
void CompareFrames(RelevoCheck& check, RelevoVolumeScene& scene)
{
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  const auto walked = scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfSkippedCells(), 0);
  CHECK_GREATER(FindLargestDifference(walked, std::vector<RelevoColor>(walked.size())), 0.2);
  const auto drawn = scene.Draw();
  CHECK_CASE(mapper->GetNumberOfDrawnCells());
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, walked), 1.01);
}

void CompareMesh(RelevoCheck& check, vtkDataObject* mesh, double above = 0.75, double below = 0.0)
{
  RelevoVolumeScene scene(mesh, MakeProperty(above, below), Width, Height);
  CompareFrames(check, scene);
}

void TestMeshes(RelevoCheck& check)
{
  const auto tetrahedra = MakeTetrahedra(6, GetWaves);
  CompareMesh(check, tetrahedra);
  CompareMesh(check, tetrahedra, 0.85, 0.15); // two visible regions
  CompareMesh(check, MakeBall(500));
  CompareMesh(check, MakeDiscontinuous(tetrahedra, 0.02), 0.8);
  CompareMesh(check, MakeBlocksOfCells(VTK_HEXAHEDRON, GetSlope, 0.15), 0.6);
  CompareMesh(check, MakeBlocksOfCells(VTK_PYRAMID, GetSlope), 0.6);
  CompareMesh(check, MakeBlocksOfCells(VTK_QUADRATIC_TETRA, GetSlope, 0.04), 0.6);
  RelevoRefinedCells hanging;
  hanging.Levels = 2;
  hanging.Field = GetWaves;
  CompareMesh(check, hanging.Make(VTK_HEXAHEDRON), 0.85);
  // Rays enter the mesh twice.
  vtkNew<vtkAppendFilter> both;
  both->AddInputData(tetrahedra);
  both->AddInputData(MakeTetrahedra(4, GetWaves, 1.5));
  both->Update();
  CompareMesh(check, both->GetOutput());
  vtkNew<vtkPointDataToCellData> cells;
  cells->SetInputData(tetrahedra);
  cells->Update();
  CompareMesh(check, cells->GetOutput());
}

// Clipping planes, opaque props, another number of rays, shading, and the filter.
void TestFeatures(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(6, GetWaves);
  const auto property = MakeProperty(0.75, 0.0);
  RelevoVolumeScene scene(mesh, property, Width, Height);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  CompareFrames(check, scene);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.2, 0.5);
  plane->SetNormal(-0.3, 0.5, -0.8);
  mapper->AddClippingPlane(plane);
  CHECK_LESS_EQUAL(
    scene.Compare(0.0, [&](vtkVolumeRayCastFilter* filter) { filter->AddClippingPlane(plane); }),
    1.0);
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  mapper->RemoveAllClippingPlanes();
  mapper->SetBlendModeToAdditive();
  CHECK_LESS_EQUAL(
    scene.Compare(0.0, [](vtkVolumeRayCastFilter* filter) { filter->SetBlendModeToAdditive(); }),
    1.0);
  CHECK_GREATER(mapper->GetNumberOfSkippedCells(), 0);
  mapper->SetBlendModeToComposite();
  property->ShadeOn();
  CompareFrames(check, scene);
  // A sphere hides a part.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.5, 0.0, 0.3);
  sphere->SetRadius(0.3);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);
  scene.GetRenderer()->AddActor(actor);
  property->SetScalarOpacityUnitDistance(0.31);
  CompareFrames(check, scene);
  mapper->SetImageSampleDistance(2.0);
  property->SetScalarOpacityUnitDistance(0.3);
  CompareFrames(check, scene);
}

// Where rays must walk through the whole mesh.
void TestWalks(RelevoCheck& check)
{
  const auto property = MakeProperty(0.75, 0.0);
  RelevoVolumeScene scene(MakeTetrahedra(6, GetWaves), property, Width, Height);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  CompareFrames(check, scene);
  // An edit makes the other cells visible, and another one all cells transparent.
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->AddPoint(0.0, 0.5);
  scene.Draw();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  CHECK_EQUAL(mapper->GetNumberOfSkippedCells(), 0);
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  scene.Draw();
  const auto nothing = scene.Draw();
  CHECK_EQUAL(FindLargestDifference(nothing, std::vector<RelevoColor>(nothing.size())), 0.0);
  // The camera is inside of the mesh.
  scene.GetVolume()->SetProperty(MakeProperty(0.75, 0.0));
  scene.GetCamera()->SetPosition(0.52, 0.47, 0.55);
  scene.GetCamera()->SetFocalPoint(0.5, 0.0, 0.3);
  scene.GetCamera()->SetClippingRange(0.01, 5.0);
  scene.Draw();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  CHECK_EQUAL(mapper->GetNumberOfSkippedCells(), 0);
}
}

int TestGPUUnstructuredGridVolumeMapperTransparent(int, char*[])
{
  RelevoCheck check;
  TestMeshes(check);
  TestFeatures(check);
  TestWalks(check);
  return check.GetResult();
}
