// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightErrorDepthTagMetric promises that refined triangles deviate from the displaced surface
// by at most MaximumError or ScreenSpaceError, for all patterns, with fewer triangles than uniform
// refinement, and without cracks.
#include "RelevoCheck.h"
#include "RelevoHeights.h"
#include "RelevoSanitizer.h"
#include "RelevoWatertight.h"

#include "Evaluation/MeshPreparation.h"
#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDisplacement.h"
#include "vtkExecutive.h"
#include "vtkHeightErrorDepthTagMetric.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr int Size = 65; // texels
constexpr int ViewportHeight = 600;
constexpr double Tolerance = 1.001; // for floats

using Function = std::function<double(double, double)>;

double Bump(double x, double y)
{
  const double r = std::hypot(x - 0.4, y - 0.55);
  return 0.3 * std::exp(-30.0 * r * r);
}

double Ridge(double x, double y)
{
  return 0.2 * std::max(0.0, 1.0 - 8.0 * std::abs(x + 0.4 * y - 0.6));
}

double Step(double x, double y)
{
  return x > 0.31 && y > 0.42 ? 0.1 : 0.0;
}

double Noise(double x, double y)
{
  const double wave = std::sin(12.9898 * 64.0 * x + 78.233 * 64.0 * y) * 43758.5453;
  return 0.02 * (wave - std::floor(wave));
}

// A plane of triangles over the unit square. `bend` tilts the normals away from the middle.
vtkSmartPointer<vtkPolyData> MakePlane(int squares, double bend = 0.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(1.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 1.0, 0.0);
  plane->SetResolution(squares, squares);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> mesh = triangles->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    double normal[3] = { bend * (x[0] - 0.5), bend * (x[1] - 0.5), 1.0 };
    vtkMath::Normalize(normal);
    mesh->GetPointData()->GetNormals()->SetTuple(i, normal);
  }
  return mesh;
}

struct Scene
{
  Scene()
  {
    this->Heights->Fill(Size, Size, &Bump);
    this->Displacement->SetHeightMap(this->Heights);
    this->Recipe->SetMetric(this->Metric);
    this->Recipe->SetDisplacement(this->Displacement);
    this->Recipe->SetMaximumLevel(6);
    this->Filter->SetRefinement(this->Recipe);
    this->Filter->SetCamera(this->Camera);
    this->Filter->SetViewportSize(ViewportHeight + 200, ViewportHeight);
    this->Camera->SetPosition(0.5, -1.0, 1.0);
    this->Camera->SetFocalPoint(0.5, 0.5, 0.0);
  }

  vtkPolyData* Refine(vtkPolyData* coarse)
  {
    this->Filter->SetInputData(coarse);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  vtkNew<RelevoHeights> Heights;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkHeightErrorDepthTagMetric> Metric;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkAdaptiveRefinementFilter> Filter;
};

// Samples the triangles of a refined mesh densely and passes each point with the point of the
// surface that has the same weights to a function.
class Comparison
{
public:
  using Visit = std::function<void(const double drawn[3], const double surface[3])>;

  Comparison(Scene& scene, vtkPolyData* coarse)
    : Heights(scene.Heights)
    , Displacement(scene.Displacement)
  {
    std::string error;
    std::string warning;
    relevo::PrepareMesh(coarse, scene.Recipe, nullptr, this->Mesh, error, warning);
    this->Evaluator = std::make_unique<relevo::RefinementEvaluator>(this->Mesh, scene.Recipe.Get());
    this->IsFlat = !scene.Recipe->GetSurface() && !scene.Displacement->IsAlongNormal();
  }

