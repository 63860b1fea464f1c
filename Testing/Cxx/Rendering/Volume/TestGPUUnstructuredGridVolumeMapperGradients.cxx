// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: gradient opacity and 2D transfer functions equal those of
// vtkVolumeRayCastFilter with both methods; other tests compare that filter with known gradients.
#include "RelevoBusyVolumes.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumeScene.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPoints.h"

#include <cmath>

namespace
{
constexpr int NumberOfModes = 6;

double CompareMode(RelevoVolumeScene& scene, int mode, double share = 0.0)
{
  scene.GetMapper()->SetBlendMode(mode);
  return scene.Compare(share, [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); });
}

vtkSmartPointer<vtkPiecewiseFunction> MakeRamp(double low)
{
  auto ramp = vtkSmartPointer<vtkPiecewiseFunction>::New();
  ramp->AddPoint(0.3, low);
  ramp->AddPoint(1.0, 1.0);
  ramp->AddPoint(1.5, 0.4);
  return ramp;
}

// A table for 12 scalars and this many gradient lengths.
vtkSmartPointer<vtkImageData> MakeTable(int rows, int seed)
{
  RelevoDice dice(seed);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(-0.05, 0.25, 0.0);
  image->SetSpacing(0.1, 0.4, 1.0);
  image->SetDimensions(12, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  for (int i = 0; i < 12 * rows * 4; ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i / 4, i % 4, dice.Share());
  }
  return image;
}

void SetTables(vtkVolumeProperty* property, int components)
{
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  for (int i = 0; i < components; ++i)
  {
    property->SetTransferFunction2D(i, MakeTable(i == 1 ? 1 : 5, i + 3));
  }
}

void TestGradientOpacity(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  const auto before = scene.Draw();
  scene.GetVolume()->GetProperty()->SetGradientOpacity(MakeRamp(0.0));
  CHECK_NEAR(CompareMode(scene, 0), 0.0, 1.0);
  CHECK_GREATER(FindLargestDifference(before, scene.Draw()), 0.2);
  CHECK_NEAR(CompareMode(scene, 4), 0.0, 1.0);
  // It has no effect in modes that map a single scalar.
  CHECK_NEAR(CompareMode(scene, 1), 0.0, 1.0);
  CHECK_NEAR(CompareMode(scene, 3), 0.0, 1.0);
  scene.GetVolume()->GetProperty()->DisableGradientOpacityOn();
  scene.GetMapper()->SetBlendModeToComposite();
  CHECK_EQUAL(FindLargestDifference(before, scene.Draw()), 0.0);
}

// The gradient is constant, so opacities equal those of another unit distance.
void TestLinearField(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeVolumeProperty(0.1, 0.9, 0.3));
  vtkVolumeProperty* property = scene.GetVolume()->GetProperty();
  property->SetGradientOpacity(MakeRamp(0.1));
  const auto drawn = scene.Draw();
  property->SetDisableGradientOpacity(1);
  const double factor = MakeRamp(0.1)->GetValue(std::sqrt(0.04 + 0.09 + 0.25));
  property->SetScalarOpacityUnitDistance(0.3 / factor);
  CHECK_NEAR(255.0 * FindLargestDifference(drawn, scene.Draw()), 0.0, 1.0);
}

// Gradients are measured in world units, even if the volume is stretched.
void TestMatrix(RelevoCheck& check)
{
  const auto mesh = MakeBall(200);
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3));
  scene.GetVolume()->GetProperty()->SetGradientOpacity(MakeRamp(0.0));
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2.0);
  matrix->SetElement(1, 2, 0.7);
  matrix->SetElement(0, 3, 5.0);
  scene.GetVolume()->SetUserMatrix(matrix);
  scene.GetRenderer()->ResetCamera();
  const auto drawn = scene.Draw();
  const auto moved = MakeBall(200);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    moved->GetPoint(i, x);
    matrix->MultiplyPoint(x, x);
    moved->GetPoints()->SetPoint(i, x);
  }
  CHECK_NEAR(RelevoVolumeScene::Compare(
               drawn, Cast(moved, scene.GetVolume()->GetProperty(), scene.GetCamera(), 160, 120)),
    0.0, 1.0);
}

void TestTables(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeBusyProperty(0.3));
  vtkVolumeProperty* property = scene.GetVolume()->GetProperty();
  property->GetIsoSurfaceValues()->SetValue(0, 0.45);
  SetTables(property, 1);
  for (int mode = 0; mode < NumberOfModes; ++mode)
  {
    CHECK_NEAR(CompareMode(scene, mode, mode == 5 ? 0.0002 : 0.0), 0.0, 1.0);
  }
  scene.GetMapper()->SetBlendModeToComposite();
  scene.GetMapper()->IsoSurfacesOn();
  CHECK_NEAR(scene.Compare(0.0002, [](vtkVolumeRayCastFilter* filter) { filter->IsoSurfacesOn(); }),
    0.0, 1.0);
  // An edit of one texel takes effect.
  scene.GetMapper()->IsoSurfacesOff();
  vtkImageData* image = property->GetTransferFunction2D();
  for (int c = 0; c < 4; ++c)
  {
    image->GetPointData()->GetScalars()->SetComponent(18, c, 1.0);
  }
  image->GetPointData()->GetScalars()->Modified();
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
}

// Several components, dependent or not, with gradient opacity, which has no effect on cell scalars.
void TestComponents(RelevoCheck& check)
{
  const auto mesh = MakeBall(200);
  for (int components = 2; components <= 4; ++components)
  {
    mesh->GetPointData()->SetScalars(MakeBusyArray(mesh, components));
    for (bool areIndependent : { true, false })
    {
      CHECK_CASE(areIndependent);
      if (!areIndependent && components == 3)
      {
        continue;
      }
      RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3, components), 100, 80);
      vtkVolumeProperty* property = scene.GetVolume()->GetProperty();
      property->SetIndependentComponents(areIndependent);
      property->SetGradientOpacity(0, MakeRamp(0.2));
      property->SetGradientOpacity(components - 1, MakeRamp(0.0));
      CHECK_NEAR(CompareMode(scene, 0), 0.0, 1.0);
      SetTables(property, components);
      CHECK_NEAR(CompareMode(scene, 0), 0.0, 1.0);
      CHECK_NEAR(CompareMode(scene, 2), 0.0, 1.0);
    }
  }
  mesh->GetPointData()->SetScalars(MakeBusyArray(mesh, 2));
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(mesh);
  toCells->Update();
  RelevoVolumeScene scene(toCells->GetOutput(), MakeBusyProperty(0.3, 2), 100, 80);
  scene.GetVolume()->GetProperty()->SetGradientOpacity(1, MakeRamp(0.2));
  CHECK_NEAR(CompareMode(scene, 0), 0.0, 1.0);
  SetTables(scene.GetVolume()->GetProperty(), 2);
  CHECK_NEAR(CompareMode(scene, 0), 0.0, 1.0);
}
}

int TestGPUUnstructuredGridVolumeMapperGradients(int, char*[])
{
  RelevoCheck check;
  RelevoVolumeScene::ForBothMethods(
    [&]
    {
      TestGradientOpacity(check);
      TestLinearField(check);
      TestMatrix(check);
      TestTables(check);
      TestComponents(check);
    });
  return check.GetResult();
}
