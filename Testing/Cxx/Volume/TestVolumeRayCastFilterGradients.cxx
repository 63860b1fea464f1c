// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises gradient opacity and 2D transfer functions. The references are
// sums along rays through fields with known gradients.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoRaySum.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Size = 15;
constexpr double Unit = 0.3;

// A field with gradient length 1 for x below the middle and 3 above it.
double GetBent(const RelevoPoint& p)
{
  return p[0] < 0.5 ? 0.5 * p[0] : 0.25 + 1.5 * (p[0] - 0.5);
}
double GetBentSteepness(const RelevoPoint& p)
{
  return p[0] < 0.5 ? 0.5 : 1.5;
}

double GetTrilinearSteepness(const RelevoPoint& p)
{
  const double x = 0.8 * (1.0 - p[1]) - 0.7 * p[1] * p[2];
  const double y = -0.8 * p[0] + 0.7 * (1.0 - p[0]) * p[2];
  const double z = 0.7 * p[1] * (1.0 - p[0]) + 0.1;
  return std::sqrt(x * x + y * y + z * z);
}

struct Scene
{
  explicit Scene(vtkDataObject* mesh)
  {
    this->Filter->SetInputDataObject(mesh);
    this->Filter->SetVolumeProperty(this->Property);
    this->Filter->SetViewportSize(Size, Size);
    this->Camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
    this->Filter->SetCamera(this->Camera);
  }
  double Differs(const std::function<RelevoColor(const RelevoRay&)>& get)
  {
    return FindLargestDifference(Cast(this->Filter), MakePicture(this->Camera, Size, Size, get));
  }

  vtkNew<vtkVolumeRayCastFilter> Filter;
  vtkSmartPointer<vtkVolumeProperty> Property = MakeVolumeProperty(0.1, 0.9, Unit);
  vtkSmartPointer<vtkCamera> Camera;
};

vtkSmartPointer<vtkPiecewiseFunction> MakeRamp()
{
  auto ramp = vtkSmartPointer<vtkPiecewiseFunction>::New();
  ramp->AddPoint(0.2, 0.1);
  ramp->AddPoint(1.2, 1.0);
  ramp->AddPoint(2.0, 0.6);
  return ramp;
}

void CheckGradientOpacity(RelevoCheck& check, vtkDataObject* mesh, const RelevoField& field,
  const RelevoField& steepness, double tolerance)
{
  Scene scene(mesh);
  RelevoRaySum sum;
  sum.Optics = [&](const RelevoRay&, const RelevoPoint& p)
  {
    RelevoColor color = MapScalar(scene.Property, field(p));
    color[3] *= scene.Property->GetGradientOpacity()->GetValue(steepness(p)) / Unit;
    return color;
  };
  const auto get = [&](const RelevoRay& ray) { return sum.Composite(ray); };
  CHECK_NEAR(scene.Differs(get), 0.0, tolerance);
  scene.Property->SetGradientOpacity(MakeRamp());
  CHECK_NEAR(scene.Differs(get), 0.0, tolerance);
  scene.Filter->SetBlendModeToAdditive();
  CHECK_NEAR(scene.Differs([&](const RelevoRay& ray) { return sum.Add(ray); }), 0.0, tolerance);
  // It has no effect in blend modes where opacity does not depend on length.
  scene.Filter->SetBlendModeToAverageIntensity();
  const auto average = Cast(scene.Filter);
  scene.Property->DisableGradientOpacityOn();
  CHECK_EQUAL(FindLargestDifference(Cast(scene.Filter), average), 0.0);
  scene.Filter->SetBlendModeToComposite();
  CHECK_NEAR(scene.Differs(get), 0.0, tolerance); // a constant factor of 1
}