  void ForEach(vtkPolyData* refined, int parts, const Visit& visit)
  {
    vtkDataArray* coordinates = refined->GetPointData()->GetTCoords();
    auto* cells =
      vtkIdTypeArray::SafeDownCast(refined->GetCellData()->GetArray("vtkOriginalCellIds"));
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
    {
      refined->GetCellPoints(cell, ids);
      for (int i = 0; i <= parts; ++i)
      {
        for (int j = 0; i + j <= parts; ++j)
        {
          const double shares[3] = { static_cast<double>(i) / parts, static_cast<double>(j) / parts,
            static_cast<double>(parts - i - j) / parts };
          double drawn[3] = { 0.0, 0.0, 0.0 };
          double uv[2] = { 0.0, 0.0 };
          for (int k = 0; k < 3; ++k)
          {
            double x[3];
            refined->GetPoint(ids->GetId(k), x);
            for (int c = 0; c < 3; ++c)
            {
              drawn[c] += shares[k] * x[c];
            }
            uv[0] += shares[k] * coordinates->GetComponent(ids->GetId(k), 0);
            uv[1] += shares[k] * coordinates->GetComponent(ids->GetId(k), 1);
          }
          if (this->Heights->IsValid(uv[0], uv[1]))
          {
            double surface[3];
            this->Evaluate(cells->GetValue(cell), uv, drawn, surface);
            visit(drawn, surface);
          }
        }
      }
    }
  }

private:
  void Evaluate(vtkIdType cell, const double uv[2], const double drawn[3], double surface[3])
  {
    if (this->IsFlat) // in doubles
    {
      std::copy_n(drawn, 2, surface);
      surface[2] = this->Displacement->GetOffset() +
        this->Displacement->GetScale() * this->Heights->GetHeight(uv[0], uv[1]);
      return;
    }
    const relevo::RefinementFace& face = this->Mesh.Faces[cell];
    const auto get = [&](int corner, int axis) -> double
    {
      return this->Mesh
        .TextureCoordinates[2 * static_cast<std::size_t>(face.Corners[corner]) + axis];
    };
    const double p[2] = { get(1, 0) - get(0, 0), get(1, 1) - get(0, 1) };
    const double q[2] = { get(2, 0) - get(0, 0), get(2, 1) - get(0, 1) };
    const double r[2] = { uv[0] - get(0, 0), uv[1] - get(0, 1) };
    const double area = p[0] * q[1] - p[1] * q[0];
    const double v = (r[0] * q[1] - r[1] * q[0]) / area;
    const double w = (p[0] * r[1] - p[1] * r[0]) / area;
    const float weights[3] = { static_cast<float>(1.0 - v - w), static_cast<float>(v),
      static_cast<float>(w) };
    float position[3];
    float normal[3];
    this->Evaluator->Evaluate(static_cast<int>(cell), weights, position, normal);
    for (int c = 0; c < 3; ++c)
    {
      surface[c] = this->Mesh.Origin[c] + position[c];
    }
  }

  RelevoHeights* Heights;
  vtkDisplacement* Displacement;
  relevo::RefinementMesh Mesh;
  std::unique_ptr<relevo::RefinementEvaluator> Evaluator;
  bool IsFlat;
};

double MeasureLength(Scene& scene, vtkPolyData* coarse, vtkPolyData* refined, int parts = 4)
{
  double largest = 0.0;
  Comparison(scene, coarse)
    .ForEach(refined, parts,
      [&](const double drawn[3], const double surface[3])
      { largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(drawn, surface))); });
  return largest;
}

// Projects a point to pixels. Returns false if it is outside of the viewport.
bool Project(vtkMatrix4x4* matrix, const double x[3], double pixels[2])
{
  const double in[4] = { x[0], x[1], x[2], 1.0 };
  double out[4];
  matrix->MultiplyPoint(in, out);
  const double aspect = (ViewportHeight + 200.0) / ViewportHeight;
  pixels[0] = 0.5 * ViewportHeight * aspect * out[0] / out[3];
  pixels[1] = 0.5 * ViewportHeight * out[1] / out[3];
  return out[3] > 0.0 && std::abs(out[0]) <= out[3] && std::abs(out[1]) <= out[3];
}

double MeasurePixels(Scene& scene, vtkPolyData* coarse, vtkPolyData* refined)
{
  vtkMatrix4x4* matrix = scene.Camera->GetCompositeProjectionTransformMatrix(
    (ViewportHeight + 200.0) / ViewportHeight, -1.0, 1.0);
  double largest = 0.0;
  Comparison(scene, coarse)
    .ForEach(refined, 4,
      [&](const double drawn[3], const double surface[3])
      {
        double a[2];
        double b[2];
        if (Project(matrix, drawn, a) && Project(matrix, surface, b))
        {
          largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1]));
        }
      });
  return largest;
}

