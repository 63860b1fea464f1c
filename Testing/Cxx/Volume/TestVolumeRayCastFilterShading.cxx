// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises volumes and isosurfaces shaded by a light at the camera. The
// references are sums along rays through fields with known gradients.
#include "RelevoCheck.h"
#include "RelevoRaySum.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Size = 15;
constexpr double Unit = 0.5;
using VectorField = std::function<RelevoPoint(const RelevoPoint&)>;

RelevoPoint GetLinearGradient(const RelevoPoint&)
{
  return { { 0.2, 0.3, 0.5 } };
}

struct Scene
{
  explicit Scene(vtkDataObject* mesh)
  {
    this->Filter->SetInputDataObject(mesh);
    this->Filter->SetVolumeProperty(this->Property);
    this->Filter->SetViewportSize(Size, Size);
    this->Camera = MakeCamera({ { 2.2, 0.6, 0.7 } }, { { 0.5, 0.5, 0.5 } });
    this->Filter->SetCamera(this->Camera);
    this->SetMaterial(0, 0.2, 0.6, 0.3, 6.0);
  }
  void SetMaterial(int component, double ambient, double diffuse, double specular, double power)
  {
    this->Property->ShadeOn(component);
    this->Property->SetAmbient(component, ambient);
    this->Property->SetDiffuse(component, diffuse);
    this->Property->SetSpecular(component, specular);
    this->Property->SetSpecularPower(component, power);
  }
  double Differs(const RelevoRaySum& sum)
  {
    return FindLargestDifference(Cast(this->Filter),
      MakePicture(
        this->Camera, Size, Size, [&](const RelevoRay& ray) { return sum.Composite(ray); }));
  }
  // The light points where the camera looks. The specular term uses the angle between the eye and
  // the mirrored light.
  RelevoColor Shade(
    RelevoColor color, const RelevoRay& ray, RelevoPoint gradient, int component = 0)
  {
    double light[3];
    this->Camera->GetDirectionOfProjection(light);
    vtkMath::Normalize(gradient.data());
    const double facing = vtkMath::Dot(light, gradient.data());
    double mirrored[3];
    for (int c = 0; c < 3; ++c)
    {
      mirrored[c] = light[c] - 2.0 * facing * gradient[c];
    }
    const double angle =
      vtkMath::Pi() - vtkMath::AngleBetweenVectors(mirrored, ray.Direction.data());
    const double glare = angle < 0.5 * vtkMath::Pi()
      ? std::pow(std::cos(angle), this->Property->GetSpecularPower(component))
      : 0.0;
    for (int c = 0; c < 3; ++c)
    {
      color[c] = color[c] *
          (this->Property->GetAmbient(component) +
            this->Property->GetDiffuse(component) * std::abs(facing)) +
        this->Property->GetSpecular(component) * glare;
      color[c] = std::min(color[c], 1.0);
    }
    return color;
  }
  RelevoRaySum MakeSum(const RelevoField& field, const VectorField& gradient)
  {
    RelevoRaySum sum;
    sum.Scalar = field;
    sum.Optics = [=](const RelevoRay& ray, const RelevoPoint& p)
    {
      RelevoColor color = this->Shade(MapScalar(this->Property, field(p)), ray, gradient(p));
      color[3] /= Unit;
      return color;
    };
    sum.Surface = [=](const RelevoRay& ray, const RelevoPoint& p)
    { return this->Shade(MapScalar(this->Property, field(p)), ray, gradient(p)); };
    return sum;
  }

  vtkNew<vtkVolumeRayCastFilter> Filter;
  vtkSmartPointer<vtkVolumeProperty> Property = MakeVolumeProperty(0.2, 1.0, Unit);
  vtkSmartPointer<vtkCamera> Camera;
};

// A constant normal, seen from both sides, in parallel projection and with strong light.
void TestPlanes(RelevoCheck& check)
{
  Scene scene(MakeTetrahedra(3, GetLinearField));
  const RelevoRaySum sum = scene.MakeSum(GetLinearField, GetLinearGradient);
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-6);
  scene.Camera->SetPosition(-1.2, -0.2, -0.4);
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-6);
  scene.Camera->ParallelProjectionOn();
  scene.Camera->SetParallelScale(0.9);
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-6);
  scene.SetMaterial(0, 1e6, 0.9, 0.9, 1.0); // clamps colours to 1
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-4);
  scene.SetMaterial(0, 0.2, 0.6, 0.3, 6.0);
  scene.Property->ShadeOff();
  CHECK_GREATER(scene.Differs(sum), 0.1);
}

void TestIsoSurfaces(RelevoCheck& check)
{
  Scene scene(MakeTetrahedra(3, GetLinearField));
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.3);
  scene.Property->GetIsoSurfaceValues()->SetValue(1, 0.65);
  RelevoRaySum sum = scene.MakeSum(GetLinearField, GetLinearGradient);
  sum.Values = { 0.3, 0.65 };
  scene.Filter->IsoSurfacesOn();
  CHECK_NEAR(scene.Differs(sum), 0.0, 5e-4);
  scene.Filter->SetBlendModeToIsoSurface();
  sum.Optics = nullptr;
  CHECK_NEAR(scene.Differs(sum), 0.0, 5e-4);
  sum.Values = { 0.3 };
  CHECK_GREATER(scene.Differs(sum), 0.1);
}