void TestGradientOpacity(RelevoCheck& check)
{
  CheckGradientOpacity(check, MakeTetrahedra(2, GetBent), GetBent, GetBentSteepness, 1e-3);
  CheckGradientOpacity(check, MakeVoxel(GetTrilinear), GetTrilinear, GetTrilinearSteepness, 2e-4);

  // If the gradient is constant, the result is exact.
  Scene scene(MakeTetrahedra(3, GetLinearField));
  scene.Property->SetGradientOpacity(MakeRamp());
  const auto picture = Cast(scene.Filter);
  const double factor = MakeRamp()->GetValue(std::sqrt(0.04 + 0.09 + 0.25));
  const auto expected = Cast(MakeTetrahedra(3, GetLinearField),
    MakeVolumeProperty(0.1, 0.9, Unit / factor), scene.Camera, Size, Size);
  CHECK_NEAR(FindLargestDifference(picture, expected), 0.0, 1e-12);

  // Cell scalars have no gradients.
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkDoubleArray> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ids->InsertNextValue(0.1 * (i % 7));
  }
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->SetScalars(ids);
  Scene cells(mesh);
  cells.Property->SetGradientOpacity(MakeRamp());
  CHECK_NEAR(FindLargestDifference(Cast(cells.Filter),
               Cast(mesh, MakeVolumeProperty(0.1, 0.9, Unit / 0.1), cells.Camera, Size, Size)),
    0.0, 1e-12);
}

// Each independent component has its gradient opacity. For dependent components, that of the last
// one, the opacity, is used.
void TestComponents(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(6, GetBent);
  vtkNew<vtkDoubleArray> two;
  two->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint point;
    mesh->GetPoint(i, point.data());
    two->InsertNextTuple2(GetLinearField(point), GetBent(point));
  }
  mesh->GetPointData()->SetScalars(two);
  Scene scene(mesh);
  scene.Property->GetRGBTransferFunction(1)->RemoveAllPoints();
  scene.Property->GetRGBTransferFunction(1)->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  scene.Property->GetScalarOpacity(1)->RemoveAllPoints();
  scene.Property->GetScalarOpacity(1)->AddPoint(0.0, 0.7);
  scene.Property->SetScalarOpacityUnitDistance(1, 0.7);
  scene.Property->SetGradientOpacity(1, MakeRamp());
  RelevoRaySum sum;
  sum.Optics = [&](const RelevoRay&, const RelevoPoint& p)
  {
    RelevoColor first = MapScalar(scene.Property, GetLinearField(p));
    const double a = first[3] / Unit;
    const double b = MakeRamp()->GetValue(GetBentSteepness(p));
    return RelevoColor{ { first[0] * a / (a + b), b / (a + b), first[2] * a / (a + b), a + b } };
  };
  CHECK_NEAR(scene.Differs([&](const RelevoRay& ray) { return sum.Composite(ray); }), 0.0,
    3e-3); // accuracy of mixed colours at the ends
  scene.Property->IndependentComponentsOff();
  scene.Property->SetGradientOpacity(0, MakeRamp());
  sum.Optics = [&](const RelevoRay&, const RelevoPoint& p)
  {
    RelevoColor color = MapScalar(scene.Property, GetLinearField(p));
    color[3] =
      MapScalar(scene.Property, GetBent(p))[3] * MakeRamp()->GetValue(GetBentSteepness(p)) / Unit;
    return color;
  };
  CHECK_NEAR(scene.Differs([&](const RelevoRay& ray) { return sum.Composite(ray); }), 0.0, 1e-3);
}

