// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCurvatureDepthTagMetric promises levels by its formulae for Gaussian and mean curvature,
// compared with values computed by hand and with analytic surfaces.
#include "RelevoCheck.h"
#include "RelevoCurvatures.h"
#include "RelevoDisplacements.h"
#include "RelevoHeights.h"
#include "RelevoTestMeshes.h"

#include "Evaluation/EdgeTags.h"
#include "Mesh/RefinementMesh.h"
#include "Metrics/DiscreteCurvature.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/SurfaceShape.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDataSetAttributes.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStripper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace RelevoCurvatures;

// Each point has four angles of 60 degrees and a third of the area of four equilateral triangles.
void TestOctahedron(RelevoCheck& check)
{
  auto octahedron =
    MakeMesh({ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
      { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
        { 0, 3, 5 } });
  const double area = 4.0 * (std::sqrt(3.0) / 2.0) / 3.0;
  CHECK_NEAR(
    LargestError(Gaussian(octahedron), [=](size_t) { return (2 * Pi / 3) / area; }), 0.0, 1e-12);
  CHECK_NEAR(LargestError(Mean(octahedron), [](size_t) { return 1.0; }), 0.0, 1e-12);

  // With reversed faces the Gaussian curvature stays, and the mean curvature changes its sign.
  octahedron->BuildCells();
  for (vtkIdType cell = 0; cell < 8; ++cell)
  {
    octahedron->ReverseCell(cell);
  }
  CHECK_NEAR(LargestError(Mean(octahedron), [](size_t) { return -1.0; }), 0.0, 1e-12);
}

// A flat pyramid with obtuse angles at its apex. Half of each triangle's area belongs to the apex,
// and border points take its value.
void TestPyramid(RelevoCheck& check)
{
  const double h = 0.1;
  auto pyramid = MakeMesh(
    { { 1, 0, 0 }, { -0.5, std::sqrt(0.75), 0 }, { -0.5, -std::sqrt(0.75), 0 }, { 0, 0, h } },
    { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  const double side = 1.0 + h * h;
  const double angle = std::acos((-0.5 + h * h) / side);
  const double face = 0.5 * side * std::sin(angle);
  const double cotangent = std::cos(0.5 * (Pi - angle)) / std::sin(0.5 * (Pi - angle));
  // Each of the three edges is opposite to two base angles. The edges sum to (0, 0, 3 h).
  const double mean = 2 * cotangent * 3 * h / (4 * 1.5 * face);
  CHECK_NEAR(
    LargestError(Gaussian(pyramid), [=](size_t) { return (2 * Pi - 3 * angle) / (1.5 * face); }),
    0.0, 1e-12);
  CHECK_NEAR(LargestError(Mean(pyramid), [=](size_t) { return mean; }), 0.0, 1e-12);
}

// A triangle's angle at its first corner, and the share of the area that belongs to this corner.
struct Corner
{
  explicit Corner(vtkCell* triangle)
  {
    double x[3][3];
    double length[3]; // opposite to each corner
    for (int i = 0; i < 3; ++i)
    {
      triangle->GetPoints()->GetPoint(i, x[i]);
    }
    for (int i = 0; i < 3; ++i)
    {
      length[i] = std::sqrt(vtkMath::Distance2BetweenPoints(x[(i + 1) % 3], x[(i + 2) % 3]));
    }
    double angles[3];
    for (int i = 0; i < 3; ++i)
    {
      const double b = length[(i + 1) % 3];
      const double c = length[(i + 2) % 3];
      angles[i] = std::acos((b * b + c * c - length[i] * length[i]) / (2 * b * c));
    }
    const double whole = 0.5 * length[1] * length[2] * std::sin(angles[0]);
    this->Angle = angles[0];
    this->Area = angles[0] > Pi / 2             ? whole / 2
      : std::max(angles[1], angles[2]) > Pi / 2 ? whole / 4
                                                : (length[1] * length[1] / std::tan(angles[1]) +
                                                    length[2] * length[2] / std::tan(angles[2])) /
        8;
  }
  double Angle;
  double Area;
};

// Triangles that are obtuse at another corner contribute a quarter of their area. Four points form
// a saddle around the middle point.
void TestObtuse(RelevoCheck& check)
{
  auto saddle = MakeMesh({ { 0, 0, 0 }, { 4, 0, 1 }, { 0, 1, -1 }, { -4, 0, 1 }, { 0, -1, -1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 } });
  const double a = std::acos(-1.0 / std::sqrt(17.0 * 2.0)); // this angle, at the middle, is obtuse
  const double triangle = 0.5 * std::sqrt(34.0) * std::sin(a);
  CHECK_NEAR(Gaussian(saddle)[0], (2 * Pi - 4 * a) / (2 * triangle), 1e-12);
  auto roof = MakeMesh({ { 0, 0, 1 }, { 1, 0, 0 }, { 1.2, 0.2, -3 }, { -1, 1, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 } });
  double sum = 0.0;
  double mixed = 0.0;
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    const Corner corner(roof->GetCell(cell));
    sum += corner.Angle;
    mixed += corner.Area;
  }
  CHECK_NEAR(Gaussian(roof)[0], (2 * Pi - sum) / mixed, 1e-12);
}

void TestAnalytic(RelevoCheck& check)
{
  const double r = 2.0;
  double previous[2] = { 1.0, 1.0 };
  for (int subdivisions : { 2, 3, 4 })
  {
    CHECK_CASE(subdivisions);
    auto sphere = MakeSphere(r, subdivisions);
    const double gaussian =
      LargestError(Gaussian(sphere), [=](size_t) { return 1 / (r * r); }) * r * r;
    const double mean = LargestError(Mean(sphere), [=](size_t) { return 1 / r; }) * r;
    std::cout << "sphere, " << sphere->GetNumberOfPolys() << " triangles: largest relative error "
              << gaussian << " (Gaussian), " << mean << " (mean)\n";
    CHECK_LESS(gaussian, 0.05);
    CHECK_LESS(mean, 0.02);
    CHECK(gaussian < previous[0] && mean < previous[1]);
    previous[0] = gaussian;
    previous[1] = mean;
  }

  // A torus has Gaussian curvature of both signs. Its seams are split points.
  const double ring = 3.0;
  const double tube = 1.0;
  auto torus = MakeTorus(ring, tube, 180, 60);
  const auto angle = [](size_t id) { return 2 * Pi * static_cast<double>(id / 181) / 60; };
  const double gaussian = LargestError(Gaussian(torus),
    [=](size_t id) { return std::cos(angle(id)) / (tube * (ring + tube * std::cos(angle(id)))); });
  const double mean = LargestError(Mean(torus),
    [=](size_t id)
    {
      return (ring + 2 * tube * std::cos(angle(id))) /
        (2 * tube * (ring + tube * std::cos(angle(id))));
    });
  std::cout << "torus: largest error " << gaussian << " of 0.5 (Gaussian), " << mean
            << " of 0.625 (mean)\n";
  CHECK_LESS(gaussian, 0.005);
  CHECK_LESS(mean, 0.005);

  // On an open cylinder and a hemisphere, curvature reaches the border.
  auto cylinder = MakeGrid(90, 20,
    [](double u, double v, double x[3])
    {
      x[0] = 2 * std::cos(2 * Pi * std::fmod(u, 1.0));
      x[1] = 2 * std::sin(2 * Pi * std::fmod(u, 1.0));
      x[2] = 3 * v;
    });
  CHECK_NEAR(LargestError(Gaussian(cylinder), [](size_t) { return 0.0; }), 0.0, 1e-9);
  CHECK_NEAR(LargestError(Mean(cylinder), [](size_t) { return 0.25; }), 0.0, 1e-3);
  auto cap = MakeGrid(40, 40,
    [](double u, double v, double x[3])
    {
      x[0] = 0.6 * (2 * u - 1);
      x[1] = 0.6 * (2 * v - 1);
      x[2] = std::sqrt(1.0 - x[0] * x[0] - x[1] * x[1]);
    });
  CHECK_NEAR(LargestError(Gaussian(cap), [](size_t) { return 1.0; }), 0.0, 0.05);
  CHECK_NEAR(LargestError(Mean(cap), [](size_t) { return 1.0; }), 0.0, 0.05);
}

// Polygons, strips, split points and the order of cells do not change the result.
void TestRepresentations(RelevoCheck& check)
{
  auto torus = MakeTorus(3.0, 1.0, 30, 20);
  const auto gaussian = Gaussian(torus);
  const auto mean = Mean(torus);

  vtkNew<vtkPolyData> fans;
  fans->SetPoints(torus->GetPoints());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType cell = 0; cell < torus->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    torus->GetCellPoints(cell, ids);
    const vtkIdType fan[2][3] = { { ids->GetId(0), ids->GetId(1), ids->GetId(2) },
      { ids->GetId(0), ids->GetId(2), ids->GetId(3) } };
    cells->InsertNextCell(3, fan[0]);
    cells->InsertNextCell(3, fan[1]);
  }
  fans->SetPolys(cells);
  CHECK_NEAR(LargestDifference(Gaussian(fans), gaussian), 0.0, 1e-11);
  CHECK_NEAR(LargestDifference(Mean(fans), mean), 0.0, 1e-11);

  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(fans);
  stripper->Update();
  vtkPolyData* strips = stripper->GetOutput();
  CHECK_GREATER(strips->GetNumberOfStrips(), 0);
  CHECK_LESS(strips->GetNumberOfPolys(), 100);
  CHECK_NEAR(LargestDifference(Gaussian(strips), gaussian), 0.0, 1e-11);
  CHECK_NEAR(LargestDifference(Mean(strips), mean), 0.0, 1e-11);

  // All triangles have separate points.
  vtkNew<vtkPolyData> soup;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> own;
  std::vector<double> expected;
  for (vtkIdType cell = 0; cell < fans->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    fans->GetCellPoints(cell, ids);
    own->InsertNextCell(3);
    for (vtkIdType id : { ids->GetId(0), ids->GetId(1), ids->GetId(2) })
    {
      own->InsertCellPoint(points->InsertNextPoint(fans->GetPoint(id)));
      expected.push_back(mean[id]);
    }
  }
  soup->SetPoints(points);
  soup->SetPolys(own);
  CHECK_NEAR(LargestDifference(Mean(soup), expected), 0.0, 1e-11);
}

// By default, levels follow the absolute Gaussian curvature: linear between the thresholds and
// clamped outside.
void TestThresholds(RelevoCheck& check)
{
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  vtkNew<vtkFloatArray> tags;
  vtkNew<vtkDoubleArray> curvatures;
  const relevo::RefinementView view;
  CHECK(!metric->IsViewDependent());
  CHECK_EQUAL(metric->GetCurvatureType(), vtkCurvatureDepthTagMetric::GAUSSIAN);

  auto torus = MakeTorus(3.0, 1.0, 60, 40);
  metric->SetMinimumCurvature(0.1);
  metric->SetMaximumCurvature(0.3);
  metric->ComputeCurvatures(torus, curvatures);
  CHECK_EQUAL(std::string(curvatures->GetName()), "Gauss_Curvature");
  CHECK(metric->ComputeTags(torus, view, 6, tags));
  double error = 0.0;
  std::set<float> ends;
  for (vtkIdType id = 0; id < torus->GetNumberOfPoints(); ++id)
  {
    const double k = std::abs(curvatures->GetValue(id));
    const double level = 6.0 * std::min(std::max((k - 0.1) / 0.2, 0.0), 1.0);
    error = std::max(error, std::abs(tags->GetValue(id) - level));
    ends.insert(tags->GetValue(id));
  }
  CHECK_NEAR(error, 0.0, 1e-5);
  CHECK(*ends.begin() == 0.0f && *ends.rbegin() == 6.0f && ends.size() > 10);
  metric->SetCurvatureTypeToMean();
  metric->ComputeCurvatures(torus, curvatures);
  CHECK_EQUAL(std::string(curvatures->GetName()), "Mean_Curvature");
  CHECK_NEAR(curvatures->GetValue(0), 0.625, 0.01);
  metric->SetMaximumCurvature(0.1); // a step function
  CHECK(metric->ComputeTags(torus, view, 6, tags));
  CHECK_EQUAL(tags->GetRange()[0], 6.0);
}

// A sphere is curved everywhere and a plane nowhere, in every orientation.
void TestAutomaticThresholds(RelevoCheck& check)
{
  vtkNew<vtkCurvatureDepthTagMetric> metric; // thresholds of 0
  vtkNew<vtkFloatArray> tags;
  const relevo::RefinementView view;
  vtkNew<vtkTransform> transform;
  transform->RotateX(37.0);
  transform->RotateZ(11.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetTransform(transform);
  turned->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  turned->SetInputData(MakeGrid(200, 100,
    [](double u, double v, double x[3])
    {
      x[0] = 40 * u + 3 * std::sin(5 * v);
      x[1] = 20 * v;
      x[2] = 0.0;
    }));
  turned->Update();
  auto torus = MakeTorus(3.0, 1.0, 60, 40);
  for (int type : { vtkCurvatureDepthTagMetric::GAUSSIAN, vtkCurvatureDepthTagMetric::MEAN })
  {
    metric->SetCurvatureType(type);
    CHECK(metric->ComputeTags(turned->GetOutput(), view, 7, tags));
    CHECK(tags->GetNumberOfTuples() == 201 * 101 && tags->GetRange()[1] < 0.5);
    CHECK(metric->ComputeTags(MakeSphere(10.0, 3), view, 7, tags));
    CHECK(tags->GetRange()[0] > 6.0 && tags->GetRange()[1] == 7.0);
    // A box is curved only at its few corners. Its flat faces stay coarse.
    CHECK(metric->ComputeTags(torus, view, 7, tags));
    CHECK(tags->GetRange()[0] < 3.5 && tags->GetRange()[1] == 7.0);
  }
}

// Quantiles: given shares of the points have level 0 and the highest level.
void TestQuantiles(RelevoCheck& check)
{
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  metric->SetCurvatureTypeToMean();
  vtkNew<vtkFloatArray> tags;
  const relevo::RefinementView view;
  CHECK(metric->GetQuantiles()[0] == 0.0 && metric->GetQuantiles()[1] == 0.95);
  auto bumps = MakeGrid(80, 80,
    [](double u, double v, double x[3])
    {
      x[0] = u;
      x[1] = v;
      x[2] = 0.1 * std::sin(7 * u + 2 * v * v) * std::cos(5 * v - u * u);
    });
  for (const auto& quantiles : { std::array<double, 2>{ { 0.0, 0.5 } },
         std::array<double, 2>{ { 0.3, 0.8 } }, std::array<double, 2>{ { 0.9, 1.0 } } })
  {
    metric->SetQuantiles(quantiles.data());
    CHECK(metric->ComputeTags(bumps, view, 7, tags));
    double none = 0.0;
    double most = 0.0;
    for (vtkIdType id = 0; id < tags->GetNumberOfTuples(); ++id)
    {
      none += tags->GetValue(id) == 0.0f;
      most += tags->GetValue(id) == 7.0f;
    }
    const auto n = static_cast<double>(tags->GetNumberOfTuples());
    CHECK_NEAR(none / n, quantiles[0], 0.002);
    CHECK_NEAR(most / n, 1.0 - quantiles[1], 0.002);
  }
  metric->SetQuantiles(0.3, 0.8);
  RelevoErrors errors(metric);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double bad[][2] = { { -0.1, 0.5 }, { 0.5, 0.5 }, { 0.6, 0.5 }, { 0.5, 1.1 }, { nan, 0.5 },
    { 0.5, nan } };
  for (const double* quantiles : bad)
  {
    metric->SetQuantiles(quantiles);
    CHECK(errors.Said("Quantiles") && metric->GetQuantiles()[0] == 0.3);
  }
}

// Results cached for evaluators are reused until the mesh changes.
void TestKept(RelevoCheck& check)
{
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  vtkNew<vtkDoubleArray> curvatures;
  auto sphere = MakeSphere(1.0, 2);
  metric->SetCurvatureTypeToMean();
  metric->ComputeCurvatures(sphere, curvatures);
  const double before = curvatures->GetValue(0);
  relevo::MetricMesh mesh(sphere);
  CHECK_EQUAL(relevo::GetShape(mesh).GetCurvature().Mean[0], before);
  sphere->GetPoints()->SetPoint(0, 0, 0, 0);
  mesh.Update(sphere);
  CHECK_EQUAL(relevo::GetShape(mesh).GetCurvature().Mean[0], before);
  sphere->GetPoints()->Modified();
  mesh.Update(sphere);
  CHECK_NOT_EQUAL(relevo::GetShape(mesh).GetCurvature().Mean[0], before);
  metric->ComputeCurvatures(sphere, curvatures);
  CHECK_NOT_EQUAL(curvatures->GetValue(0), before);
}

void TestBadInput(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  vtkNew<vtkFloatArray> tags;
  const relevo::RefinementView view;

  // The mesh has repeated points, triangles without area, an edge with three triangles, unused
  // points, NaN points, cells of one and two points, and invalid ids.
  auto broken = MakeMesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 }, { 2, 0, 0 }, { nan, 0, 0 },
      { 0, infinity, 0 }, { 1e200, 1e200, 0 }, { 0, 0, 0 }, { 1e-200, 0, 0 }, { 0, 1e-200, 0 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 }, { 0, 1, 1 }, { 0, 1, 5 }, { 1, 2, 6 }, { 1, 2, 7 },
      { 2, 3, 8 }, { 9, 2, 3 }, { 0, 0, 0 }, { 0, 10, 11 }, { 1 }, { 1, 2 }, { 1, 2, 99 },
      { 1, 2, -5 }, { 0, 1, 2, 3, 4, 5, 6 } });
  for (int type : { vtkCurvatureDepthTagMetric::GAUSSIAN, vtkCurvatureDepthTagMetric::MEAN })
  {
    CHECK_CASE(type);
    metric->SetCurvatureType(type);
    for (double value : Curvatures(broken, type))
    {
      CHECK(std::isfinite(value));
    }
    CHECK(metric->ComputeTags(broken, view, 5, tags));
    for (vtkIdType id = 0; id < tags->GetNumberOfTuples(); ++id)
    {
      CHECK_GREATER_EQUAL(tags->GetValue(id), 0.0f);
      CHECK_LESS_EQUAL(tags->GetValue(id), 5.0f);
    }
    CHECK_EQUAL(tags->GetValue(6), 0.0f);
    CHECK_EQUAL(tags->GetValue(7), 0.0f);
  }
  // A triangle without area within a plane does not add curvature.
  auto plane = MakeGrid(4, 4,
    [](double u, double v, double x[3])
    {
      x[0] = u;
      x[1] = v;
      x[2] = 0.0;
    });
  const vtkIdType flat[3] = { 6, 7, 8 };
  plane->GetPolys()->InsertNextCell(3, flat);
  CHECK_NEAR(LargestError(Gaussian(plane), [](size_t) { return 0.0; }), 0.0, 1e-12);

  vtkNew<vtkPolyData> empty;
  CHECK(metric->ComputeTags(empty, view, 5, tags) && tags->GetNumberOfTuples() == 0);
  auto cloud = MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  CHECK(metric->ComputeTags(cloud, view, 5, tags) && tags->GetRange()[1] == 0.0);

  RelevoErrors errors(metric);
  metric->SetCurvatureTypeToMean();
  metric->SetCurvatureType(2);
  CHECK(errors.Said("CurvatureType must be one of GAUSSIAN (0), MEAN (1), got 2"));
  CHECK_EQUAL(metric->GetCurvatureType(), vtkCurvatureDepthTagMetric::MEAN);
  for (double bad : { -1.0, nan, infinity })
  {
    CHECK_CASE(bad);
    metric->SetMinimumCurvature(bad);
    CHECK(errors.Said("MinimumCurvature"));
    metric->SetMaximumCurvature(bad);
    CHECK(errors.Said("MaximumCurvature"));
    CHECK_EQUAL(metric->GetMinimumCurvature(), 0.0);
    CHECK_EQUAL(metric->GetMaximumCurvature(), 0.0);
  }
  metric->SetMinimumCurvature(2.0);
  metric->SetMaximumCurvature(1.0);
  CHECK(!metric->ComputeTags(broken, view, 5, tags));
  CHECK(errors.Said("above MaximumCurvature"));
}

