// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchErrorDepthTagMetric promises that refined patches deviate by at most ScreenSpaceError,
// for all degrees, weights, positions and patterns.
#include "RelevoCheck.h"
#include "RelevoPatchDistance.h"
#include "RelevoPatches.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellType.h"
#include "vtkDepthTagFilter.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSSource.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace
{
constexpr int Height = 600;

struct Scene
{
  Scene()
  {
    this->Recipe->SetMetric(this->Metric);
    this->Recipe->SetLevelRuleToPerEdge();
    this->Recipe->SetMaximumLevel(7);
    this->Recipe->SetSegmentPolicyToWholeNumbers();
    this->Recipe->SetSurface(vtkNew<vtkPatchSurface>());
    this->Camera->SetPosition(1.5, -2.5, 3.0);
    this->Camera->SetFocalPoint(0.5, 0.5, 0.0);
    this->Camera->SetParallelScale(1.0);
    this->Filter->SetRefinement(this->Recipe);
    this->Filter->SetCamera(this->Camera);
    this->Filter->SetViewportSize(Height + 200, Height);
  }

  vtkPolyData* Refine(vtkPolyData* coarse)
  {
    this->Filter->SetInputData(coarse);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  vtkNew<vtkPatchErrorDepthTagMetric> Metric;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
};

// Largest deviation relative to the allowed one.
double GetShare(Scene& scene, vtkPolyData* coarse)
{
  const RelevoPatchDistance distance(coarse);
  vtkPolyData* refined = scene.Refine(coarse);
  const int stride = static_cast<int>(refined->GetNumberOfPolys() / 4000) | 1;
  return distance.MeasurePixels(refined, scene.Camera, Height, stride) /
    scene.Metric->GetScreenSpaceError();
}

void TestDegrees(RelevoCheck& check)
{
  Scene scene;
  for (int p = 1; p <= 8; ++p)
  {
    for (const bool isRational : { false, true })
    {
      CHECK_CASE(isRational);
      const int q = 9 - p;
      const auto quad = RelevoMakePatches(
        RelevoNewCell(VTK_BEZIER_QUADRILATERAL, { { p, q, 1 } }, 0.3, isRational));
      scene.Metric->SetScreenSpaceError(2.0);
      const double ofQuad = GetShare(scene, quad);
      CHECK_LESS_EQUAL(ofQuad, 1.0);
      CHECK_GREATER(ofQuad, (isRational ? 0.02 : 0.1));
      const auto triangle =
        RelevoMakePatches(RelevoNewCell(VTK_BEZIER_TRIANGLE, { { p, p, 1 } }, 0.3, isRational));
      const double ofTriangle = GetShare(scene, triangle);
      CHECK_LESS_EQUAL(ofTriangle, 1.0);
      CHECK(p == 1 || ofTriangle > (isRational ? 0.06 : 0.1));
    }
  }
}

// Weights vary from 0.1 to 10.
void TestUnevenWeights(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetScreenSpaceError(20.0);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-1.0, 1.0);
  int reached = 0;
  for (int i = 0; i < 6; ++i)
  {
    const int p = 1 + i / 2 % 3;
    const auto cell = RelevoNewCell(
      i % 2 == 0 ? VTK_BEZIER_QUADRILATERAL : VTK_BEZIER_TRIANGLE, { { p, p, 1 } }, 0.3, true);
    vtkDataArray* weights = cell->GetPointData()->GetRationalWeights();
    for (vtkIdType point = 0; point < weights->GetNumberOfTuples(); ++point)
    {
      weights->SetTuple1(point, std::pow(10.0, exponent(random)));
    }
    const auto patches = RelevoMakePatches(cell);
    const int perQuad = i % 2 == 0 ? 2 : 1;
    if (scene.Refine(patches)->GetNumberOfPolys() < perQuad * 128 * 128) // not at the highest level
    {
      ++reached;
      CHECK_LESS_EQUAL(GetShare(scene, patches), 1.0);
    }
  }
  CHECK_GREATER_EQUAL(reached, 4);
}

void TestViews(RelevoCheck& check)
{
  Scene scene;
  const auto patches =
    RelevoMakePatches(RelevoNewCell(VTK_BEZIER_QUADRILATERAL, { { 3, 3, 1 } }, 0.3));
  // Tests all patterns, including powers of two and nested patterns.
  CHECK_LESS_EQUAL(GetShare(scene, patches), 1.0);
  const vtkIdType whole = scene.Refine(patches)->GetNumberOfPolys();
  scene.Recipe->SetSegmentPolicyToPowersOfTwo();
  for (const int morphing :
    { vtkAdaptiveRefinement::GEOMORPHING_OFF, vtkAdaptiveRefinement::GEOMORPHING_ON })
  {
    CHECK_CASE(morphing);
    scene.Recipe->SetGeomorphing(morphing);
    CHECK_LESS_EQUAL(GetShare(scene, patches), 1.0);
    CHECK_GREATER(scene.Refine(patches)->GetNumberOfPolys(), whole);
  }
  scene.Recipe->SetGeomorphing(vtkAdaptiveRefinement::GEOMORPHING_AUTOMATIC);
  scene.Recipe->SetSegmentPolicyToWholeNumbers();
  scene.Camera->ParallelProjectionOn();
  CHECK_LESS_EQUAL(GetShare(scene, patches), 1.0);
  CHECK_GREATER(GetShare(scene, patches), 0.1);
  scene.Camera->ParallelProjectionOff();
  // A smaller error or a nearer camera gives finer triangles.
  scene.Metric->SetScreenSpaceError(0.125);
  const vtkIdType fine = scene.Refine(patches)->GetNumberOfPolys();
  CHECK_GREATER(fine, 3 * whole);
  CHECK_LESS(fine, 5 * whole);
  scene.Metric->SetScreenSpaceError(0.5);
  vtkIdType last = whole;
  for (int turn = 0; turn < 4; ++turn)
  {
    scene.Camera->Dolly(0.5);
    const vtkIdType next = scene.Refine(patches)->GetNumberOfPolys();
    CHECK_LESS(next, last);
    last = next;
  }
  scene.Camera->SetPosition(0.5, 0.5, 0.0);
  scene.Camera->SetFocalPoint(0.5, 0.5, -1.0);
  scene.Recipe->SetMaximumLevel(4);
  // From within, all faces have the highest level.
  CHECK_EQUAL(scene.Refine(patches)->GetNumberOfPolys(), 512);
}

// Vertices of nested patterns have reached their positions, even just below the next level.
void TestMorphing(RelevoCheck& check)
{
  Scene scene;
  scene.Camera->ParallelProjectionOn();
  scene.Recipe->SetSegmentPolicyToPowersOfTwo();
  scene.Recipe->GeomorphingOn();
  const auto patches =
    RelevoMakePatches(RelevoNewCell(VTK_BEZIER_QUADRILATERAL, { { 5, 1, 1 } }, 1.0));
  double most = 0.0;
  for (int step = 0; step < 8; ++step)
  {
    scene.Metric->SetScreenSpaceError(std::exp2(0.25 * step));
    most = std::max(most, GetShare(scene, patches));
  }
  CHECK_LESS_EQUAL(most, 1.0);
  CHECK_GREATER(most, 0.25);
}

// Doubling an actor's size and doubling the viewport give the same levels.
void TestPlacement(RelevoCheck& check)
{
  const auto patches =
    RelevoMakePatches(RelevoNewCell(VTK_BEZIER_QUADRILATERAL, { { 3, 2, 1 } }, 0.3));
  Scene one;
  one.Camera->ParallelProjectionOn();
  one.Filter->SetViewportSize(2 * Height, 2 * Height);
  Scene two;
  two.Camera->ParallelProjectionOn();
  two.Filter->SetViewportSize(Height, Height);
  vtkNew<vtkMatrix4x4> larger;
  larger->SetElement(0, 0, -2.0);
  larger->SetElement(1, 1, 2.0);
  larger->SetElement(2, 2, 2.0);
  two.Filter->SetModelToWorld(larger);
  CHECK_EQUAL(one.Refine(patches)->GetNumberOfPolys(), two.Refine(patches)->GetNumberOfPolys());
}

// Quarter circles of radius 1, for which the angle of a chord is known.
void TestCurves(RelevoCheck& check)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(5.0, 5.0, 0.0);
  points->InsertNextPoint(6.0, 5.0, 0.0);
  points->InsertNextPoint(7.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  lines->InsertNextCell({ 3, 4 });
  lines->InsertNextCell({ 4, 5 });
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  for (double weight : { 1.0, std::sqrt(0.5), 1.0, 1.0, 1.0, 1.0 })
  {
    weights->InsertNextValue(weight);
  }
  vtkNew<vtkPolyData> curves;
  curves->SetPoints(points);
  curves->SetLines(lines);
  curves->GetPointData()->SetRationalWeights(weights);
  Scene scene;
  scene.Camera->ParallelProjectionOn();
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetInputData(curves);
  filter->SetMetric(scene.Metric);
  filter->SetCamera(scene.Camera);
  filter->SetViewportSize(Height, Height);
  filter->SetMaximumLevel(7);
  filter->Update();
  vtkDataArray* tags = filter->GetOutput()->GetPointData()->GetArray("DepthTag");
  CHECK(tags && tags->GetNumberOfTuples() == 6);
  const double tag = tags->GetComponent(0, 0);
  CHECK_EQUAL(tags->GetComponent(1, 0), tag);
  CHECK_EQUAL(tags->GetComponent(2, 0), tag);
  CHECK_EQUAL(tags->GetComponent(3, 0), 0.0);
  CHECK_EQUAL(tags->GetComponent(5, 0), 0.0);
  // With 300 pixels per unit, half a pixel requires a cosine of 1 - 1 / 600.
  const double least = 0.25 * std::acos(-1.0) / std::acos(1.0 - 1.0 / 600.0);
  CHECK_GREATER_EQUAL(std::exp2(tag), least);
  CHECK_LESS_EQUAL(std::exp2(tag), 1.5 * least);

  // Incomplete curves add nothing.
  for (vtkIdType stranger : { vtkIdType(-1), vtkIdType(6), vtkIdType(1) << 40 })
  {
    lines->InsertNextCell({ 3, stranger, 5 });
  }
  curves->Modified();
  filter->Update();
  tags = filter->GetOutput()->GetPointData()->GetArray("DepthTag");
  CHECK_EQUAL(tags->GetComponent(0, 0), tag);
  CHECK_EQUAL(tags->GetComponent(3, 0), 0.0);
  weights->SetNumberOfTuples(2);
  weights->Modified();
  filter->Update();
  tags = filter->GetOutput()->GetPointData()->GetArray("DepthTag");
  CHECK_EQUAL(tags->GetComponent(0, 0), 0.0);
}

using Curve = std::vector<std::array<double, 4>>; // coordinates and weights

// Random weights from 1 / range to range.
Curve MakeRandomCurve(int degree, double range, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Curve curve(degree + 1);
  for (std::array<double, 4>& point : curve)
  {
    point = { share(random), share(random), share(random),
      std::pow(range, 2.0 * share(random) - 1.0) };
  }
  return curve;
}

// Evaluates by de Casteljau's algorithm.
RelevoPosition Evaluate(const Curve& curve, double t)
{
  Curve points = curve;
  for (std::array<double, 4>& point : points)
  {
    for (int i = 0; i < 3; ++i)
    {
      point[i] *= point[3];
    }
  }
  for (std::size_t n = points.size() - 1; n > 0; --n)
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      for (int i = 0; i < 4; ++i)
      {
        points[k][i] += t * (points[k + 1][i] - points[k][i]);
      }
    }
  }
  return { points[0][0] / points[0][3], points[0][1] / points[0][3], points[0][2] / points[0][3] };
}

