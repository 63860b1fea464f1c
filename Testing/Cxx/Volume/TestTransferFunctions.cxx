// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on transfer functions: they are evaluated as VTK does along a part of a ray.
// The references are closed forms and sums of many short parts.
#include "Integral/TransferFunctions.h"
#include "RelevoCheck.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <functional>

namespace
{
using relevo::dvec3;
using relevo::dvec4;
using relevo::Scalars;
using relevo::TransferFunctions;
using Optics = std::function<dvec4(const Scalars&)>; // straight colour and extinction

TransferFunctions Read(RelevoCheck& check, vtkVolumeProperty* property, int components = 1)
{
  TransferFunctions functions;
  std::string error;
  std::string warning;
  CHECK(functions.Read(property, components, error, warning));
  CHECK(error.empty() && warning.empty());
  return functions;
}

dvec4 Sum(const Optics& optics, const Scalars& front, const Scalars& back, double length)
{
  const int count = 200000;
  dvec3 color(0.0);
  double light = 1.0;
  for (int i = 0; i < count; ++i)
  {
    const double t = (i + 0.5) / count;
    Scalars at;
    for (size_t j = 0; j < at.size(); ++j)
    {
      at[j] = (1.0 - t) * front[j] + t * back[j];
    }
    const dvec4 here = optics(at);
    const double passes = std::exp(-here.w * length / count);
    color += light * (1.0 - passes) * dvec3(here);
    light *= passes;
  }
  return dvec4(color, 1.0 - light);
}

void CheckSame(RelevoCheck& check, const dvec4& value, const dvec4& expected, double tolerance)
{
  for (int i = 0; i < 4; ++i)
  {
    CHECK_NEAR(value[i], expected[i], tolerance);
  }
}

dvec4 GetOptics(vtkVolumeProperty* property, int component, double scalar)
{
  dvec4 result;
  property->GetRGBTransferFunction(component)->GetColor(scalar, &result.x);
  result.w = property->GetScalarOpacity(component)->GetValue(scalar) /
    property->GetScalarOpacityUnitDistance(component);
  return result;
}

// Nodes 1e-4 apart form a spike whose area determines the result.
void TestSpike(RelevoCheck& check)
{
  vtkNew<vtkVolumeProperty> property;
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.4999, 0.0);
  opacity->AddPoint(0.5, 1.0);
  opacity->AddPoint(0.5001, 0.0);
  vtkColorTransferFunction* color = property->GetRGBTransferFunction();
  color->AddRGBPoint(0.4, 1.0, 0.0, 0.0);
  color->AddRGBPoint(0.6, 0.0, 0.0, 1.0);
  property->SetScalarOpacityUnitDistance(1e-4);
  const TransferFunctions functions = Read(check, property);
  const double alpha = 1.0 - std::exp(-3.0); // a length of 3 with values from 0 to 1
  CheckSame(check, functions.Integrate({ 0.0 }, { 1.0 }, 3.0),
    dvec4(0.5 * alpha, 0.0, 0.5 * alpha, alpha), 3e-4);
  CHECK_NEAR(functions.Integrate({ 0.0 }, { 1.0 }, 3.0).w, alpha, 1e-12);
  CHECK_NEAR(functions.Integrate({ 1.0 }, { 0.0 }, 3.0).w, alpha, 1e-12);
  CHECK_EQUAL(functions.Integrate({ 0.0 }, { 0.4999 }, 3.0).w, 0.0);
  CHECK_NEAR(functions.Integrate({ 0.5 }, { 0.5 }, 3e-4).w, alpha, 1e-8);
}