vtkSmartPointer<vtkPolyData> MakePlane(int resolution)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(resolution, resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(vtkHeightField* heights, int level)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  metric->SetCurvatureTypeToMean();
  recipe->SetMetric(metric);
  recipe->SetMaximumLevel(level);
  recipe->SetDisplacement(RelevoMeshes::MakeDisplacementAlong(0, 0, 1, heights, 1.0));
  return recipe;
}

// The tags of a recipe, by point. `tags` caches evaluators.
std::vector<float> UpdateTags(
  RelevoCheck& check, relevo::EdgeTags& tags, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  relevo::RefinementMesh refined;
  CHECK(refined.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
  std::string error;
  CHECK(tags.Compute(recipe, mesh, refined, relevo::RefinementView(), error));
  return { tags.GetValues(), tags.GetValues() + tags.GetNumberOfValues() };
}

std::vector<float> GetTags(
  RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, int type)
{
  auto* metric = vtkCurvatureDepthTagMetric::SafeDownCast(recipe->GetMetric());
  metric->SetCurvatureType(type);
  relevo::EdgeTags tags;
  return UpdateTags(check, tags, mesh, recipe);
}

// Height-map bumps between the points of a mesh, all at height 0: four times as high on the right
// as on the left, none in the middle. Four times the curvature gives the same distance from
// triangles with edges of half the length.
void TestDisplaced(RelevoCheck& check)
{
  const int squares = 16;
  vtkNew<RelevoHeights> heights;
  heights->Fill(512, 512,
    [](double x, double y)
    {
      const double bumps = std::pow(std::sin(Pi * 16 * x) * std::sin(Pi * 16 * y), 2.0);
      return x < 0.25 ? 0.0005 * bumps : x > 0.75 ? 0.002 * bumps : 0.0;
    });
  const auto mesh = MakePlane(squares);
  const auto recipe = MakeRecipe(heights, 5);
  for (const int type : { vtkCurvatureDepthTagMetric::MEAN, vtkCurvatureDepthTagMetric::GAUSSIAN })
  {
    const std::vector<float> tags = GetTags(check, mesh, recipe, type);
    for (int y = 2; y < squares - 1; ++y)
    {
      const float* row = &tags[static_cast<size_t>(y * (squares + 1))];
      CHECK_NEAR(row[14], 5.0, 1e-3); // the largest value, which the automatic threshold selects
      CHECK_NEAR(row[2], 4.0, 0.05);
      CHECK_NEAR(row[8], 0.0, 0.0);
    }
  }
  // Without the displacement the mesh is flat.
  recipe->SetDisplacement(nullptr);
  const std::vector<float> flat = GetTags(check, mesh, recipe, vtkCurvatureDepthTagMetric::MEAN);
  CHECK_EQUAL(*std::max_element(flat.begin(), flat.end()), 0.0f);
}

// A composite of one metric has that metric's tags, even after the displacement changes.
void TestComposite(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(64, 64, 7);
  const auto mesh = MakePlane(8);
  const auto recipe = MakeRecipe(heights, 4);
  vtkSmartPointer<vtkDepthTagMetric> metric = recipe->GetMetric();
  vtkCurvatureDepthTagMetric::SafeDownCast(metric)->SetMaximumCurvature(200.0);
  vtkNew<vtkCompositeDepthTagMetric> composite;
  composite->AddMetric(metric, 1.0);
  relevo::EdgeTags cached[2];
  std::vector<float> last;
  const std::function<void()> changes[] = { [] {},
    [&] { recipe->GetDisplacement()->SetScale(0.01); },
    [&] { heights->Fill(64, 64, [](double x, double) { return 10.0 * x * x * x; }); },
    [&] { recipe->SetDisplacement(nullptr); } };
  for (const auto& change : changes)
  {
    change();
    recipe->SetMetric(composite);
    const std::vector<float> combined = UpdateTags(check, cached[0], mesh, recipe);
    recipe->SetMetric(metric);
    CHECK_EQUAL(combined, UpdateTags(check, cached[1], mesh, recipe));
    relevo::EdgeTags fresh;
    CHECK_EQUAL(combined, UpdateTags(check, fresh, mesh, recipe));
    CHECK_NOT_EQUAL(combined, last);
    last = combined;
  }
}

// Root mean square of the vertical distance of a refined mesh from heights that are bilinear
// between samples.
double GetError(vtkPolyData* mesh, vtkHeightField* heights)
{
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  double sum = 0.0;
  double area = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetCellPoints(cell, size, ids);
    double x[3][3];
    double t[3][2];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids[i], x[i]);
      coordinates->GetTuple(ids[i], t[i]);
    }
    const double weight = std::abs(
      (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]));
    const int fine = 1 + static_cast<int>(std::sqrt(weight) * 256);
    double cellSum = 0.0;
    int count = 0;
    for (int i = 0; i < fine; ++i)
    {
      for (int j = 0; i + j < fine; ++j)
      {
        const double v = (i + 1.0 / 3.0) / fine;
        const double w = (j + 1.0 / 3.0) / fine;
        const double u = 1.0 - v - w;
        const auto mix = [&](double a, double b, double c) { return u * a + v * b + w * c; };
        const double off = mix(x[0][2], x[1][2], x[2][2]) -
          heights->GetHeight(mix(t[0][0], t[1][0], t[2][0]), mix(t[0][1], t[1][1], t[2][1]));
        cellSum += off * off;
        ++count;
      }
    }
    sum += weight * cellSum / count;
    area += weight;
  }
  return std::sqrt(sum / area);
}

