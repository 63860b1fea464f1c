// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that vtkVolumeCellPicker and vtkPropPicker pick volumes, and actors in front of them.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkVolumeCellPicker.h"

#include "vtkActor.h"
#include "vtkCellType.h"
#include "vtkCubeSource.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;

vtkSmartPointer<vtkActor> MakeCube(double low, double high)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(low, high, low, high, low, high);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void TestCellPicker(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetTrilinear, 0.1);
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.9, 0.9, 0.3), Width, Height);
  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 1.0, 1.5);
  transform->RotateZ(20.0);
  scene.GetVolume()->SetUserTransform(transform);
  scene.GetRenderer()->ResetCamera();
  vtkNew<vtkVolumeCellPicker> picker;
  CHECK_EQUAL(picker->Pick(Width / 2, Height / 2, 0.0, scene.GetRenderer()), 1);
  CHECK_EQUAL(picker->GetViewProp(), scene.GetVolume());
  CHECK_EQUAL(picker->GetMapper(), scene.GetMapper());
  CHECK_EQUAL(picker->GetDataSet(), mesh);
  CHECK_EQUAL(picker->GetFlatBlockIndex(), -1);
  vtkNew<vtkGenericCell> cell;
  mesh->GetCell(picker->GetCellId(), cell);
  int subId = 0;
  double there[3];
  double weights[8];
  cell->EvaluateLocation(subId, picker->GetPCoords(), there, weights);
  double mapped[3];
  picker->GetMapperPosition(mapped);
  CHECK_NEAR(vtkMath::Distance2BetweenPoints(there, mapped), 0.0, 1e-18);
  transform->TransformPoint(there, there);
  CHECK_NEAR(vtkMath::Distance2BetweenPoints(there, picker->GetPickPosition()), 0.0, 1e-18);
  CHECK(cell->GetPointIds()->IsId(picker->GetPointId()) >= 0);
  CHECK_NEAR(vtkMath::Norm(picker->GetPickNormal()), 1.0, 1e-9);

  // The opacity behind the position is 0.5.
  const double* eye = scene.GetCamera()->GetPosition();
  const double depth = std::sqrt(vtkMath::Distance2BetweenPoints(eye, picker->GetPickPosition()));
  picker->SetOpacityThreshold(1e-6); // almost at the boundary
  picker->Pick(Width / 2, Height / 2, 0.0, scene.GetRenderer());
  const double begin = std::sqrt(vtkMath::Distance2BetweenPoints(eye, picker->GetPickPosition()));
  CHECK_NEAR(depth - begin, std::log(2.0) * 0.3 / 0.9, 1e-4);
  picker->SetOpacityThreshold(0.5);

  // Actors behind and in front.
  const auto actor = MakeCube(1.4, 1.6);
  actor->SetUserTransform(transform);
  scene.GetRenderer()->AddActor(actor);
  picker->Pick(Width / 2, Height / 2, 0.0, scene.GetRenderer());
  CHECK_EQUAL(picker->GetViewProp(), scene.GetVolume());
  scene.GetVolume()->GetProperty()->SetScalarOpacityUnitDistance(100.0);
  picker->Pick(Width / 2, Height / 2, 0.0, scene.GetRenderer());
  CHECK_EQUAL(picker->GetViewProp(), actor.Get());
  CHECK_EQUAL(picker->Pick(0, 0, 0.0, scene.GetRenderer()), 0);
}

void TestPropPicker(RelevoCheck& check)
{
  RelevoVolumeScene scene(
    MakeTetrahedra(2, GetLinearField), MakeVolumeProperty(1.0, 1.0, 0.1), Width, Height);
  const auto before = scene.Draw();
  vtkNew<vtkPropPicker> picker;
  CHECK_EQUAL(picker->PickProp(Width / 2, Height / 2, scene.GetRenderer()), 1);
  CHECK_EQUAL(picker->GetViewProp(), scene.GetVolume());
  const RelevoRay ray(scene.GetCamera(), Width / 2, Height / 2, Width, Height);
  double begin;
  double end;
  ray.CutBox(0.0, 1.0, begin, end);
  const RelevoPoint expected = ray.At(begin + 0.1 * std::log(2.0));
  // The rays of vtkPropPicker are up to half a pixel aside.
  CHECK_NEAR(
    vtkMath::Distance2BetweenPoints(expected.data(), picker->GetPickPosition()), 0.0, 2e-3);
  CHECK_EQUAL(picker->PickProp(0, 0, scene.GetRenderer()), 0);
  CHECK_EQUAL(FindLargestDifference(before, scene.Draw()), 0.0);

  // Behind an actor, and in front of one.
  const auto actor = MakeCube(0.4, 0.6);
  scene.GetRenderer()->AddActor(actor);
  scene.Draw();
  picker->PickProp(Width / 2, Height / 2, scene.GetRenderer());
  CHECK_EQUAL(picker->GetViewProp(), scene.GetVolume());
  actor->SetScale(8.0);
  actor->SetPosition(-3.5, -3.5, -3.5);
  scene.GetRenderer()->ResetCameraClippingRange();
  scene.Draw();
  picker->PickProp(Width / 2, Height / 2, scene.GetRenderer());
  CHECK_EQUAL(picker->GetViewProp(), actor.Get());
}
}

int TestVolumeCellPicker(int, char*[])
{
  RelevoCheck check;
  TestCellPicker(check);
  TestPropPicker(check);
  return check.GetResult();
}