// A table for 7 scalars and 5 gradient lengths.
struct Table
{
  Table()
  {
    RelevoDice dice(5);
    this->Image->SetOrigin(-0.05, 0.25, 0.0);
    this->Image->SetSpacing(0.16, 0.3, 1.0);
    this->Image->SetDimensions(7, 5, 1);
    this->Image->AllocateScalars(VTK_FLOAT, 4);
    for (int i = 0; i < 7 * 5 * 4; ++i)
    {
      this->Image->GetPointData()->GetScalars()->SetComponent(i / 4, i % 4, dice.Share());
    }
  }
  RelevoColor Get(double scalar, double steepness) const
  {
    const double x = std::clamp((scalar + 0.05) / 0.16, 0.0, 6.0);
    const double y = std::clamp((steepness - 0.25) / 0.3, 0.0, 4.0);
    RelevoColor color = {};
    for (int i = 0; i < 35; ++i)
    {
      const double weight =
        std::max(1.0 - std::abs(x - i % 7), 0.0) * std::max(1.0 - std::abs(y - i / 7), 0.0);
      for (int c = 0; c < 4; ++c)
      {
        color[c] += weight * this->Image->GetPointData()->GetScalars()->GetComponent(i, c);
      }
    }
    return color;
  }

  vtkNew<vtkImageData> Image;
};

void CheckTable(RelevoCheck& check, vtkDataObject* mesh, const RelevoField& field,
  const RelevoField& steepness, double tolerance)
{
  Scene scene(mesh);
  const Table table;
  scene.Property->SetGradientOpacity(MakeRamp()); // has no effect on a 2D transfer function
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(table.Image);
  scene.Property->GetRGBTransferFunction()->RemoveAllPoints();
  RelevoRaySum sum;
  sum.Scalar = field;
  sum.Optics = [&](const RelevoRay&, const RelevoPoint& p)
  {
    RelevoColor color = table.Get(field(p), steepness(p));
    color[3] /= Unit;
    return color;
  };
  CHECK_NEAR(
    scene.Differs([&](const RelevoRay& ray) { return sum.Composite(ray); }), 0.0, tolerance);
  scene.Filter->SetBlendModeToAdditive();
  CHECK_NEAR(scene.Differs([&](const RelevoRay& ray) { return sum.Add(ray); }), 0.0, tolerance);
}

void TestTables(RelevoCheck& check)
{
  CheckTable(check, MakeTetrahedra(2, GetBent), GetBent, GetBentSteepness, 2e-3);
  CheckTable(check, MakeVoxel(GetTrilinear), GetTrilinear, GetTrilinearSteepness, 2e-4);

  // For extremes and isosurfaces, the gradient is taken at their position, in front of the bend or
  // behind it.
  Scene scene(MakeTetrahedra(2, GetBent));
  scene.Camera->SetPosition(4.0, 0.5, 0.5);
  scene.Camera->SetViewAngle(10.0);
  const Table table;
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(table.Image);
  const auto checkAll = [&](const RelevoColor& color)
  {
    const RelevoColor shown = Premultiply(color);
    CHECK_NEAR(scene.Differs([&](const RelevoRay&) { return shown; }), 0.0, 1e-9);
  };
  scene.Filter->SetBlendModeToMaximumIntensity();
  checkAll(table.Get(1.0, 1.5));
  scene.Filter->SetBlendModeToMinimumIntensity();
  checkAll(table.Get(0.0, 0.5));
  scene.Filter->SetBlendModeToAverageIntensity();
  checkAll(table.Get(0.5 * 0.125 + 0.5 * 0.625, 1.0));
  scene.Filter->SetBlendModeToIsoSurface();
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.2);
  checkAll(table.Get(0.2, 0.5));
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.4);
  checkAll(table.Get(0.4, 1.5));
}

// For dependent components, only the last one is used.
void TestDependentTable(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetBent);
  vtkNew<vtkDoubleArray> two;
  two->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    two->InsertNextTuple2(0.1 * i, mesh->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  const Table table;
  const auto cast = [&]()
  {
    Scene scene(mesh);
    scene.Property->IndependentComponentsOff();
    scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
    scene.Property->SetTransferFunction2D(table.Image);
    scene.Property->ShadeOn();
    return Cast(scene.Filter);
  };
  const auto expected = cast();
  mesh->GetPointData()->SetScalars(two);
  CHECK_EQUAL(FindLargestDifference(cast(), expected), 0.0);
}