// For terrain that is rough at one end, the metric gives a smaller error than uniform levels with
// no fewer triangles.
void TestError(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(256, 256,
    [](double x, double y)
    {
      double height = 0.1 * std::sin(5 * x + 2 * y);
      for (int octave = 3; octave < 7; ++octave)
      {
        const double f = 1 << octave;
        height += x * x * std::sin(f * (6 * x + y) + octave) * std::cos(f * (5 * y - x)) / (5 * f);
      }
      return height;
    });
  const auto recipe = MakeRecipe(heights, 4);
  recipe->SetLevelOffset(-0.75);
  const auto refined = RelevoMeshes::Refine(MakePlane(16), recipe);
  const int even =
    static_cast<int>(std::ceil(std::sqrt(0.5 * static_cast<double>(refined->GetNumberOfPolys()))));
  const auto plain = MakeRecipe(heights, 0);
  const auto equal = RelevoMeshes::Refine(MakePlane(even), plain);
  const double errors[2] = { GetError(refined, heights), GetError(equal, heights) };
  std::cout << refined->GetNumberOfPolys() << " triangles by curvature, error " << errors[0] << "; "
            << equal->GetNumberOfPolys() << " of equal size, error " << errors[1] << std::endl;
  CHECK_LESS_EQUAL(refined->GetNumberOfPolys(), equal->GetNumberOfPolys());
  CHECK_LESS(errors[0], 0.9 * errors[1]);
}

