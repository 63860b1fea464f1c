// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures how closely surfaces over a coarse mesh approximate the original: distances, normals,
// and smoothness across its edges.
#include "BenchmarkMeshes.h"
#include "BenchmarkReport.h"
#include "Benchmarks.h"

#include "RelevoVector.h"

#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkDataArray.h"
#include "vtkG1Surface.h"
#include "vtkIdList.h"
#include "vtkLinearSurface.h"
#include "vtkMath.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{
using namespace RelevoVectors;

// A point of the true surface with its unit normal.
struct Sample
{
  Vector Point;
  Vector Normal;
};

struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Coarse;
  int Level; // the level of every edge
  std::function<Sample(const Vector&)> FindClosest;
  std::vector<Sample> Samples; // distributed over the true surface
};

Vector GetPoint(vtkPolyData* mesh, vtkIdType point)
{
  Vector result;
  mesh->GetPoint(point, result.data());
  return result;
}

Vector GetNormal(vtkPolyData* mesh, vtkIdType point)
{
  Vector result;
  mesh->GetPointData()->GetNormals()->GetTuple(point, result.data());
  return result;
}

// Calls visit() with evenly distributed pairs of parameters in [0, 1).
void VisitParameters(int count, const std::function<void(double, double)>& visit)
{
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      visit((i + 0.5) / count, (j + 0.5) / count);
    }
  }
}

Scene MakeSphere(int count)
{
  Scene scene{ "sphere", BenchmarkMeshes::MakeSphere(6, 4), 5, {}, {} };
  scene.FindClosest = [](const Vector& p)
  {
    const Vector normal = normalize(p);
    return Sample{ normal, normal };
  };
  VisitParameters(count,
    [&scene](double u, double v)
    {
      // Uniform by area.
      const double z = 2.0 * v - 1.0;
      const double radius = std::sqrt(1.0 - z * z);
      const double angle = 2.0 * vtkMath::Pi() * u;
      const Vector p = { { radius * std::cos(angle), radius * std::sin(angle), z } };
      scene.Samples.push_back({ p, p });
    });
  return scene;
}

Scene MakeTorus(int count)
{
  const double radius = 1.0;
  const double tubeRadius = 0.4;
  Scene scene{ "torus", BenchmarkMeshes::MakeTorus(radius, tubeRadius, 12, 8), 4, {}, {} };
  scene.FindClosest = [=](const Vector& p)
  {
    const double scale = radius / std::hypot(p[0], p[1]);
    const Vector center = { { scale * p[0], scale * p[1], 0.0 } };
    const Vector normal = normalize(p - center);
    return Sample{ center + tubeRadius * normal, normal };
  };
  VisitParameters(count,
    [&](double u, double v)
    {
      const double angle = 2.0 * vtkMath::Pi() * u;
      const double tube = 2.0 * vtkMath::Pi() * v;
      const double distance = radius + tubeRadius * std::cos(tube);
      scene.Samples.push_back({ { { distance * std::cos(angle), distance * std::sin(angle),
                                  tubeRadius * std::sin(tube) } },
        { { std::cos(tube) * std::cos(angle), std::cos(tube) * std::sin(angle),
          std::sin(tube) } } });
    });
  return scene;
}