// Whether each edge has two triangles, except at the border of the texture.
bool IsClosed(vtkPolyData* mesh)
{
  const std::vector<vtkIdType> places = RelevoWatertight::Weld(mesh->GetPoints(), false);
  RelevoWatertight::EdgeUses edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    const vtkIdType w[3] = { places[ids->GetId(0)], places[ids->GetId(1)], places[ids->GetId(2)] };
    for (int i = 0; i < 3 && w[0] != w[1] && w[1] != w[2] && w[2] != w[0]; ++i)
    {
      RelevoWatertight::Use(edges, w[i], w[(i + 1) % 3]);
    }
  }
  for (const auto& edge : edges)
  {
    double a[3];
    double b[3];
    mesh->GetPointData()->GetTCoords()->GetTuple(edge.first.first, a);
    mesh->GetPointData()->GetTCoords()->GetTuple(edge.first.second, b);
    bool isBorder = false;
    for (int axis = 0; axis < 2; ++axis)
    {
      isBorder = isBorder || (a[axis] == b[axis] && (a[axis] == 0.0 || a[axis] == 1.0));
    }
    if (!isBorder && edge.second != RelevoWatertight::Uses(1, 1))
    {
      return false;
    }
  }
  return true;
}

struct Map
{
  const char* Name;
  Function Heights;
  double Error;
};

std::vector<Map> GetMaps()
{
  return { { "bump", &Bump, 0.002 }, { "ridge", &Ridge, 0.004 }, { "step", &Step, 0.012 },
    { "noise", &Noise, 0.012 } };
}

// All patterns and both rules, to a length.
void TestLengths(RelevoCheck& check)
{
  for (const Map& map : GetMaps())
  {
    CHECK_CASE(map.Name);
    Scene scene;
    scene.Heights->Fill(Size, Size, map.Heights);
    scene.Displacement->SetDirection(0.0, 0.0, 1.0);
    scene.Recipe->SetMaximumLevel(7);
    const auto coarse = MakePlane(3);
    for (int pattern = 0; pattern < 3; ++pattern)
    {
      CHECK_CASE(pattern);
      scene.Recipe->SetSegmentPolicy(pattern == 1 ? 1 : 0);
      scene.Recipe->SetGeomorphing(pattern == 2 ? 1 : 0);
      vtkIdType last = std::numeric_limits<vtkIdType>::max();
      for (int rule = 0; rule < 2; ++rule)
      {
        CHECK_CASE(rule);
        scene.Recipe->SetLevelRule(rule);
        scene.Metric->SetMaximumError(map.Error);
        vtkPolyData* refined = scene.Refine(coarse);
        CHECK_LESS_EQUAL(MeasureLength(scene, coarse, refined), map.Error * Tolerance);
        CHECK(IsClosed(refined));
        CHECK_GREATER(refined->GetNumberOfPolys(), 3 * coarse->GetNumberOfPolys());
        CHECK_LESS_EQUAL(refined->GetNumberOfPolys(), last);
        last = refined->GetNumberOfPolys();
      }
    }
  }
}

void TestTriangles(RelevoCheck& check)
{
  for (const Map& map : GetMaps())
  {
    if (map.Name == std::string("noise"))
    {
      continue; // needs the highest level everywhere
    }
    CHECK_CASE(map.Name);
    Scene scene;
    scene.Heights->Fill(Size, Size, map.Heights);
    scene.Displacement->SetDirection(0.0, 0.0, 1.0);
    scene.Recipe->SetLevelRuleToPerEdge();
    const auto coarse = MakePlane(6);
    scene.Recipe->SetMetric(nullptr);
    scene.Recipe->SetMaximumLevel(4);
    vtkPolyData* refined = scene.Refine(coarse);
    const vtkIdType uniform = refined->GetNumberOfPolys();
    const double error = MeasureLength(scene, coarse, refined, 12);
    scene.Recipe->SetMetric(scene.Metric);
    scene.Recipe->SetMaximumLevel(6);
    scene.Metric->SetMaximumError(error);
    refined = scene.Refine(coarse);
    CHECK_LESS_EQUAL(MeasureLength(scene, coarse, refined), error * Tolerance);
    CHECK_LESS_EQUAL(3 * refined->GetNumberOfPolys(), 2 * uniform);
    std::cout << map.Name << ": " << refined->GetNumberOfPolys() << " triangles, uniform "
              << uniform << "\n";
  }
}

