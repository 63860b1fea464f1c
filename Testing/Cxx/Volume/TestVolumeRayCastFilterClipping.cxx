// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises that clipping planes shorten rays. The reference is the closed
// form for the remaining part.
#include "RelevoCheck.h"
#include "RelevoRaySum.h"

#include "Integral/LinearSegment.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"

#include <cmath>

namespace
{
constexpr int Size = 25;

struct Scene
{
  vtkSmartPointer<vtkCamera> Camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  vtkNew<vtkVolumeRayCastFilter> Filter;
  RelevoRaySum Sum;

  Scene()
  {
    this->Filter->SetInputData(MakeTetrahedra(3, GetLinearField));
    this->Filter->SetVolumeProperty(MakeVolumeProperty(0.7, 0.7));
    this->Filter->SetCamera(this->Camera);
    this->Filter->SetViewportSize(Size, Size);
    this->Filter->SetBlendModeToAverageIntensity();
  }
  // The mean scalar is that at the middle of the ray, so it depends on both ends.
  double Differs()
  {
    const auto property = this->Filter->GetVolumeProperty();
    const auto get = [&](const RelevoRay& ray)
    {
      double begin;
      double end;
      return this->Sum.Cut(ray, begin, end)
        ? Premultiply(MapScalar(property, GetLinearField(ray.At(0.5 * (begin + end)))))
        : RelevoColor();
    };
    return FindLargestDifference(Cast(this->Filter), MakePicture(this->Camera, Size, Size, get));
  }
};

vtkSmartPointer<vtkPlane> MakePlane(double x, double y, double z, const RelevoPoint& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(x, y, z);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  return plane;
}

// Finds the positive side of a plane by bisection, independent of the formula.
void ClipBy(vtkPlane* plane, const RelevoRay& ray, double& begin, double& end)
{
  const auto isIn = [&](double t) { return plane->EvaluateFunction(ray.At(t).data()) >= 0.0; };
  double in = begin;
  double out = end;
  if (!isIn(begin) && !isIn(end))
  {
    end = begin;
    return;
  }
  if (isIn(begin) == isIn(end))
  {
    return;
  }
  const bool isBeginIn = isIn(begin);
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (in + out);
    (isIn(middle) == isBeginIn ? in : out) = middle;
  }
  (isBeginIn ? end : begin) = in;
}

void TestPlanes(RelevoCheck& check)
{
  Scene scene;
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  const auto first = MakePlane(0.4, 0.5, 0.6, { { 1.0, 0.3, -0.2 } });
  const auto second = MakePlane(0.5, 0.5, 0.4, { { 0.0, 0.0, 3.0 } });
  scene.Filter->AddClippingPlane(first);
  CHECK_GREATER(scene.Differs(), 0.05);
  scene.Sum.Clip = [&](const RelevoRay& ray, double& begin, double& end)
  { ClipBy(first, ray, begin, end); };
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  scene.Filter->AddClippingPlane(second);
  scene.Sum.Clip = [&](const RelevoRay& ray, double& begin, double& end)
  {
    ClipBy(first, ray, begin, end);
    ClipBy(second, ray, begin, end);
  };
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  // A change of a plane takes effect.
  second->SetNormal(0.0, 1.0, -0.9);
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  scene.Filter->RemoveClippingPlane(first);
  CHECK_EQUAL(scene.Filter->GetClippingPlanes()->GetNumberOfItems(), 1);
  scene.Sum.Clip = [&](const RelevoRay& ray, double& begin, double& end)
  { ClipBy(second, ray, begin, end); };
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  // The mesh lies on the plane's positive side and is kept, then on its negative side and is
  // removed.
  second->SetOrigin(0.0, -9.0, 9.0);
  second->SetNormal(0.0, 1.0, 0.0);
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  second->SetNormal(0.0, -1.0, 0.0);
  for (const RelevoColor& color : Cast(scene.Filter))
  {
    CHECK_EQUAL(color[3], 0.0);
  }
  scene.Filter->RemoveAllClippingPlanes();
  scene.Sum.Clip = nullptr;
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
}

void TestSetting(RelevoCheck& check)
{
  Scene scene;
  CHECK(!scene.Filter->GetClippingPlanes());
  const auto plane = MakePlane(0.5, 0.5, 0.47, { { 0.0, 0.1, 1.0 } });
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  scene.Filter->SetClippingPlanes(planes);
  CHECK_EQUAL(scene.Filter->GetClippingPlanes(), planes);
  scene.Sum.Clip = [&](const RelevoRay& ray, double& begin, double& end)
  { ClipBy(plane, ray, begin, end); };
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  const vtkMTimeType before = scene.Filter->GetMTime();
  plane->SetOrigin(0.5, 0.5, 0.7);
  CHECK_GREATER(scene.Filter->GetMTime(), before);
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  scene.Filter->SetClippingPlanes(static_cast<vtkPlaneCollection*>(nullptr));
  scene.Sum.Clip = nullptr;
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);

  // Planes that are positive on the outside.
  vtkNew<vtkPlanes> box;
  vtkNew<vtkPoints> origins;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    origins->InsertNextPoint(0.1, 0.1, 0.125 * i);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  box->SetPoints(origins);
  box->SetNormals(normals);
  scene.Filter->SetClippingPlanes(box);
  CHECK_EQUAL(scene.Filter->GetClippingPlanes()->GetNumberOfItems(), 6);
  const auto last = MakePlane(0.0, 0.0, 0.625, { { 0.0, 0.0, 1.0 } });
  scene.Sum.Clip = [&](const RelevoRay& ray, double& begin, double& end)
  { ClipBy(last, ray, begin, end); };
  CHECK_NEAR(scene.Differs(), 0.0, 1e-9);
  scene.Filter->SetClippingPlanes(static_cast<vtkPlanes*>(nullptr)); // as in VTK, no change
  CHECK_EQUAL(scene.Filter->GetClippingPlanes()->GetNumberOfItems(), 6);

  RelevoErrors errors(scene.Filter);
  scene.Filter->AddClippingPlane(nullptr);
  CHECK(errors.Said("Cannot add the clipping plane"));
  scene.Filter->RemoveClippingPlane(plane);
  CHECK(errors.Said("not one of the clipping planes"));
}
}

int TestVolumeRayCastFilterClipping(int, char*[])
{
  RelevoCheck check;
  TestPlanes(check);
  TestSetting(check);
  return check.GetResult();
}
