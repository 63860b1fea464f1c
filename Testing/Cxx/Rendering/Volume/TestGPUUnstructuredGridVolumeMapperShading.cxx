// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on shading: with a headlight it equals vtkVolumeRayCastFilter; other lights are
// tested on a field with a constant gradient.
#include "RelevoBusyVolumes.h"
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkContourValues.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace
{
void SetMaterial(vtkVolumeProperty* property, int component, double ambient, double diffuse,
  double specular, double power)
{
  property->ShadeOn(component);
  property->SetAmbient(component, ambient);
  property->SetDiffuse(component, diffuse);
  property->SetSpecular(component, specular);
  property->SetSpecularPower(component, power);
}

vtkSmartPointer<vtkVolumeProperty> MakeShadedProperty(int components = 1)
{
  auto property = MakeBusyProperty(0.3, components);
  SetMaterial(property, 0, 0.2, 0.6, 0.3, 6.0);
  property->GetIsoSurfaceValues()->SetNumberOfContours(2);
  property->GetIsoSurfaceValues()->SetValue(0, 0.45);
  property->GetIsoSurfaceValues()->SetValue(1, 0.7);
  return property;
}

double CompareSurfaces(RelevoVolumeScene& scene, int mode, double share)
{
  scene.GetMapper()->SetBlendMode(mode);
  scene.GetMapper()->IsoSurfacesOn();
  return scene.Compare(share,
    [=](vtkVolumeRayCastFilter* filter)
    {
      filter->SetBlendMode(mode);
      filter->IsoSurfacesOn();
    });
}

void TestHeadlight(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeShadedProperty());
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  const auto shaded = scene.Draw();
  CHECK_NEAR(CompareSurfaces(scene, 0, 0.0002), 0.0, 1.0);
  CHECK_NEAR(CompareSurfaces(scene, 5, 0.0002), 0.0, 1.0);
  scene.GetMapper()->SetBlendModeToComposite();
  scene.GetMapper()->IsoSurfacesOff();
  // Other modes are not shaded.
  for (int mode = 1; mode <= 4; ++mode)
  {
    scene.GetMapper()->SetBlendMode(mode);
    CHECK_NEAR(
      scene.Compare(0.0, [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); }), 0.0,
      1.0);
  }
  scene.GetMapper()->SetBlendModeToComposite();
  scene.GetVolume()->GetProperty()->ShadeOff();
  CHECK_GREATER(FindLargestDifference(shaded, scene.Draw()), 0.2);
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), 1);
}

// Views from inside, parallel projections, and planes that cut cells.
void TestViews(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeBall(300), MakeShadedProperty());
  vtkCamera* camera = scene.GetCamera();
  camera->ParallelProjectionOn();
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  camera->ParallelProjectionOff();
  camera->SetClippingRange(2.9, 3.3);
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  camera->SetPosition(0.2, 0.1, 0.0);
  camera->SetFocalPoint(1.0, 0.5, 0.1);
  camera->SetViewAngle(70.0);
  camera->SetClippingRange(0.01, 10.0);
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
}

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
      const auto property = MakeShadedProperty(components);
      property->SetIndependentComponents(areIndependent);
      SetMaterial(property, components - 1, 0.1, 0.9, 0.5, 20.0);
      property->SetComponentWeight(1, 0.5);
      RelevoVolumeScene scene(mesh, property, 100, 80);
      CHECK_NEAR(scene.Compare(), 0.0, 1.0);
      CHECK_NEAR(CompareSurfaces(scene, 0, 0.0005), 0.0, 1.0);
    }
  }
}

// The lit colour of the first surface that a ray hits in a linear field, whose normal is the
// gradient.
struct LitPlane
{
  RelevoPoint Normal;
  RelevoColor Color; // colour of the surface

  RelevoColor Light(const RelevoPoint& toLight, const RelevoPoint& toEye, const double diffuse[3],
    const double specular[3]) const
  {
    const double facing = vtkMath::Dot(this->Normal.data(), toLight.data());
    double glance = 0.0;
    for (size_t c = 0; c < 3; ++c)
    {
      glance += (2.0 * facing * this->Normal[c] - toLight[c]) * toEye[c];
    }
    const double shine = glance > 0.0 ? std::pow(glance, 6.0) : 0.0;
    RelevoColor color = {};
    for (size_t c = 0; c < 3; ++c)
    {
      color[c] = std::min(1.0,
        this->Color[c] * (0.2 + 0.6 * std::abs(facing) * diffuse[c]) + 0.3 * shine * specular[c]);
    }
    return color;
  }
};