// Curved surfaces, displacement along normals, scale and offset.
void TestSurfaces(RelevoCheck& check)
{
  for (int surface = 0; surface < 4; ++surface)
  {
    CHECK_CASE(surface);
    Scene scene;
    scene.Recipe->SetMaximumLevel(5);
    if (surface == 1)
    {
      scene.Recipe->SetSurface(vtkNew<vtkPNTriangleSurface>());
    }
    else if (surface == 2)
    {
      scene.Recipe->SetSurface(vtkNew<vtkPhongSurface>());
    }
    else if (surface == 3)
    {
      scene.Recipe->SetSurface(vtkNew<vtkPNTriangleSurface>());
      scene.Displacement->SetDirection(0.3, 0.0, 1.0);
    }
    scene.Displacement->SetScale(-0.7);
    scene.Displacement->SetOffset(0.2);
    scene.Recipe->SetLevelRuleToPerEdge();
    const auto coarse = MakePlane(3, 1.2);
    scene.Metric->SetMaximumError(0.003);
    vtkPolyData* refined = scene.Refine(coarse);
    const double length = MeasureLength(scene, coarse, refined);
    CHECK_LESS_EQUAL(length, 0.003 * Tolerance);
    CHECK_GREATER(length, 0.001);
    CHECK(IsClosed(refined));
    // Without relief, the surface alone is refined.
    scene.Heights->Fill(2, 2, [](double, double) { return 0.0; });
    scene.Metric->SetMaximumError(0.001);
    refined = scene.Refine(coarse);
    CHECK_LESS_EQUAL(MeasureLength(scene, coarse, refined), 0.001 * Tolerance);
    CHECK_GREATER(refined->GetNumberOfPolys(), coarse->GetNumberOfPolys());
  }
}

void TestViews(RelevoCheck& check)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  const auto coarse = MakePlane(4);
  for (int i = 0; i < (RelevoHasAddressSanitizer ? 4 : 20); ++i)
  {
    CHECK_CASE(i);
    Scene scene;
    scene.Heights->Fill(Size, Size, i % 2 ? Function(&Bump) : Function(&Ridge));
    scene.Displacement->SetDirection(0.0, 0.0, 1.0);
    scene.Recipe->SetLevelRule(i / 2 % 2);
    scene.Recipe->SetMaximumLevel(7);
    scene.Camera->SetPosition(
      4.0 * number(random) - 1.5, -0.5 - 2.0 * number(random), 0.4 + number(random));
    scene.Camera->SetFocalPoint(number(random), number(random), 0.0);
    scene.Camera->SetViewAngle(20.0 + 60.0 * number(random));
    scene.Camera->SetParallelProjection(i % 5 == 0);
    scene.Camera->SetParallelScale(0.6);
    scene.Metric->SetScreenSpaceError(i % 3 == 0 ? 1.0 : 3.0);
    vtkPolyData* refined = scene.Refine(coarse);
    const double pixels = MeasurePixels(scene, coarse, refined);
    CHECK_LESS_EQUAL(pixels, scene.Metric->GetScreenSpaceError() * Tolerance);
    CHECK(IsClosed(refined));
    CHECK(i % 5 != 0 || pixels > 0.3 * scene.Metric->GetScreenSpaceError());
  }
}