// Normals interpolated from points converge as the mesh gets finer.
void TestSpheres(RelevoCheck& check)
{
  const auto getField = [](const RelevoPoint& p)
  { return std::hypot(p[0] + 0.5, p[1] + 0.3, p[2] + 0.6) - 0.7; };
  const auto getGradient = [](const RelevoPoint& p) {
    return RelevoPoint{ { p[0] + 0.5, p[1] + 0.3, p[2] + 0.6 } };
  };
  double last = 1.0;
  for (const int n : { 4, 8, 16 })
  {
    CHECK_CASE(n);
    Scene scene(MakeTetrahedra(n, getField));
    const double differs = scene.Differs(scene.MakeSum(getField, getGradient));
    CHECK_LESS(differs, 0.7 * last);
    last = differs;
  }
  CHECK_NEAR(last, 0.0, 5e-3);

  Scene surface(MakeTetrahedra(16, getField));
  surface.Property->GetIsoSurfaceValues()->SetValue(0, 0.5);
  surface.Filter->SetBlendModeToIsoSurface();
  RelevoRaySum sum = surface.MakeSum(getField, getGradient);
  sum.Optics = nullptr;
  sum.Values = { 0.5 };
  surface.Camera->SetViewAngle(15.0); // where rays do not graze the surface
  CHECK_NEAR(surface.Differs(sum), 0.0, 1e-2);
}

// Without a gradient, colours are not shaded.
void TestUnshaded(RelevoCheck& check)
{
  const auto isSame = [](vtkDataObject* mesh)
  {
    Scene scene(mesh);
    const auto shaded = Cast(scene.Filter);
    scene.Property->ShadeOff();
    return FindLargestDifference(Cast(scene.Filter), shaded) < 1e-12;
  };
  CHECK(isSame(MakeTetrahedra(2, [](const RelevoPoint&) { return 0.37; })));
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  CHECK(!isSame(mesh));
  vtkNew<vtkDoubleArray> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(0.1 * (i % 7));
  }
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->SetScalars(ids);
  CHECK(isSame(mesh));
  // Shading has no effect in other blend modes.
  Scene scene(MakeTetrahedra(2, GetLinearField));
  for (const int mode : { 1, 2, 3, 4 })
  {
    CHECK_CASE(mode);
    scene.Filter->SetBlendMode(mode);
    scene.Property->ShadeOn();
    const auto shaded = Cast(scene.Filter);
    scene.Property->ShadeOff();
    CHECK_EQUAL(FindLargestDifference(Cast(scene.Filter), shaded), 0.0);
  }
}

// Each of two independent components has a material and a gradient. For dependent components, the
// gradient is that of the last one.
void TestComponents(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkDoubleArray> two;
  two->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint point;
    mesh->GetPoint(i, point.data());
    two->InsertNextTuple2(0.5, GetLinearField(point));
  }
  mesh->GetPointData()->SetScalars(two);
  Scene scene(mesh);
  scene.Property->GetRGBTransferFunction(1)->RemoveAllPoints();
  scene.Property->GetRGBTransferFunction(1)->AddRGBPoint(0.0, 0.1, 0.9, 0.3);
  scene.Property->GetScalarOpacity(1)->RemoveAllPoints();
  scene.Property->GetScalarOpacity(1)->AddPoint(0.0, 0.7);
  scene.Property->SetScalarOpacityUnitDistance(1, Unit);
  scene.SetMaterial(1, 0.1, 0.4, 0.5, 2.0);
  RelevoRaySum sum;
  sum.Optics = [&](const RelevoRay& ray, const RelevoPoint&)
  {
    const RelevoColor first = MapScalar(scene.Property, 0.5); // has no gradient
    const RelevoColor second =
      scene.Shade({ { 0.1, 0.9, 0.3, 0.7 } }, ray, { { 0.2, 0.3, 0.5 } }, 1);
    RelevoColor both;
    both[3] = (first[3] + second[3]) / Unit;
    for (int c = 0; c < 3; ++c)
    {
      both[c] = (first[c] * first[3] + second[c] * second[3]) / (first[3] + second[3]);
    }
    return both;
  };
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-6);
  scene.Property->ShadeOff(0);
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-6);
  scene.Property->ShadeOn(0);
  scene.Property->IndependentComponentsOff();
  sum.Optics = [&](const RelevoRay& ray, const RelevoPoint& p)
  {
    RelevoColor color = scene.Shade(MapScalar(scene.Property, 0.5), ray, { { 0.2, 0.3, 0.5 } });
    color[3] = MapScalar(scene.Property, GetLinearField(p))[3] / Unit;
    return color;
  };
  CHECK_NEAR(scene.Differs(sum), 0.0, 1e-6);
}
}

int TestVolumeRayCastFilterShading(int, char*[])
{
  RelevoCheck check;
  TestPlanes(check);
  TestIsoSurfaces(check);
  TestSpheres(check);
  TestUnshaded(check);
  TestComponents(check);
  return check.GetResult();
}