// An opaque isosurface of a linear field under a coloured scene light, far away or close.
void TestSceneLights(RelevoCheck& check)
{
  const auto property = MakeVolumeProperty(1.0, 1.0);
  SetMaterial(property, 0, 0.2, 0.6, 0.3, 6.0);
  property->GetIsoSurfaceValues()->SetValue(0, 0.5);
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), property, 60, 50);
  scene.GetMapper()->SetBlendModeToIsoSurface();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(1.5, 2.0, 0.5);
  light->SetFocalPoint(0.5, 0.5, 0.5);
  light->SetDiffuseColor(1.0, 0.5, 0.2);
  light->SetSpecularColor(0.1, 0.7, 1.0);
  light->SetIntensity(0.8);
  scene.GetRenderer()->AddLight(light);
  vtkNew<vtkLight> off;
  off->SwitchOff();
  scene.GetRenderer()->AddLight(off);
  const double size = std::sqrt(0.04 + 0.09 + 0.25);
  const LitPlane plane = { { { 0.2 / size, 0.3 / size, 0.5 / size } }, { { 0.5, 0.0, 0.5, 1.0 } } };
  const double diffuse[3] = { 0.8, 0.4, 0.16 };
  const double specular[3] = { 0.08, 0.56, 0.8 };
  for (bool isPositional : { false, true })
  {
    CHECK_CASE(isPositional);
    light->SetPositional(isPositional);
    const auto drawn = scene.Draw();
    std::vector<RelevoColor> expected;
    for (int i = 0; i < 60 * 50; ++i)
    {
      const RelevoRay ray(scene.GetCamera(), i % 60, i / 60, 60, 50);
      double begin;
      double end;
      RelevoColor color = {};
      if (ray.CutBox(0.0, 1.0, begin, end))
      {
        const double a = GetLinearField(ray.At(begin));
        const double b = GetLinearField(ray.At(end));
        const RelevoPoint at = ray.At(begin + (0.5 - a) / (b - a) * (end - begin));
        RelevoPoint toLight = { { 1.0, 1.5, 0.0 } };
        RelevoPoint toEye;
        for (size_t c = 0; c < 3; ++c)
        {
          toLight[c] = isPositional ? light->GetPosition()[c] - at[c] : toLight[c];
          toEye[c] = -ray.Direction[c];
        }
        vtkMath::Normalize(toLight.data());
        if ((a < 0.5) != (b < 0.5))
        {
          color = plane.Light(toLight, toEye, diffuse, specular);
        }
      }
      expected.push_back(color);
    }
    CHECK_NEAR(RelevoVolumeScene::Compare(drawn, expected, 0.002), 0.0, 1.0);
  }
  // Without lights only ambient colour remains.
  light->SwitchOff();
  scene.GetRenderer()->AutomaticLightCreationOff();
  double most = 0.0;
  for (const RelevoColor& color : scene.Draw())
  {
    most = std::max(most, color[0]);
  }
  CHECK_NEAR(255.0 * most, 255.0 * 0.1, 1.0);
}

// Normals of a volume that a matrix stretches.
void TestMatrix(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(3, GetLinearField);
  const auto property = MakeVolumeProperty(0.2, 1.0, 0.3);
  SetMaterial(property, 0, 0.1, 0.8, 0.4, 10.0);
  RelevoVolumeScene scene(mesh, property);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2.0);
  matrix->SetElement(1, 2, 0.7);
  matrix->SetElement(0, 3, 5.0);
  scene.GetVolume()->SetUserMatrix(matrix);
  scene.GetRenderer()->ResetCamera();
  const auto drawn = scene.Draw();
  const auto moved = MakeTetrahedra(3, GetLinearField);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    moved->GetPoint(i, x);
    matrix->MultiplyPoint(x, x);
    moved->GetPoints()->SetPoint(i, x);
  }
  CHECK_NEAR(RelevoVolumeScene::Compare(drawn, Cast(moved, property, scene.GetCamera(), 160, 120)),
    0.0, 1.0);
}

// Coordinates lie far from the origin.
void TestFar(RelevoCheck& check)
{
  const auto property = MakeShadedProperty();
  vtkNew<vtkPiecewiseFunction> gradientOpacity;
  gradientOpacity->AddPoint(0.3, 0.0);
  gradientOpacity->AddPoint(1.5, 1.0);
  property->SetGradientOpacity(gradientOpacity);
  RelevoVolumeScene near(MakeBall(200), property);
  RelevoVolumeScene far(MakeBall(200, 1e7), property);
  CHECK_NEAR(255.0 * FindLargestDifference(near.Draw(), far.Draw()), 0.0, 1.5);
}
}

int TestGPUUnstructuredGridVolumeMapperShading(int, char*[])
{
  RelevoCheck check;
  RelevoVolumeScene::ForBothMethods(
    [&]
    {
      TestHeadlight(check);
      TestViews(check);
      TestComponents(check);
      TestSceneLights(check);
      TestMatrix(check);
      TestFar(check);
    });
  return check.GetResult();
}
