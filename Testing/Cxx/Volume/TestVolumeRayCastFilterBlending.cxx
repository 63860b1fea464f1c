// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises blend modes and isosurfaces. The references are closed forms for
// linear scalars, and otherwise sums of many samples along a ray.
#include "RelevoCheck.h"
#include "RelevoRaySum.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
using Filter = vtkVolumeRayCastFilter;
constexpr int Size = 17;

// A filter, and the picture that it is compared with.
struct Scene
{
  explicit Scene(vtkDataObject* mesh, vtkSmartPointer<vtkVolumeProperty> property = nullptr)
  {
    this->Cast->SetInputDataObject(mesh);
    this->Property = property ? property : MakeLinearProperty();
    this->Cast->SetVolumeProperty(this->Property);
    this->Camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
    this->Cast->SetCamera(this->Camera);
    this->Cast->SetViewportSize(Size, Size);
  }
  double Differs(const std::function<RelevoColor(const RelevoRay&)>& get)
  {
    return FindLargestDifference(::Cast(this->Cast), MakePicture(this->Camera, Size, Size, get));
  }
  void SetValues(const std::vector<double>& values)
  {
    vtkContourValues* all = this->Property->GetIsoSurfaceValues();
    all->SetNumberOfContours(static_cast<int>(values.size()));
    for (size_t i = 0; i < values.size(); ++i)
    {
      all->SetValue(static_cast<int>(i), values[i]);
    }
  }
  RelevoColor Map(double scalar) { return Premultiply(MapScalar(this->Property, scalar)); }

  vtkNew<Filter> Cast;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
};

void CheckScalars(
  RelevoCheck& check, vtkDataObject* mesh, const RelevoField& field, double tolerance)
{
  Scene scene(mesh);
  RelevoRaySum sum;
  sum.Scalar = field;
  double low;
  double high;
  double mean;
  scene.Cast->SetBlendModeToMaximumIntensity();
  CHECK_EQUAL(scene.Cast->GetBlendMode(), 1);
  const auto getHigh = [&](const RelevoRay& ray)
  { return sum.Measure(ray, low, high, mean) ? scene.Map(high) : RelevoColor(); };
  CHECK_NEAR(scene.Differs(getHigh), 0.0, tolerance);
  scene.Cast->SetBlendModeToMinimumIntensity();
  CHECK_EQUAL(scene.Cast->GetBlendMode(), 2);
  CHECK_GREATER(scene.Differs(getHigh), 0.1);
  CHECK_NEAR(scene.Differs([&](const RelevoRay& ray)
               { return sum.Measure(ray, low, high, mean) ? scene.Map(low) : RelevoColor(); }),
    0.0, tolerance);
  scene.Cast->SetBlendModeToAverageIntensity();
  CHECK_EQUAL(scene.Cast->GetBlendMode(), 3);
  CHECK_NEAR(scene.Differs([&](const RelevoRay& ray)
               { return sum.Measure(ray, low, high, mean) ? scene.Map(mean) : RelevoColor(); }),
    0.0, std::max(tolerance, 1e-4));
}

void TestScalars(RelevoCheck& check)
{
  CheckScalars(check, MakeTetrahedra(3, GetLinearField), GetLinearField, 1e-12);
  CheckScalars(check, MakeVoxel(GetTrilinear), GetTrilinear, 1e-7); // accuracy of the samples
}

// Opacities above 1 are clamped. Without cells, nothing is visible.
void TestOpaque(RelevoCheck& check)
{
  Scene scene(MakeTetrahedra(2, [](const RelevoPoint&) { return 0.5; }));
  scene.Property->GetScalarOpacity()->AddPoint(0.5, 3.0);
  for (const int mode : { 1, 2, 3 })
  {
    CHECK_CASE(mode);
    scene.Cast->SetBlendMode(mode);
    const auto picture = Cast(scene.Cast);
    CHECK_NEAR(picture[Size * Size / 2][3], 1.0, 1e-12);
    CHECK_NEAR(picture[Size * Size / 2][0], 0.5, 1e-5);
    CHECK_EQUAL(picture[0][3], 0.0);
  }
}

