// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random combinations of features equal vtkVolumeRayCastFilter with both methods.
#include "RelevoBusyVolumes.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumeScene.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"

#include <iostream>

namespace
{
// The last seed has extremes in faces that the near plane cuts.
constexpr int Seeds[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 71 };

vtkSmartPointer<vtkDataObject> MakeMesh(RelevoDice& dice, int components)
{
  const auto ball = MakeBall(60 + dice.Throw(200));
  ball->GetPointData()->SetScalars(MakeBusyArray(ball, components));
  if (dice.Once(5))
  {
    vtkNew<vtkPointDataToCellData> toCells;
    toCells->SetInputData(ball);
    toCells->Update();
    return toCells->GetOutput();
  }
  if (dice.Once(4))
  {
    // The blocks lie next to each other.
    const auto cube = MakeTetrahedra(3, GetWaves, 0.62);
    cube->GetPointData()->SetScalars(MakeBusyArray(cube, components));
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, ball);
    blocks->SetBlock(1, cube);
    return blocks;
  }
  return ball;
}

vtkSmartPointer<vtkImageData> MakeTable(RelevoDice& dice)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(-0.05, 0.2, 0.0);
  image->SetSpacing(0.1, 0.3, 1.0);
  image->SetDimensions(1 + dice.Throw(12), 1 + dice.Throw(5), 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  for (vtkIdType i = 0; i < 4 * image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i / 4, static_cast<int>(i % 4), dice.Share());
  }
  return image;
}

void SetComponent(RelevoDice& dice, vtkVolumeProperty* property, int component)
{
  property->SetComponentWeight(component, dice.Share());
  if (dice.Once(3))
  {
    property->ShadeOn(component);
    property->SetAmbient(component, dice.Share());
    property->SetDiffuse(component, dice.Share());
    property->SetSpecular(component, dice.Share());
    property->SetSpecularPower(component, 1.0 + 20.0 * dice.Share());
  }
  if (dice.Once(4))
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i < 4; ++i)
    {
      opacity->AddPoint(0.7 * i * dice.Share(), dice.Share());
    }
    property->SetGradientOpacity(component, opacity);
  }
  property->SetTransferFunction2D(component, MakeTable(dice));
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty(RelevoDice& dice, int components)
{
  const auto property = MakeBusyProperty(0.1 + dice.Share(), components);
  property->SetIndependentComponents(components == 3 || dice.Once(2));
  property->SetTransferFunctionMode(
    dice.Once(4) ? vtkVolumeProperty::TF_2D : vtkVolumeProperty::TF_1D);
  for (int i = 0; i < components; ++i)
  {
    SetComponent(dice, property, i);
  }
  const int values = dice.Throw(4);
  property->GetIsoSurfaceValues()->SetNumberOfContours(values);
  for (int i = 0; i < values; ++i)
  {
    property->GetIsoSurfaceValues()->SetValue(i, dice.Share());
  }
  return property;
}

void SetView(RelevoDice& dice, RelevoVolumeScene& scene)
{
  vtkCamera* camera = scene.GetCamera();
  camera->Azimuth(360.0 * dice.Share());
  camera->Elevation(60.0 * dice.Signed());
  camera->SetParallelProjection(dice.Once(3));
  scene.GetRenderer()->ResetCameraClippingRange();
  if (dice.Once(3))
  {
    camera->ParallelProjectionOff();
    camera->SetPosition(0.5 * dice.Signed(), 0.5 * dice.Signed(), 0.5 * dice.Signed());
    camera->SetViewAngle(70.0);
    camera->SetClippingRange(0.01, 10.0);
  }
  for (int i = dice.Throw(3); i > 0; --i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.3 * dice.Signed(), 0.3 * dice.Signed(), 0.3 * dice.Signed());
    plane->SetNormal(dice.Signed(), dice.Signed(), dice.Signed());
    scene.GetMapper()->AddClippingPlane(plane);
  }
}

void TestScene(RelevoCheck& check, int seed)
{
  RelevoDice dice(seed);
  const int components = 1 + dice.Throw(4);
  const auto mesh = MakeMesh(dice, components);
  RelevoVolumeScene scene(mesh, MakeProperty(dice, components), 80, 60);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  SetView(dice, scene);
  mapper->SetBlendMode(dice.Throw(6));
  mapper->SetIsoSurfaces(dice.Once(2));
  // A ray that grazes a surface may hit it twice or not at all.
  const double apart = scene.Compare(0.003,
    [=](vtkVolumeRayCastFilter* filter)
    {
      filter->SetBlendMode(mapper->GetBlendMode());
      filter->SetIsoSurfaces(mapper->GetIsoSurfaces());
      filter->SetClippingPlanes(mapper->GetClippingPlanes());
    });
  CHECK_NEAR(apart, 0.0, 1.0);
  if (!(apart <= 1.0))
  {
    std::cerr << "in the scene with seed " << seed << "\n";
  }
}
}

int TestGPUUnstructuredGridVolumeMapperRandom(int, char*[])
{
  RelevoCheck check;
  RelevoVolumeScene::ForBothMethods(
    [&]
    {
      for (int seed : Seeds)
      {
        TestScene(check, seed);
      }
    });
  return check.GetResult();
}