Scene MakeBunny(vtkPolyData* bunny, int faces)
{
  Scene scene{ "bunny", BenchmarkMeshes::Decimate(bunny, faces), 3, {}, {} };
  const vtkSmartPointer<vtkPolyData> dense = bunny;
  auto locator = vtkSmartPointer<vtkStaticCellLocator>::New();
  locator->SetDataSet(dense);
  locator->BuildLocator();
  scene.FindClosest = [dense, locator](const Vector& p)
  {
    Sample sample;
    vtkIdType cell;
    int subId;
    double distance2;
    locator->FindClosestPoint(p.data(), sample.Point.data(), cell, subId, distance2);
    double coordinates[3];
    double weights[3];
    Vector closest;
    dense->GetCell(cell)->EvaluatePosition(
      sample.Point.data(), closest.data(), subId, coordinates, distance2, weights);
    sample.Normal = { { 0.0, 0.0, 0.0 } };
    vtkNew<vtkIdList> ids;
    dense->GetCellPoints(cell, ids);
    for (int i = 0; i < 3; ++i)
    {
      sample.Normal = sample.Normal + weights[i] * GetNormal(dense, ids->GetId(i));
    }
    sample.Normal = normalize(sample.Normal);
    return sample;
  };
  // As for the other scenes, corners lie on the true surface and have its normals.
  for (vtkIdType i = 0; i < scene.Coarse->GetNumberOfPoints(); ++i)
  {
    const Sample sample = scene.FindClosest(GetPoint(scene.Coarse, i));
    scene.Coarse->GetPoints()->SetPoint(i, sample.Point.data());
    scene.Coarse->GetPointData()->GetNormals()->SetTuple(i, sample.Normal.data());
  }
  // Only points that faces use.
  std::vector<char> isUsed(static_cast<size_t>(dense->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < dense->GetNumberOfCells(); ++cell)
  {
    dense->GetCellPoints(cell, ids);
    for (const vtkIdType point : *ids)
    {
      isUsed[static_cast<size_t>(point)] = 1;
    }
  }
  for (vtkIdType i = 0; i < dense->GetNumberOfPoints(); ++i)
  {
    if (isUsed[static_cast<size_t>(i)])
    {
      scene.Samples.push_back({ GetPoint(dense, i), GetNormal(dense, i) });
    }
  }
  return scene;
}

// Maximum, mean and root mean square of the values.
struct Statistics
{
  double Largest = 0.0;
  double Sum = 0.0;
  double Squares = 0.0;
  double Count = 0.0;

  void Add(double value)
  {
    this->Largest = std::max(this->Largest, value);
    this->Sum += value;
    this->Squares += value * value;
    this->Count += 1.0;
  }
  double GetMean() const { return this->Sum / this->Count; }
  double GetRootMeanSquare() const { return std::sqrt(this->Squares / this->Count); }
};

struct Errors
{
  Statistics Forth;   // distances of the refined surface from the true one
  Statistics Back;    // distances of the true surface from the refined one
  Statistics Normals; // degrees, between shading normals of refined points and the true ones
  Statistics Facets;  // degrees, between face normals of the triangles and the true ones
};

Errors Compare(const Scene& scene, vtkPolyData* refined)
{
  Errors errors;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    const Vector point = GetPoint(refined, i);
    const Sample sample = scene.FindClosest(point);
    errors.Forth.Add(length(point - sample.Point));
    errors.Normals.Add(angle(GetNormal(refined, i), sample.Normal));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < refined->GetNumberOfCells(); ++cell)
  {
    refined->GetCellPoints(cell, ids);
    const Vector a = GetPoint(refined, ids->GetId(0));
    const Vector b = GetPoint(refined, ids->GetId(1));
    const Vector c = GetPoint(refined, ids->GetId(2));
    const Vector middle = (1.0 / 3.0) * (a + b + c);
    const Sample sample = scene.FindClosest(middle);
    errors.Forth.Add(length(middle - sample.Point));
    errors.Facets.Add(angle(cross(b - a, c - a), sample.Normal));
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(refined);
  locator->BuildLocator();
  for (const Sample& sample : scene.Samples)
  {
    Vector nearest;
    vtkIdType cell;
    int subId;
    double distance2;
    locator->FindClosestPoint(sample.Point.data(), nearest.data(), cell, subId, distance2);
    errors.Back.Add(std::sqrt(distance2));
  }
  return errors;
}

// The surface's normal at a point of a face's edge, up to its sign. Differences, one-sided across
// the edge, are exact for cubics.
Vector GetBorderNormal(
  const relevo::RefinementEvaluator& evaluator, int face, int edge, double along)
{
  const auto evaluate = [&](double t, double inwards)
  {
    const int first = relevo::EdgeCorners[edge][0];
    const int second = relevo::EdgeCorners[edge][1];
    float weights[3];
    weights[first] = static_cast<float>((1.0 - inwards) * (1.0 - t));
    weights[second] = static_cast<float>((1.0 - inwards) * t);
    weights[3 - first - second] = static_cast<float>(inwards);
    float position[3];
    float normal[3];
    evaluator.Evaluate(face, weights, position, normal);
    return Vector{ { position[0], position[1], position[2] } };
  };
  const double step = 1.0 / 16.0;
  const double inwardStep = 1.0 / 256.0; // gives exact weights; positions are floats
  const Vector tangent = evaluate(along - 2.0 * step, 0.0) - evaluate(along + 2.0 * step, 0.0) +
    8.0 * (evaluate(along + step, 0.0) - evaluate(along - step, 0.0));
  const Vector inwards = -11.0 * evaluate(along, 0.0) + 18.0 * evaluate(along, inwardStep) +
    -9.0 * evaluate(along, 2.0 * inwardStep) + 2.0 * evaluate(along, 3.0 * inwardStep);
  return cross(tangent, inwards);
}

// Angles in degrees between the normals of two faces at points of coarse edges.
Statistics MeasureJumps(vtkPolyData* coarse, vtkAdaptiveRefinement* recipe)
{
  relevo::RefinementMesh mesh;
  mesh.Build(coarse, recipe->GetSurface(), recipe->GetDisplacement());
  mesh.BuildEdges();
  const relevo::RefinementEvaluator evaluator(mesh, recipe);
  std::vector<std::vector<int>> users(static_cast<size_t>(mesh.GetNumberOfEdges()));
  for (size_t i = 0; i < mesh.FaceEdges.size(); ++i)
  {
    users[static_cast<size_t>(mesh.FaceEdges[i])].push_back(static_cast<int>(i));
  }
  Statistics jumps;
  for (const std::vector<int>& sides : users)
  {
    for (int k = 2; sides.size() == 2 && k <= 14; k += 2)
    {
      Vector normals[2];
      for (int s = 0; s < 2; ++s)
      {
        normals[s] = GetBorderNormal(evaluator, sides[s] / 3, sides[s] % 3, k / 16.0);
      }
      // The two faces look inwards from opposite sides.
      jumps.Add(180.0 - angle(normals[0], normals[1]));
    }
  }
  return jumps;
}

void Measure(const Scene& scene, const char* name, vtkRefinementSurface* surface,
  const BenchmarkOptions& options, BenchmarkTable& table)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(options.Quick ? 1 : options.Full ? scene.Level + 1 : scene.Level);
  recipe->SetSurface(surface);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(scene.Coarse);
  filter->SetRefinement(recipe);
  filter->Update();
  vtkPolyData* refined = filter->GetOutput();
  const Errors errors = Compare(scene, refined);
  const Statistics jumps = MeasureJumps(scene.Coarse, recipe);
  const double percent = 100.0 / scene.Coarse->GetLength();
  table.AddRow({ scene.Name, static_cast<double>(scene.Coarse->GetNumberOfPolys()),
    static_cast<double>(refined->GetNumberOfPolys()), std::string(name),
    percent * std::max(errors.Forth.Largest, errors.Back.Largest),
    percent * errors.Forth.GetRootMeanSquare(), percent * errors.Back.GetRootMeanSquare(),
    errors.Normals.Largest, errors.Normals.GetRootMeanSquare(), errors.Facets.Largest,
    errors.Facets.GetRootMeanSquare(), jumps.Largest, jumps.GetMean() });
}
}