void TestAdditive(RelevoCheck& check)
{
  for (const double unit : { 0.5, 4.0 })
  {
    CHECK_CASE(unit);
    Scene scene(MakeTetrahedra(3, GetLinearField), MakeVolumeProperty(0.2, 1.0, unit));
    scene.Property->GetScalarOpacity()->AddPoint(0.4, 0.1);
    scene.Property->GetScalarOpacity()->AddPoint(0.45, 0.9);
    scene.Cast->SetBlendModeToAdditive();
    CHECK_EQUAL(scene.Cast->GetBlendMode(), 4);
    RelevoRaySum sum;
    sum.Optics = [&](const RelevoRay&, const RelevoPoint& p)
    {
      RelevoColor color = MapScalar(scene.Property, GetLinearField(p));
      color[3] /= unit;
      return color;
    };
    CHECK_NEAR(scene.Differs([&](const RelevoRay& ray) { return sum.Add(ray); }), 0.0, 2e-6);
  }
}

RelevoRaySum MakeSurfaces(Scene& scene, const RelevoField& field)
{
  RelevoRaySum sum;
  sum.Scalar = field;
  vtkContourValues* values = scene.Property->GetIsoSurfaceValues();
  sum.Values.assign(values->GetValues(), values->GetValues() + values->GetNumberOfContours());
  std::sort(sum.Values.begin(), sum.Values.end());
  sum.Values.erase(std::unique(sum.Values.begin(), sum.Values.end()), sum.Values.end());
  sum.Surface = [&scene, sum](const RelevoRay&, const RelevoPoint& p)
  {
    const double here = sum.Scalar(p);
    const double value = *std::min_element(sum.Values.begin(), sum.Values.end(),
      [=](double a, double b) { return std::abs(a - here) < std::abs(b - here); });
    return MapScalar(scene.Property, value);
  };
  return sum;
}

void TestIsoSurfaces(RelevoCheck& check)
{
  Scene scene(MakeTetrahedra(3, GetLinearField));
  scene.SetValues({ 0.7, 0.3, 0.301, 0.3 });
  scene.Cast->SetBlendModeToIsoSurface();
  CHECK_EQUAL(scene.Cast->GetBlendMode(), 5);
  RelevoRaySum sum = MakeSurfaces(scene, GetLinearField);
  const auto get = [&](const RelevoRay& ray) { return sum.Composite(ray); };
  CHECK_NEAR(scene.Differs(get), 0.0, 1e-9);
  scene.SetValues({ 0.7, 0.3, 0.301, 0.3, std::nan(""), 2.0 });
  CHECK_NEAR(scene.Differs(get), 0.0, 1e-9);

  Scene voxel(MakeVoxel(GetTrilinear));
  voxel.SetValues({ 0.25, 0.4, 0.55 });
  voxel.Cast->SetBlendModeToIsoSurface();
  sum = MakeSurfaces(voxel, GetTrilinear);
  CHECK_NEAR(voxel.Differs([&](const RelevoRay& ray) { return sum.Composite(ray); }), 0.0, 1e-9);

  // The camera is inside the volume, between parts in front of it and behind it.
  Scene inside(MakeTetrahedra(3, GetLinearField));
  inside.SetValues({ 0.35, 0.6 });
  inside.Property->GetScalarOpacity()->AddPoint(0.35, 0.9);
  inside.Cast->IsoSurfacesOn();
  sum = MakeSurfaces(inside, GetLinearField);
  sum.Optics = [&](const RelevoRay&, const RelevoPoint& p)
  {
    RelevoColor color = MapScalar(inside.Property, GetLinearField(p));
    color[3] /= 0.5;
    return color;
  };
  const auto getInside = [&](const RelevoRay& ray) { return sum.Composite(ray); };
  CHECK_NEAR(inside.Differs(getInside), 0.0, 2e-4); // accuracy of the steps that contain a surface
  inside.Cast->IsoSurfacesOff();
  CHECK_GREATER(inside.Differs(getInside), 0.1);
}

