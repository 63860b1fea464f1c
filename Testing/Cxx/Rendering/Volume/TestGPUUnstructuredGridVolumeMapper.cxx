// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkGPUUnstructuredGridVolumeMapper promises the pictures of vtkVolumeRayCastFilter, which other
// tests compare with closed forms and sums.
#include "RelevoBusyVolumes.h"
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// The camera is inside the mesh and looks out.
void LookInside(vtkCamera* camera)
{
  camera->SetPosition(0.2, 0.1, 0.0);
  camera->SetFocalPoint(1.0, 0.5, 0.1);
  camera->SetViewAngle(70.0);
  camera->SetClippingRange(0.01, 10.0);
}

void TestViews(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  vtkCamera* camera = scene.GetCamera();
  camera->ParallelProjectionOn();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  camera->ParallelProjectionOff();
  LookInside(camera);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  // The near and far planes clip the volume.
  camera->SetPosition(3.0, 1.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(40.0);
  camera->SetClippingRange(2.9, 3.3);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  // The first frame has no entries of an earlier one.
  RelevoVolumeScene inside(MakeBall(300), MakeBusyProperty(0.3));
  LookInside(inside.GetCamera());
  CHECK_LESS_EQUAL(inside.Compare(), 1.0);
}

// Rays within faces, along edges and through corners.
void TestDegenerateRays(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(6, GetWaves), MakeBusyProperty(0.3), 97, 97);
  LookAlongEdges(scene);
  const auto drawn = scene.Draw();
  const auto cast = scene.Cast();
  // Pixels on the silhouette are skipped: rays may hit or miss the mesh there.
  CHECK_NEAR(255.0 * FindLargestDifferenceInside(drawn, cast, 97, 26, 70), 0.0, 1.0);
}

// Parts that touch with different faces, and parts behind each other.
void TestParts(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeTetrahedra(3, GetWaves));
  blocks->SetBlock(1, MakeTetrahedra(2, GetWaves, 1.0));
  const auto moved = MakeTetrahedra(4, GetWaves);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double x[3];
    moved->GetPoint(i, x);
    moved->GetPoints()->SetPoint(i, x[0] + 1.0, x[1], x[2]);
  }
  blocks->SetBlock(3, moved);
  RelevoVolumeScene scene(blocks, MakeBusyProperty(0.5));
  CHECK_LESS_EQUAL(scene.Compare(0.001), 1.0);
  scene.GetCamera()->Azimuth(100.0);
  scene.GetRenderer()->ResetCameraClippingRange();
  CHECK_LESS_EQUAL(scene.Compare(0.001), 1.0);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), 6 * (27 + 8 + 64));
}

// The same picture far from the origin, and with a matrix that translates, rotates and stretches.
void TestPlaces(RelevoCheck& check)
{
  RelevoVolumeScene near(MakeBall(200), MakeBusyProperty(0.3));
  RelevoVolumeScene far(MakeBall(200, 1e7), MakeBusyProperty(0.3));
  CHECK_LESS_EQUAL(FindLargestDifference(near.Draw(), far.Draw()), 1.5 / 255.0);

  RelevoVolumeScene stretched(MakeBall(200), MakeBusyProperty(0.3));
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2.0);
  matrix->SetElement(1, 2, 0.5);
  matrix->SetElement(0, 3, 5.0);
  stretched.GetVolume()->SetUserMatrix(matrix);
  stretched.GetRenderer()->ResetCamera();
  const auto drawn = stretched.Draw();
  const auto mesh = MakeBall(200);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    mesh->GetPoint(i, x);
    matrix->MultiplyPoint(x, x);
    mesh->GetPoints()->SetPoint(i, x);
  }
  CHECK_NEAR(RelevoVolumeScene::Compare(drawn,
               Cast(mesh, stretched.GetVolume()->GetProperty(), stretched.GetCamera(), 160, 120)),
    0.0, 1.0);
}

// A viewport in the upper right shows the same as a window of that size.
void TestViewports(RelevoCheck& check)
{
  const int size = 60;
  const std::vector<RelevoColor> alone =
    RelevoVolumeScene(MakeBall(100), MakeBusyProperty(0.3), size, size).Draw();
  RelevoVolumeScene scene(MakeBall(100), MakeBusyProperty(0.3), 2 * size, 2 * size);
  scene.GetRenderer()->SetViewport(0.5, 0.5, 1.0, 1.0);
  const std::vector<RelevoColor> beside = scene.Draw();
  double most = 0.0;
  double brightest = 0.0;
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double value = alone[j * size + i][c];
        brightest = std::max(brightest, value);
        most = std::max(most, std::abs(value - beside[(j + size) * 2 * size + i + size][c]));
      }
    }
  }
  CHECK_GREATER(brightest, 0.2);
  CHECK_LESS_EQUAL(255.0 * most, 1.0);
}

void TestOpaqueProps(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(4, GetLinearField), MakeLinearProperty(), 100, 100);
  vtkCamera* camera = scene.GetCamera();
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetPosition(0.5, 0.5, 4.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.6);
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0.25, 0.75, 0.25, 0.75, 0.1, 0.6);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  scene.GetRenderer()->AddActor(actor);
  scene.GetRenderer()->ResetCameraClippingRange();
  const auto drawn = scene.Draw();
  // Over a black background it hides what is behind, like a far plane for the twin.
  const double distance = 4.0 - 0.6;
  vtkNew<vtkCamera> cut;
  cut->DeepCopy(camera);
  cut->SetClippingRange(camera->GetClippingRange()[0], distance);
  const auto cast = Cast(
    scene.GetMapper()->GetInputDataObject(0, 0), scene.GetVolume()->GetProperty(), cut, 100, 100);
  CHECK_NEAR(255.0 * FindLargestDifferenceInside(drawn, cast, 100, 32, 67), 0.0, 1.0);
}
}

int TestGPUUnstructuredGridVolumeMapper(int, char*[])
{
  RelevoCheck check;
  TestViews(check);
  TestDegenerateRays(check);
  TestParts(check);
  TestPlaces(check);
  TestOpaqueProps(check);
  TestViewports(check);
  return check.GetResult();
}
