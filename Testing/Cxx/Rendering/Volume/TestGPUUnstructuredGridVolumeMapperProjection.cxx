// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: cell projection equals vtkVolumeRayCastFilter.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
void TestViews(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  scene.GetMapper()->SetMethodToCellProjection();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  vtkCamera* camera = scene.GetCamera();
  camera->ParallelProjectionOn();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  camera->ParallelProjectionOff();
  // The camera is inside the mesh and looks out.
  camera->SetPosition(0.2, 0.1, 0.0);
  camera->SetFocalPoint(1.0, 0.5, 0.1);
  camera->SetViewAngle(70.0);
  camera->SetClippingRange(0.01, 10.0);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  // The near and far planes clip the volume.
  camera->SetPosition(3.0, 1.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(40.0);
  camera->SetClippingRange(2.9, 3.3);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
}

// Rays within faces, along edges and through corners belong to cells of one side.
void TestDegenerateRays(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(6, GetWaves), MakeBusyProperty(0.3), 97, 97);
  LookAlongEdges(scene);
  const auto cast = scene.Draw();
  scene.GetMapper()->SetMethodToCellProjection();
  const auto projected = scene.Draw();
  // Pixels on the silhouette are skipped: rays may hit or miss the mesh there.
  CHECK_NEAR(255.0 * FindLargestDifferenceInside(projected, cast, 97, 26, 70), 0.0, 1.0);
}

// The mesh is hollow and not convex: cells with centres close to given points are removed.
void TestHoles(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(8, GetWaves);
  vtkUnsignedCharArray* ghosts = mesh->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    mesh->GetCellBounds(i, bounds);
    const auto getDistance = [&](double x, double y, double z)
    {
      return std::hypot(0.5 * (bounds[0] + bounds[1]) - x, 0.5 * (bounds[2] + bounds[3]) - y,
        0.5 * (bounds[4] + bounds[5]) - z);
    };
    const bool isKept = getDistance(0.5, 0.5, 0.5) > 0.3 && getDistance(1.0, 0.6, 1.0) > 0.4;
    ghosts->SetValue(i, isKept ? 0 : vtkDataSetAttributes::HIDDENCELL);
  }
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3));
  scene.GetMapper()->SetMethodToCellProjection();
  for (int i = 0; i < 6; ++i)
  {
    CHECK_LESS_EQUAL(scene.Compare(0.001), 2.0);
    scene.GetCamera()->Azimuth(55.0);
    scene.GetCamera()->Elevation(17.0);
    scene.GetRenderer()->ResetCameraClippingRange();
  }
}

void TestCellScalars(RelevoCheck& check)
{
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(MakeBall(100));
  toCells->Update();
  RelevoVolumeScene scene(toCells->GetOutput(), MakeBusyProperty(0.3));
  scene.GetMapper()->SetMethodToCellProjection();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
}

void TestComponents(RelevoCheck& check)
{
  const auto mesh = MakeBall(100);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    values->InsertNextTuple4(0.5 + 0.5 * x[0], 0.5 + 0.5 * x[1], 0.5 + 0.5 * x[2], x[0] * x[0]);
  }
  mesh->GetPointData()->SetScalars(values);
  const auto property = MakeBusyProperty(0.3);
  property->IndependentComponentsOff();
  RelevoVolumeScene scene(mesh, property);
  scene.GetMapper()->SetMethodToCellProjection();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
}

// Cells with plane faces and a linear field, which splitting does not change.
void TestSplitCells(RelevoCheck& check)
{
  vtkNew<vtkUnstructuredGrid> mesh;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < 27; ++i)
  {
    const RelevoPoint at = { { 0.5 * (i % 3), 0.5 * (i / 3 % 3), 0.5 * (i / 9) } };
    points->InsertNextPoint(at.data());
    values->InsertNextValue(GetLinearField(at));
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(values);
  for (int i = 0; i < 8; ++i)
  {
    const vtkIdType low = i % 2 + 3 * (i / 2 % 2) + 9 * (i / 4);
    const vtkIdType ids[8] = { low, low + 1, low + 4, low + 3, low + 9, low + 10, low + 13,
      low + 12 };
    mesh->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3));
  scene.GetMapper()->SetMethodToCellProjection();
  CHECK_LESS_EQUAL(scene.Compare(0.001), 1.0);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), 8);
}

// Opaque props inside and behind the volume.
void TestOpaqueProps(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(200), MakeBusyProperty(0.3));
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.3, 0.5, -0.4, 0.2, -0.3, 0.4);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.GetRenderer()->AddActor(actor);
  scene.GetRenderer()->SetBackground(0.2, 0.4, 0.1);
  const auto cast = scene.Draw();
  scene.GetMapper()->SetMethodToCellProjection();
  CHECK_LESS_EQUAL(FindLargestDifference(cast, scene.Draw()), 1.5 / 255.0);
  // The viewport is a part of the window.
  scene.GetRenderer()->SetViewport(0.3, 0.2, 0.9, 0.7);
  const auto part = scene.Draw();
  scene.GetMapper()->SetMethodToRayCasting();
  CHECK_LESS_EQUAL(FindLargestDifference(part, scene.Draw()), 1.5 / 255.0);
}