// A surface on the border of cells is drawn once. Constant scalars have no surface.
void TestBorders(RelevoCheck& check)
{
  const auto count = [&](const RelevoField& field, double value, vtkCamera* camera)
  {
    Scene scene(MakeTetrahedra(4, field), MakeVolumeProperty(0.25, 0.25));
    scene.SetValues({ value });
    scene.Cast->SetBlendModeToIsoSurface();
    scene.Cast->SetCamera(camera);
    int surfaces = -1;
    for (const RelevoColor& color : Cast(scene.Cast))
    {
      const double number = std::log(1.0 - color[3]) / std::log(0.75);
      CHECK_NEAR(number, std::round(number), 1e-9);
      const int here = static_cast<int>(std::round(number));
      CHECK(surfaces < 0 || here == surfaces);
      surfaces = here;
    }
    return surfaces;
  };
  const auto oblique = MakeCamera({ { 4.0, 0.6, 0.7 } }, { { 0.5, 0.5, 0.5 } }, 8.0);
  const auto back = MakeCamera({ { -4.0, 0.6, 0.7 } }, { { 0.5, 0.5, 0.5 } }, 8.0);
  const auto along = MakeCamera({ { 4.0, 0.5, 0.5 } }, { { 0.5, 0.5, 0.5 } });
  along->ParallelProjectionOn();
  along->SetParallelScale(0.4);
  for (vtkCamera* camera : { oblique.Get(), back.Get(), along.Get() })
  {
    CHECK_EQUAL(count([](const RelevoPoint& p) { return p[0] / 3.0; }, 0.25 / 3.0, camera), 1);
    CHECK_EQUAL(count([](const RelevoPoint& p) { return p[0] - 0.5; }, 0.0, camera), 1);
    CHECK_EQUAL(count([](const RelevoPoint& p) { return 0.1 * p[0]; }, 0.04, camera), 1);
    CHECK_EQUAL(count([](const RelevoPoint&) { return 0.3; }, 0.3, camera), 0);
    // The scalar rises or falls to the value and then stays there.
    CHECK_EQUAL(
      count([](const RelevoPoint& p) { return std::min(p[0], 0.5) * 0.7; }, 0.35, camera), 1);
    CHECK_EQUAL(count([](const RelevoPoint& p) { return std::abs(p[0] - 0.5); }, 0.25, camera), 2);
    CHECK_EQUAL(count([](const RelevoPoint& p) { return std::max(std::abs(p[0] - 0.5), 0.25); },
                  0.25, camera),
      0);
  }
  // Blocks that meet at the isovalue, which is slightly lower in one of them.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeTetrahedra(2, [](const RelevoPoint& p) { return p[0]; }));
  const auto second = MakeTetrahedra(2, [](const RelevoPoint& p) { return 1.0 + p[0] - 1e-8; });
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    const double* point = second->GetPoint(i);
    second->GetPoints()->SetPoint(i, point[0] + 1.0, point[1], point[2]);
  }
  blocks->SetBlock(1, second);
  Scene two(blocks, MakeVolumeProperty(0.25, 0.25));
  two.SetValues({ 1.0 });
  two.Cast->SetBlendModeToIsoSurface();
  for (vtkCamera* camera : { oblique.Get(), back.Get() })
  {
    two.Cast->SetCamera(camera);
    for (const RelevoColor& color : Cast(two.Cast))
    {
      CHECK_NEAR(color[3], 0.25, 1e-12);
    }
  }

  // Cell scalars have the isosurfaces of vtkCellDataToPointData's averages.
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkDoubleArray> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(static_cast<double>(i % 5));
  }
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->SetScalars(ids);
  Scene scene(mesh);
  scene.SetValues({ 0.5, 2.0, 3.0 });
  scene.Cast->SetBlendModeToIsoSurface();
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(mesh);
  toPoints->Update();
  Scene points(vtkDataSet::SafeDownCast(toPoints->GetOutput()));
  points.SetValues({ 0.5, 2.0, 3.0 });
  points.Cast->SetBlendModeToIsoSurface();
  const auto picture = Cast(scene.Cast);
  CHECK_LESS(FindLargestDifference(picture, Cast(points.Cast)), 1e-9);
  CHECK(std::any_of(
    picture.begin(), picture.end(), [](const RelevoColor& color) { return color[3] > 0.1; }));
}

// A mesh with two components, the second of which is x.
vtkSmartPointer<vtkUnstructuredGrid> MakeTwo()
{
  auto mesh = MakeTetrahedra(3, GetLinearField);
  vtkNew<vtkDoubleArray> two;
  two->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint point;
    mesh->GetPoint(i, point.data());
    two->InsertNextTuple2(GetLinearField(point), point[0]);
  }
  mesh->GetPointData()->SetScalars(two);
  return mesh;
}

RelevoColor Mix(const RelevoColor& a, const RelevoColor& b)
{
  RelevoColor mixed;
  const double sum = a[3] + b[3];
  mixed[3] = std::min(sum, 1.0);
  for (int c = 0; c < 3; ++c)
  {
    mixed[c] = (a[c] * a[3] + b[c] * b[3]) / sum * mixed[3];
  }
  return mixed;
}