// For direct colours, the gradient is that of the opacity.
void TestColors(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(3, GetLinearField);
  vtkNew<vtkDoubleArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint point;
    mesh->GetPoint(i, point.data());
    colors->InsertNextTuple4(point[0], 0.2, point[1] * point[1], GetLinearField(point));
  }
  mesh->GetPointData()->SetScalars(colors);
  Scene scene(mesh);
  scene.Property->IndependentComponentsOff();
  scene.Property->SetGradientOpacity(MakeRamp());
  const auto picture = Cast(scene.Filter);
  scene.Property->DisableGradientOpacityOn();
  CHECK_GREATER(FindLargestDifference(Cast(scene.Filter), picture), 0.05);
  const double factor = MakeRamp()->GetValue(std::sqrt(0.04 + 0.09 + 0.25));
  scene.Property->SetScalarOpacityUnitDistance(Unit / factor);
  CHECK_NEAR(FindLargestDifference(Cast(scene.Filter), picture), 0.0, 1e-12);
}

// Three columns close together, so that the range between them determines the result.
void TestColumns(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetOrigin(0.4999, 0.0, 0.0);
  image->SetSpacing(1e-4, 1.0, 1.0);
  image->SetDimensions(3, 1, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  image->GetPointData()->GetScalars()->Fill(0.0);
  image->GetPointData()->GetScalars()->SetTuple4(1, 1.0, 1.0, 1.0, 1.0);
  Scene scene(MakeTetrahedra(3, [](const RelevoPoint& p) { return p[2]; }));
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  scene.Property->SetTransferFunction2D(image);
  scene.Property->SetScalarOpacityUnitDistance(1e-4);
  scene.Camera->SetPosition(0.5, 0.5, 4.0);
  scene.Camera->SetViewAngle(5.0);
  scene.Camera->ParallelProjectionOn();
  scene.Camera->SetParallelScale(0.4);
  for (const RelevoColor& color : Cast(scene.Filter))
  {
    CHECK_NEAR(color[3], 1.0 - std::exp(-1.0), 1e-9);
  }
}

void TestErrors(RelevoCheck& check)
{
  Scene scene(MakeTetrahedra(1, GetLinearField));
  RelevoErrors errors(scene.Filter);
  RelevoErrors executiveErrors(scene.Filter->GetExecutive());
  const auto fails = [&](const std::string& words)
  {
    scene.Filter->Modified();
    return Cast(scene.Filter).empty() && errors.Said(words);
  };
  scene.Property->GetStoredGradientOpacity()->RemoveAllPoints();
  CHECK(fails("gradient opacity function without nodes for component 0"));
  scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  CHECK(fails("has no 2D transfer function for component 0; call SetTransferFunction2D()"));
  // VTK checks images when they are set, but they may change later.
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  image->GetPointData()->GetScalars()->Fill(std::nan(""));
  scene.Property->SetTransferFunction2D(image);
  CHECK(fails("has a 2D transfer function with values that are not finite for component 0"));
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 4);
  CHECK(fails("not an image of one slice"));
  image->AllocateScalars(VTK_FLOAT, 3);
  CHECK(fails("without scalars of 4 components"));
  image->SetDimensions(2, 2, 1);
  image->SetSpacing(0.0, 1.0, 1.0);
  image->AllocateScalars(VTK_FLOAT, 4);
  image->GetPointData()->GetScalars()->Fill(0.5);
  CHECK(fails("spacing is not positive"));
  image->SetSpacing(1.0, 1.0, 1.0);
  scene.Filter->Modified();
  CHECK(!Cast(scene.Filter).empty() && errors.None());
}
}

int TestVolumeRayCastFilterGradients(int, char*[])
{
  RelevoCheck check;
  TestGradientOpacity(check);
  TestComponents(check);
  TestTables(check);
  TestDependentTable(check);
  TestColors(check);
  TestColumns(check);
  TestErrors(check);
  return check.GetResult();
}