void RunQuality(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("quality-surfaces", "Surfaces against what their coarse mesh was made from",
    { { "mesh", "mesh", 0 }, { "faces", "in", 0 }, { "triangles", "out", 0 },
      { "surface", "surface", 0 }, { "hausdorff_percent", "Hausdorff distance, %", 4 },
      { "forth_rms_percent", "RMS to the true one, %", 4 },
      { "back_rms_percent", "RMS from it, %", 4 }, { "normal_largest", "normals, largest, °", 2 },
      { "normal_rms", "RMS, °", 2 }, { "facet_largest", "facets, largest, °", 2 },
      { "facet_rms", "RMS, °", 2 }, { "jump_largest", "jump at edges, largest, °", 2 },
      { "jump_mean", "mean, °", 2 } });
  const int count = options.Quick ? 20 : 200;
  std::vector<Scene> scenes = { MakeSphere(count), MakeTorus(count) };
  const auto bunny = BenchmarkMeshes::ReadBunny();
  if (bunny)
  {
    scenes.push_back(MakeBunny(bunny, options.Quick ? 200 : 1500));
  }
  vtkNew<vtkLinearSurface> linear;
  vtkNew<vtkPhongSurface> phong;
  vtkNew<vtkPNTriangleSurface> curved;
  vtkNew<vtkG1Surface> smooth;
  for (const Scene& scene : scenes)
  {
    std::cerr << "quality: " << scene.Name << std::endl;
    Measure(scene, "linear", linear, options, table);
    Measure(scene, "Phong", phong, options, table);
    Measure(scene, "PN", curved, options, table);
    Measure(scene, "G1", smooth, options, table);
  }
  table.AddNote("Distances in percent of the coarse mesh's diagonal; to the true surface from the "
                "refined points and the middles of triangles, from it to the refined triangles. "
                "Normals: those that shade; facets: the triangles' own, both against the true "
                "surface's at the nearest point. Jump: between the surface's own normals on both "
                "sides of the coarse edges.");
  if (!bunny)
  {
    table.AddNote("Without the bunny: RELEVO_TEST_DATA names no folder with mesh/bunny.ply.");
  }
  addTable(table);
  RunPatterns(options, addTable);
}