void TestIndependent(RelevoCheck& check)
{
  Scene scene(MakeTwo(), MakeVolumeProperty(0.1, 0.7, 0.5));
  scene.Property->GetRGBTransferFunction(1)->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  scene.Property->GetScalarOpacity(1)->RemoveAllPoints();
  scene.Property->GetScalarOpacity(1)->AddPoint(0.0, 0.05);
  scene.Property->GetScalarOpacity(1)->AddPoint(1.0, 0.6);
  scene.Property->SetScalarOpacityUnitDistance(1, 7.0); // has no effect
  RelevoRaySum first;
  first.Scalar = GetLinearField;
  RelevoRaySum second;
  second.Scalar = [](const RelevoPoint& p) { return p[0]; };
  for (const int mode : { 1, 2, 3 })
  {
    CHECK_CASE(mode);
    scene.Cast->SetBlendMode(mode);
    CHECK_NEAR(
      scene.Differs(
        [&](const RelevoRay& ray)
        {
          double a[4];
          double b[4];
          return first.Measure(ray, a[2], a[1], a[3]) && second.Measure(ray, b[2], b[1], b[3])
            ? Mix(MapScalar(scene.Property, a[mode]), MapScalar(scene.Property, b[mode], 1))
            : RelevoColor();
        }),
      0.0, 1e-5);
  }
  // An isosurface belongs to the first component, or to the component with the larger weight.
  scene.SetValues({ 0.4 });
  scene.Cast->SetBlendModeToIsoSurface();
  RelevoRaySum surfaces = MakeSurfaces(scene, GetLinearField);
  const auto get = [&](const RelevoRay& ray) { return surfaces.Composite(ray); };
  CHECK_NEAR(scene.Differs(get), 0.0, 1e-5);
  scene.Property->SetComponentWeight(0, 0.5);
  CHECK_GREATER(scene.Differs(get), 0.1);
  surfaces.Scalar = second.Scalar;
  surfaces.Surface = [&](const RelevoRay&, const RelevoPoint&)
  { return MapScalar(scene.Property, 0.4, 1); };
  CHECK_NEAR(scene.Differs(get), 0.0, 1e-5);
}

// With dependent components, the extreme of the second one, the opacity, is at the ends of a ray.
void TestDependent(RelevoCheck& check)
{
  Scene scene(MakeTwo());
  scene.Property->IndependentComponentsOff();
  for (const int mode : { 1, 2 })
  {
    CHECK_CASE(mode);
    scene.Cast->SetBlendMode(mode);
    CHECK_NEAR(scene.Differs(
                 [&](const RelevoRay& ray)
                 {
                   double begin;
                   double end;
                   if (!ray.CutBox(0.0, 1.0, begin, end))
                   {
                     return RelevoColor();
                   }
                   const RelevoPoint front = ray.At(begin);
                   const RelevoPoint back = ray.At(end);
                   const bool isFront = (front[0] > back[0]) == (mode == 1);
                   const RelevoPoint at = isFront ? front : back;
                   RelevoColor color = MapScalar(scene.Property, GetLinearField(at));
                   color[3] = MapScalar(scene.Property, at[0])[3];
                   return Premultiply(color);
                 }),
      0.0, 1e-9);
  }
}

void TestSetting(RelevoCheck& check)
{
  vtkNew<Filter> filter;
  RelevoErrors errors(filter);
  CHECK(filter->GetBlendMode() == 0 && !filter->GetIsoSurfaces());
  filter->SetBlendMode(6);
  CHECK(errors.Said("BlendMode must be one of COMPOSITE_BLEND (0)"));
  filter->SetBlendModeToIsoSurface();
  filter->SetBlendMode(-1);
  CHECK(errors.Said("got -1"));
  CHECK_EQUAL(filter->GetBlendMode(), 5);
  filter->SetBlendModeToComposite();
  CHECK_EQUAL(filter->GetBlendMode(), 0);
}
}

int TestVolumeRayCastFilterBlending(int, char*[])
{
  RelevoCheck check;
  TestScalars(check);
  TestOpaque(check);
  TestAdditive(check);
  TestIsoSurfaces(check);
  TestBorders(check);
  TestIndependent(check);
  TestDependent(check);
  TestSetting(check);
  return check.GetResult();
}