// A result depends neither on previous views nor on the order of settings.
void TestUpdates(RelevoCheck& check)
{
  Scene scene;
  scene.Recipe->SetLevelRuleToPerEdge();
  const auto coarse = MakePlane(4);
  const vtkIdType first = scene.Refine(coarse)->GetNumberOfPolys();
  scene.Camera->SetPosition(0.5, -3.0, 3.0);
  const vtkIdType far = scene.Refine(coarse)->GetNumberOfPolys();
  CHECK_LESS(far, first);
  scene.Displacement->SetScale(3.0);
  CHECK_GREATER(scene.Refine(coarse)->GetNumberOfPolys(), far);
  scene.Displacement->SetScale(1.0);
  scene.Recipe->SetSegmentPolicyToWholeNumbers();
  scene.Refine(coarse);
  scene.Recipe->SetSegmentPolicyToPowersOfTwo();
  scene.Heights->Fill(Size, Size, &Noise);
  CHECK_GREATER(scene.Refine(coarse)->GetNumberOfPolys(), far);
  scene.Heights->Fill(Size, Size, &Bump);
  scene.Camera->SetPosition(0.5, -1.0, 1.0);
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), first);
  // A camera is not needed for a length, and does not matter.
  scene.Metric->SetMaximumError(0.002);
  const vtkIdType toLength = scene.Refine(coarse)->GetNumberOfPolys();
  scene.Filter->SetCamera(nullptr);
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), toLength);
  // A limit that cannot be reached.
  scene.Recipe->SetMaximumLevel(1);
  scene.Metric->SetMaximumError(1e-12);
  scene.Heights->Fill(Size, Size, &Noise);
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), 4 * coarse->GetNumberOfPolys());
}

// Halves of a mesh match if edges on borders have the highest level.
void TestBlocks(RelevoCheck& check)
{
  for (int rule = 0; rule < 2; ++rule)
  {
    CHECK_CASE(rule);
    Scene scene;
    scene.Recipe->SetLevelRule(rule);
    scene.Recipe->SetMaximumLevel(4);
    scene.Metric->SetMaximumError(0.004);
    scene.Metric->MaximumLevelOnBorderOn();
    const auto coarse = MakePlane(4);
    vtkNew<vtkAppendPolyData> both;
    for (int half = 0; half < 2; ++half)
    {
      vtkNew<vtkPolyData> part;
      part->ShallowCopy(coarse);
      vtkNew<vtkCellArray> cells;
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = 0; cell < coarse->GetNumberOfCells(); ++cell)
      {
        if ((cell < coarse->GetNumberOfCells() / 2) == (half == 0))
        {
          coarse->GetCellPoints(cell, ids);
          cells->InsertNextCell(ids);
        }
      }
      part->SetPolys(cells);
      vtkNew<vtkPolyData> refined;
      refined->ShallowCopy(scene.Refine(part));
      both->AddInputData(refined);
    }
    both->Update();
    CHECK(IsClosed(both->GetOutput()));
  }
}

void TestHoles(RelevoCheck& check)
{
  Scene scene;
  scene.Displacement->SetDirection(0.0, 0.0, 1.0);
  scene.Recipe->SetLevelRuleToPerEdge();
  scene.Recipe->SetMaximumLevel(5);
  scene.Metric->SetMaximumError(0.004);
  const auto coarse = MakePlane(4);
  const auto isHole = [](int i, int j) { return std::hypot(i - 20, j - 40) < 8.0; };
  // Missing samples have other heights, which must not be measured.
  scene.Heights->Fill(Size, Size,
    [&](double x, double y)
    {
      const bool hole = isHole(static_cast<int>(x * Size), static_cast<int>(y * Size));
      return hole ? 0.2 : 0.05 * x;
    });
  const vtkIdType filled = scene.Refine(coarse)->GetNumberOfPolys();
  scene.Heights->Punch(isHole);
  vtkPolyData* refined = scene.Refine(coarse);
  CHECK_LESS_EQUAL(MeasureLength(scene, coarse, refined), 0.004 * Tolerance);
  // The rim of the hole is as fine as the highest level, so that little of the surface is missing.
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    refined->GetCellPoints(cell, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      refined->GetPoint(ids->GetId(i), p[i]);
    }
    area += 0.5 *
      std::abs(
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
  }
  CHECK_NEAR(area, 1.0 - vtkMath::Pi() * 9.0 * 9.0 / (Size * Size), 0.01);
  scene.Displacement->SetNoDataPolicyToFill();
  CHECK_LESS(scene.Refine(coarse)->GetNumberOfPolys(), filled);
  // Without any data there is nothing to refine.
  scene.Displacement->SetNoDataPolicyToHole();
  scene.Heights->Punch([](int, int) { return true; });
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), 0);
  scene.Displacement->SetNoDataPolicyToFill();
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), coarse->GetNumberOfPolys());
}