// Every feature of vtkColorTransferFunction and vtkPiecewiseFunction that makes it nonlinear.
void TestCurves(RelevoCheck& check)
{
  for (int space : { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING, VTK_CTF_STEP })
  {
    CHECK_CASE(space);
    for (double sharpness : { 0.0, 0.3, 1.0 })
    {
      CHECK_CASE(sharpness);
      for (bool clamping : { true, false })
      {
        CHECK_CASE(clamping);
        vtkNew<vtkVolumeProperty> property;
        vtkColorTransferFunction* color = property->GetRGBTransferFunction();
        color->SetColorSpace(space);
        color->SetClamping(clamping);
        color->AddRGBPoint(0.1, 0.9, 0.1, 0.1, 0.3, sharpness);
        color->AddRGBPoint(0.6, 0.1, 0.2, 0.8, 0.9, sharpness);
        color->AddRGBPoint(0.8, 0.2, 0.9, 0.3);
        vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
        opacity->RemoveAllPoints();
        opacity->SetClamping(clamping);
        opacity->AddPoint(0.2, 0.8, 0.7, sharpness);
        opacity->AddPoint(0.5, 0.1, 0.2, sharpness);
        opacity->AddPoint(0.9, 1.0);
        property->SetScalarOpacityUnitDistance(0.4);
        const TransferFunctions functions = Read(check, property);
        const Optics optics = [&](const Scalars& s) { return GetOptics(property, 0, s[0]); };
        CheckSame(check, functions.Integrate({ 0.0 }, { 1.0 }, 1.0),
          Sum(optics, { 0.0 }, { 1.0 }, 1.0), 2e-5);
        CheckSame(check, functions.Integrate({ 0.85 }, { 0.15 }, 0.5),
          Sum(optics, { 0.85 }, { 0.15 }, 0.5), 2e-5);
      }
    }
  }
}

void FillComponents(vtkVolumeProperty* property, int components)
{
  for (int i = 0; i < components; ++i)
  {
    vtkColorTransferFunction* color = property->GetRGBTransferFunction(i);
    color->AddRGBPoint(0.0, i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.3, 0.0);
    color->AddRGBPoint(1.0, i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.1, i == 2 ? 1.0 : 0.0);
    vtkPiecewiseFunction* opacity = property->GetScalarOpacity(i);
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(0.3 + 0.1 * i, 0.0);
    opacity->AddPoint(1.0, 0.5);
    property->SetScalarOpacityUnitDistance(i, 0.5 + i);
  }
}

// Colours of components are mixed by their extinctions.
void TestIndependent(RelevoCheck& check)
{
  for (int components : { 2, 3, 4 })
  {
    vtkNew<vtkVolumeProperty> property;
    FillComponents(property, components);
    const TransferFunctions functions = Read(check, property, components);
    const Scalars front = { 0.1, 0.9, 0.0, 0.2 };
    const Scalars back = { 0.8, 0.2, 0.5, 0.2 };
    double depth = 0.0;
    for (int i = 0; i < components; ++i)
    {
      const Optics optics = [&](const Scalars& s) { return GetOptics(property, i, s[i]); };
      depth -= std::log(1.0 - Sum(optics, front, back, 2.0).w);
    }
    const dvec4 seen = functions.Integrate(front, back, 2.0);
    CHECK_NEAR(seen.w, 1.0 - std::exp(-depth), 1e-6);
    const Optics mixed = [&](const Scalars& s)
    {
      dvec4 sum(0.0);
      for (int i = 0; i < components; ++i)
      {
        const dvec4 optics = GetOptics(property, i, s[i]);
        sum += optics.w * dvec4(dvec3(optics), 1.0);
      }
      return sum.w > 0.0 ? dvec4(dvec3(sum) / sum.w, sum.w) : sum;
    };
    for (const double length : { 2.0, 20.0 })
    {
      CheckSame(
        check, functions.Integrate(front, back, length), Sum(mixed, front, back, length), 1e-4);
    }
    // Constant scalars give the mean of the colours, weighted by extinction.
    const dvec4 here = functions.Integrate(back, back, 2.0);
    dvec4 mean(0.0);
    for (int i = 0; i < components; ++i)
    {
      const dvec4 optics = GetOptics(property, i, back[i]);
      mean += optics.w * dvec4(dvec3(optics), 1.0);
    }
    const double alpha = 1.0 - std::exp(-2.0 * mean.w);
    CheckSame(check, here, dvec4(dvec3(mean) / mean.w * alpha, alpha), 1e-6);
  }
  // If extinction begins at the front, the colour is that of the component that begins there.
  vtkNew<vtkVolumeProperty> property;
  FillComponents(property, 2);
  const dvec4 seen = Read(check, property, 2).Integrate({ 0.3, 0.0 }, { 1.0, 0.0 }, 1.0);
  CHECK_NEAR(seen.x, seen.w, 1e-12);
}