// Deviation of segments at equal parameter steps.
double MeasureDeviation(const Curve& curve, int segments)
{
  constexpr int parts = 8;
  double most = 0.0;
  for (int segment = 0; segment < segments; ++segment)
  {
    const double first = segment / static_cast<double>(segments);
    const RelevoPosition a = Evaluate(curve, first);
    const RelevoPosition b = Evaluate(curve, (segment + 1) / static_cast<double>(segments));
    for (int part = 1; part < parts; ++part)
    {
      const double share = part / static_cast<double>(parts);
      const RelevoPosition x = Evaluate(curve, first + share / segments);
      double squared = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        squared += std::pow(x[i] - (a[i] + share * (b[i] - a[i])), 2.0);
      }
      most = std::max(most, std::sqrt(squared));
    }
  }
  return most;
}

// Curves of all degrees that 40 segments approximate within the allowed error. If weights differ
// much, a bend may be shorter than a segment, and a bound that falls with the square of the number
// of segments then requires more.
void TestRationalCurves(RelevoCheck& check)
{
  constexpr int enough = 40;
  constexpr double pixels = 300.0; // per unit
  Scene scene;
  scene.Camera->ParallelProjectionOn();
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetMetric(scene.Metric);
  filter->SetCamera(scene.Camera);
  filter->SetViewportSize(Height, Height);
  filter->SetMaximumLevel(7);
  std::mt19937 random(8);
  for (int i = 0; i < 160; ++i)
  {
    const int degree = 1 + i / 2 % 8;
    const bool isEven = i % 2 == 0;
    const Curve curve = MakeRandomCurve(degree, isEven ? 1.6 : 10.0, random);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("RationalWeights");
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(degree + 1);
    for (const std::array<double, 4>& point : curve)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.data()));
      weights->InsertNextValue(point[3]);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    data->GetPointData()->SetRationalWeights(weights);
    const double error = std::max(MeasureDeviation(curve, enough), 0.01 / pixels);
    scene.Metric->SetScreenSpaceError(pixels * error);
    filter->SetInputData(data);
    filter->Update();
    const double tag =
      filter->GetOutput()->GetPointData()->GetArray("DepthTag")->GetComponent(0, 0);
    const int segments = static_cast<int>(std::lround(std::exp2(tag)));
    if (!CHECK(segments == 128 || MeasureDeviation(curve, segments) <= 1.0001 * error) ||
      !CHECK(!isEven || segments <= 1.3 * enough))
    {
      std::cerr << "curve " << i << " of degree " << degree << ": " << segments << " segments\n";
    }
  }
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  RelevoErrors errors(scene.Metric);
  scene.Metric->SetScreenSpaceError(0.0);
  CHECK(errors.Said("ScreenSpaceError must be in [0.001, 1e+06], got 0"));
  CHECK_EQUAL(scene.Metric->GetScreenSpaceError(), 0.5);
  CHECK(scene.Metric->IsAbsolute() && scene.Metric->IsViewDependent());
  RelevoErrors ofFilter(scene.Filter);
  RelevoErrors ofExecutive(scene.Filter->GetExecutive());
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  scene.Recipe->SetSurface(nullptr);
  scene.Refine(sphere->GetOutput());
  CHECK(errors.Said("Cannot measure the patches: there is no array Patches"));
  const auto patches =
    RelevoMakePatches(RelevoNewCell(VTK_BEZIER_QUADRILATERAL, { { 3, 3, 1 } }, 0.3));
  vtkDataArray* points = patches->GetFieldData()->GetArray("PatchPoints");
  const auto spoil = [&](int component, double value, const char* words)
  {
    const double old = points->GetComponent(5, component);
    points->SetComponent(5, component, value);
    points->Modified();
    scene.Refine(patches);
    CHECK(errors.Said(words));
    points->SetComponent(5, component, old);
    points->Modified();
  };
  spoil(0, std::numeric_limits<double>::quiet_NaN(), "control point 5 is not finite");
  spoil(3, 0.0, "control point 5 is not finite, or its weight is not positive");
  scene.Refine(patches);
  CHECK(errors.None());
  scene.Filter->SetCamera(nullptr);
  scene.Refine(patches);
  CHECK(errors.Said("There is no camera: call SetCamera()."));
}
}

int TestPatchErrorDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestDegrees(check);
  TestUnevenWeights(check);
  TestViews(check);
  TestMorphing(check);
  TestPlacement(check);
  TestCurves(check);
  TestRationalCurves(check);
  TestErrors(check);
  return check.GetResult();
}