void TestExtremes(RelevoCheck& check)
{
  Scene scene;
  scene.Displacement->SetDirection(0.0, 0.0, 1.0);
  scene.Metric->SetMaximumError(0.01);
  const auto coarse = MakePlane(2);
  const vtkIdType faces = coarse->GetNumberOfPolys();
  scene.Heights->Fill(Size, Size, [](double, double) { return 7.0; });
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), faces);
  scene.Heights->Fill(1, 1, [](double, double) { return 1.0; });
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), faces);
  for (int isColumn = 0; isColumn < 2; ++isColumn)
  {
    scene.Heights->Fill(isColumn ? 1 : 40, isColumn ? 40 : 1,
      [](double x, double y) { return 0.1 * std::sin(9.0 * x) * std::cos(7.0 * y); });
    vtkPolyData* refined = scene.Refine(coarse);
    CHECK_GREATER(refined->GetNumberOfPolys(), faces);
    CHECK_LESS_EQUAL(MeasureLength(scene, coarse, refined), 0.01 * Tolerance);
  }
  // Heights of 1e29 need all levels, and no value overflows.
  scene.Heights->Fill(Size, Size, [](double x, double y) { return 1e29 * x * y; });
  scene.Recipe->SetMaximumLevel(2);
  CHECK_EQUAL(scene.Refine(coarse)->GetNumberOfPolys(), 16 * faces);
  // Texture coordinates outside of the map, where heights are constant.
  scene.Heights->Fill(Size, Size, &Bump);
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(coarse);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const double uv = moved->GetPointData()->GetTCoords()->GetComponent(i, 0);
    moved->GetPointData()->GetTCoords()->SetComponent(i, 0, uv + 1e20);
  }
  scene.Heights->Fill(Size, Size, [](double x, double) { return x; });
  CHECK_EQUAL(scene.Refine(moved)->GetNumberOfPolys(), faces);
}

void TestErrors(RelevoCheck& check)
{
  Scene scene;
  vtkHeightErrorDepthTagMetric* metric = scene.Metric;
  RelevoErrors errors(metric);
  RelevoErrors ofFilter(scene.Filter);
  RelevoErrors ofExecutive(scene.Filter->GetExecutive());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  metric->SetScreenSpaceError(0.0);
  CHECK(errors.Said("ScreenSpaceError must be in [0.001, 1e+06], got 0"));
  metric->SetScreenSpaceError(nan);
  CHECK(errors.Said("ScreenSpaceError must be in"));
  metric->SetMaximumError(-1.0);
  CHECK(errors.Said("MaximumError must be at least 0"));
  metric->SetMaximumError(nan);
  CHECK(errors.Said("MaximumError must be at least 0"));
  CHECK_EQUAL(metric->GetScreenSpaceError(), 1.0);
  CHECK_EQUAL(metric->GetMaximumError(), 0.0);

  const auto coarse = MakePlane(2);
  scene.Displacement->SetHeightMap(nullptr);
  scene.Refine(coarse);
  CHECK(errors.Said("There is no height map to measure"));
  scene.Displacement->SetHeightMap(scene.Heights);
  scene.Filter->SetCamera(nullptr);
  scene.Refine(coarse);
  CHECK(errors.Said("There is no camera"));
  scene.Filter->SetCamera(scene.Camera);
  scene.Filter->SetViewportSize(100, 100);
  CHECK_GREATER(scene.Refine(coarse)->GetNumberOfPolys(), 0);
  CHECK(errors.None());
  CHECK(ofFilter.Said("returned no depth-tags"));
}
}

int TestHeightErrorDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestLengths(check);
  TestTriangles(check);
  TestSurfaces(check);
  TestViews(check);
  TestUpdates(check);
  TestBlocks(check);
  TestHoles(check);
  TestExtremes(check);
  TestErrors(check);
  return check.GetResult();
}