// Nodes of several components at the same value cut only once.
void TestCuts(RelevoCheck& check)
{
  vtkNew<vtkVolumeProperty> property;
  FillComponents(property, 1);
  const auto one = Read(check, property, 1).FindCuts({ -1.0 }, { 2.0 });
  CHECK(one.front() == 0.0 && one.back() == 1.0 && one.size() > 4);
  property->SetColor(1, property->GetRGBTransferFunction(0));
  property->SetScalarOpacity(1, property->GetScalarOpacity(0));
  CHECK_EQUAL(Read(check, property, 2).FindCuts({ -1.0, -1.0 }, { 2.0, 2.0 }), one);
}

void TestDependent(RelevoCheck& check)
{
  vtkNew<vtkVolumeProperty> property;
  FillComponents(property, 1);
  property->IndependentComponentsOff();
  const Optics two = [&](const Scalars& s)
  {
    dvec4 result = GetOptics(property, 0, s[0]);
    result.w = GetOptics(property, 0, s[1]).w;
    return result;
  };
  const Scalars front = { -0.5, 0.1 };
  const Scalars back = { 1.5, 1.3 };
  CheckSame(
    check, Read(check, property, 2).Integrate(front, back, 2.0), Sum(two, front, back, 2.0), 2e-5);
  const Optics four = [&](const Scalars& s) { return dvec4(s[0], s[1], s[2], s[3] / 0.5); };
  const Scalars first = { 1.0, 0.5, 0.0, 0.2 };
  const Scalars last = { 0.0, 0.5, 1.0, 0.9 };
  CheckSame(
    check, Read(check, property, 4).Integrate(first, last, 2.0), Sum(four, first, last, 2.0), 1e-6);
}

// Density 1 - r^2 in a ball of radius 1. On a chord at distance h from the centre, the optical
// depth is int (1 - h^2 - t^2) dt = 4/3 (1 - h^2)^(3/2).
void TestChord(RelevoCheck& check)
{
  vtkNew<vtkVolumeProperty> property;
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 1.0);
  const TransferFunctions functions = Read(check, property);
  for (double h : { 0.0, 0.5, 0.95 })
  {
    CHECK_CASE(h);
    const double half = std::sqrt(1.0 - h * h);
    const int count = 2000;
    dvec4 seen(0.0);
    const auto density = [&](int i)
    {
      const double t = half * (2.0 * i / count - 1.0);
      return 1.0 - h * h - t * t;
    };
    for (int i = 0; i < count; ++i)
    {
      seen = relevo::frontOverBack(
        seen, functions.Integrate({ density(i) }, { density(i + 1) }, 2.0 * half / count));
    }
    const double alpha = 1.0 - std::exp(-4.0 / 3.0 * half * half * half);
    CheckSame(check, seen, dvec4(alpha), 1e-6);
  }
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkVolumeProperty> property;
  FillComponents(property, 4);
  TransferFunctions functions;
  std::string error;
  std::string warning;
  property->SetScalarOpacityUnitDistance(1, 0.0);
  CHECK(functions.Read(property, 2, error, warning));
  CHECK_NOT_EQUAL(warning.find("0 for component 1"), std::string::npos);
  CHECK_GREATER(functions.Integrate({ 0.0, 1.0 }, { 0.0, 1.0 }, 1.0).w, 0.3);
  property->GetScalarOpacity(1)->RemoveAllPoints();
  CHECK(!functions.Read(property, 2, error, warning));
  CHECK_NOT_EQUAL(
    error.find("scalar opacity function without nodes for component 1"), std::string::npos);
  property->GetRGBTransferFunction(0)->RemoveAllPoints();
  CHECK(!functions.Read(property, 1, error, warning));
  CHECK_NOT_EQUAL(error.find("colour function without nodes for component 0"), std::string::npos);
  CHECK(!functions.Read(property, 5, error, warning));
  CHECK_NOT_EQUAL(error.find("at most 4"), std::string::npos);
  property->IndependentComponentsOff();
  CHECK(!functions.Read(property, 3, error, warning));
  CHECK_NOT_EQUAL(error.find("2 or 4"), std::string::npos);
}
}

int TestTransferFunctions(int, char*[])
{
  RelevoCheck check;
  TestSpike(check);
  TestCurves(check);
  TestIndependent(check);
  TestCuts(check);
  TestDependent(check);
  TestChord(check);
  TestErrors(check);
  return check.GetResult();
}