// Exactly the invisible cells are skipped.
void TestTransparentCells(RelevoCheck& check)
{
  const auto property = MakeVolumeProperty(0.0, 1.0, 0.2);
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  for (double low : { 0.3, 0.45 })
  {
    CHECK_CASE(low);
    opacity->RemoveAllPoints();
    opacity->AddPoint(low, 0.0);
    opacity->AddPoint(low + 0.1, 1.0);
    opacity->AddPoint(low + 0.2, 0.0);
    RelevoVolumeScene scene(MakeBall(200), property);
    scene.GetMapper()->SetMethodToCellProjection();
    CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  }
}

// These parts absorb nearly all light within a small share of their length.
void TestOpaqueParts(RelevoCheck& check)
{
  for (double unit : { 1e-2, 1e-4, 1e-9 })
  {
    CHECK_CASE(unit);
    RelevoVolumeScene scene(MakeBall(100), MakeBusyProperty(unit));
    scene.GetMapper()->SetMethodToCellProjection();
    CHECK_LESS_EQUAL(scene.Compare(0.001), 2.0);
  }
}

void TestClippingPlanes(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(200), MakeBusyProperty(0.3));
  const auto whole = scene.Draw();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.0, 0.0);
  plane->SetNormal(0.3, -0.2, 0.8);
  scene.GetMapper()->AddClippingPlane(plane);
  const auto cast = scene.Draw();
  scene.GetMapper()->SetMethodToCellProjection();
  const auto projected = scene.Draw();
  CHECK_LESS_EQUAL(FindLargestDifference(cast, projected), 1.5 / 255.0);
  CHECK_GREATER(FindLargestDifference(whole, projected), 0.1);
}

void TestIntegration(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(200), MakeVolumeProperty(0.0, 1.0, 0.3));
  scene.GetMapper()->SetTableSize(64);
  for (int integration : { 1, 2 })
  {
    CHECK_CASE(integration);
    scene.GetMapper()->SetIntegration(integration);
    scene.GetMapper()->SetMethodToRayCasting();
    const auto cast = scene.Draw();
    scene.GetMapper()->SetMethodToCellProjection();
    CHECK_LESS_EQUAL(FindLargestDifference(cast, scene.Draw()), 1.5 / 255.0);
  }
}

void TestCounters(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(4, GetWaves);
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3));
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  scene.Draw();
  const vtkTypeInt64 memory = mapper->GetGraphicsMemorySize();
  mapper->SetMethodToCellProjection();
  scene.Draw();
  const vtkIdType cells = mesh->GetNumberOfCells();
  CHECK_EQUAL(mapper->GetGraphicsMemorySize() - memory, 20 * cells);
  CHECK_EQUAL(mapper->GetNumberOfDrawnCells(), cells);
  const vtkIdType buffers = mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  scene.GetCamera()->Azimuth(20.0);
  scene.Draw();
  scene.GetWindow()->SetSize(90, 80);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  scene.GetVolume()->GetProperty()->GetScalarOpacity()->AddPoint(0.5, 1.0);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), buffers);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 0);
}

void TestBadMethod(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(2, GetWaves), MakeBusyProperty(0.3));
  RelevoErrors errors(scene.GetMapper());
  scene.GetMapper()->SetMethod(2);
  CHECK(errors.Said("Method must be one of RAY_CASTING (0), CELL_PROJECTION (1), got 2."));
  CHECK_EQUAL(scene.GetMapper()->GetMethod(), 0);
}

// In a perspective view along an axis, the rays of the middle column and row are in faces of cells.
void TestRaysInFaces(RelevoCheck& check)
{
  constexpr int size = 61;
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK_CASE(axis);
    RelevoVolumeScene scene(
      MakeTetrahedra(4, GetLinearField), MakeVolumeProperty(0.5, 1.0, 1.0), size, size);
    scene.GetMapper()->SetMethodToCellProjection();
    double position[3] = { 0.5, 0.5, 0.5 };
    position[axis] = 4.5;
    double up[3] = { 0.0, 0.0, 0.0 };
    up[(axis + 1) % 3] = 1.0;
    scene.GetCamera()->SetFocalPoint(0.5, 0.5, 0.5);
    scene.GetCamera()->SetPosition(position);
    scene.GetCamera()->SetViewUp(up);
    scene.GetCamera()->SetViewAngle(20.0);
    scene.GetRenderer()->ResetCameraClippingRange();
    CHECK_NEAR(scene.Compare(0.004), 0.0, 1.0);
  }
}
}

int TestGPUUnstructuredGridVolumeMapperProjection(int, char*[])
{
  RelevoCheck check;
  TestViews(check);
  TestDegenerateRays(check);
  TestHoles(check);
  TestCellScalars(check);
  TestComponents(check);
  TestSplitCells(check);
  TestOpaqueProps(check);
  TestTransparentCells(check);
  TestOpaqueParts(check);
  TestClippingPlanes(check);
  TestIntegration(check);
  TestCounters(check);
  TestBadMethod(check);
  TestRaysInFaces(check);
  return check.GetResult();
}