// Pieces with a layer of ghost cells have the same levels as the whole mesh.
void TestPieces(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(64, 64, 7);
  const auto whole = MakePlane(12);
  const auto recipe = MakeRecipe(heights, 4);
  auto* metric = vtkCurvatureDepthTagMetric::SafeDownCast(recipe->GetMetric());
  metric->SetMaximumCurvature(200.0); // fixed, because automatic thresholds need all pieces
  const vtkIdType expected = RelevoMeshes::Refine(whole, recipe)->GetNumberOfPolys();
  vtkIdType sum = 0;
  for (const bool isRight : { false, true })
  {
    vtkNew<vtkPolyData> piece;
    piece->DeepCopy(whole);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
    {
      const bool isOwn = (cell % 12 >= 5) == isRight;
      ghosts->InsertNextValue(isOwn ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
    piece->GetCellData()->AddArray(ghosts);
    sum += RelevoMeshes::Refine(piece, recipe)->GetNumberOfPolys();
  }
  CHECK_EQUAL(sum, expected);
  CHECK_GREATER(expected, whole->GetNumberOfCells() * 8);
}
}

int TestCurvatureDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestOctahedron(check);
  TestPyramid(check);
  TestObtuse(check);
  TestAnalytic(check);
  TestRepresentations(check);
  TestThresholds(check);
  TestAutomaticThresholds(check);
  TestQuantiles(check);
  TestKept(check);
  TestBadInput(check);
  TestDisplaced(check);
  TestComposite(check);
  TestError(check);
  TestPieces(check);
  return check.GetResult();
}
