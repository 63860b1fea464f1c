// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPhongSurface promises Phong tessellation: the mean of projections on tangent planes, computed
// here in double. Alpha may be a number or an array; arrays that cannot be used are errors.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPhongSurface.h"
#include "vtkPointData.h"

#include <cmath>
#include <functional>
#include <random>

using namespace RelevoMeshes;

namespace
{
using Vector = std::array<double, 3>;

// The formula is that of Boubekeur and Alexa 2008, section 3.
Vector expected(vtkPolyData* mesh, const float w[3], double alpha)
{
  Vector p{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      p[c] += w[i] * mesh->GetPoint(i)[c];
    }
  }
  Vector curved{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < 3; ++i)
  {
    double point[3];
    double normal[3];
    mesh->GetPoint(i, point);
    mesh->GetPointData()->GetNormals()->GetTuple(i, normal);
    double distance = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      distance += (p[c] - point[c]) * normal[c];
    }
    for (int c = 0; c < 3; ++c)
    {
      curved[c] += w[i] * (p[c] - distance * normal[c]);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    p[c] += alpha * (curved[c] - p[c]);
  }
  return p;
}

Mesh randomTriangle(std::mt19937& random)
{
  auto number = [&random]() { return random() / 2147483648.0 - 1.0; };
  auto vector = [&]() { return std::array<double, 3>{ { number(), number(), number() } }; };
  Mesh mesh = FromTriangles({ vector(), vector(), vector() }, { { { 0, 1, 2 } } });
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 3; ++i)
  {
    std::array<double, 3> normal = vector();
    vtkMath::Normalize(normal.data());
    normals->InsertNextTuple(normal.data());
  }
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

void compare(RelevoCheck& check, vtkPolyData* mesh, vtkPhongSurface* surface,
  const std::function<double(const float*)>& getAlpha)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(surface);
  relevo::RefinementMesh prepared;
  CHECK(prepared.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
  const relevo::RefinementEvaluator evaluator(prepared, recipe);
  for (const auto& w : { std::array<float, 3>{ { 1, 0, 0 } }, { { 0.25f, 0.75f, 0 } },
         { { 0.5f, 0, 0.5f } }, { { 0.25f, 0.25f, 0.5f } }, { { 0.125f, 0.625f, 0.25f } } })
  {
    float position[3];
    float normal[3];
    evaluator.Evaluate(0, w.data(), position, normal);
    const Vector wanted = expected(mesh, w.data(), getAlpha(w.data()));
    for (int c = 0; c < 3; ++c)
    {
      CHECK_NEAR(position[c], wanted[c], 2e-6);
    }
  }
}

void testFormula(RelevoCheck& check)
{
  std::mt19937 random(5);
  for (int sample = 0; sample < 50; ++sample)
  {
    Mesh mesh = randomTriangle(random);
    vtkNew<vtkPhongSurface> surface;
    compare(check, mesh, surface, [](const float*) { return 1.0; });
    surface->SetAlpha(0.75);
    compare(check, mesh, surface, [](const float*) { return 0.75; });
    surface->SetAlpha(0.0);
    compare(check, mesh, surface, [](const float*) { return 0.0; });

    // Alpha per point is clamped to [0, 1].
    vtkNew<vtkFloatArray> alphas;
    alphas->SetName("alpha");
    alphas->InsertNextValue(0.25f);
    alphas->InsertNextValue(7.0f);
    alphas->InsertNextValue(-3.0f);
    mesh->GetPointData()->AddArray(alphas);
    surface->SetAlphaArrayName("alpha");
    compare(check, mesh, surface, [](const float* w) { return 0.25 * w[0] + w[1]; });
  }
}

// Coincident points share one alpha, so no crack opens.
void testSplitPoints(RelevoCheck& check)
{
  Mesh mesh = Explode(Sphere(7, 5));
  vtkNew<vtkFloatArray> alphas;
  alphas->SetName("alpha");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    alphas->InsertNextValue((i * 7 % 10) / 9.0f);
  }
  mesh->GetPointData()->AddArray(alphas);
  vtkNew<vtkPhongSurface> surface;
  surface->SetAlphaArrayName("alpha");
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(3);
  recipe->SetSurface(surface);
  const std::string error = RelevoWatertight::FindError(mesh, Refine(mesh, recipe), 3);
  if (!error.empty())
  {
    check.Fail(__FILE__, __LINE__, error);
  }
}

void testErrors(RelevoCheck& check)
{
  vtkNew<vtkPhongSurface> surface;
  RelevoErrors errors(surface);
  for (double alpha : { -0.1, 1.1, std::nan("") })
  {
    CHECK_CASE(alpha);
    surface->SetAlpha(alpha);
    CHECK(errors.Said("Alpha"));
    CHECK_EQUAL(surface->GetAlpha(), 1.0);
  }
  // Alpha is a live parameter; the array's name is not.
  const vtkMTimeType prepared = surface->GetPreparationMTime();
  const vtkMTimeType time = surface->GetMTime();
  surface->SetAlpha(0.5);
  CHECK_GREATER(surface->GetMTime(), time);
  CHECK_EQUAL(surface->GetPreparationMTime(), prepared);
  surface->SetAlphaArrayName("none");
  CHECK_GREATER(surface->GetPreparationMTime(), prepared);

  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(surface);
  Mesh mesh = Sphere(5, 4);
  const auto refineSays = [&](const std::string& words)
  {
    vtkNew<vtkAdaptiveRefinementFilter> filter;
    RelevoErrors filterErrors(filter);
    filter->SetInputData(mesh);
    filter->SetRefinement(recipe);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
    return filterErrors.Said(words);
  };
  CHECK(refineSays("\"none\" does not exist"));
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("none");
  ofCells->SetNumberOfTuples(mesh->GetNumberOfCells());
  ofCells->Fill(0.5);
  mesh->GetCellData()->AddArray(ofCells);
  CHECK(refineSays("Cannot refine the input: there is no point array \"none\", but a cell array of "
                   "that name. Convert it with vtkCellDataToPointData."));
  vtkNew<vtkFloatArray> alphas;
  alphas->SetName("none");
  alphas->SetNumberOfComponents(2);
  alphas->SetNumberOfTuples(mesh->GetNumberOfPoints());
  alphas->Fill(0.5);
  mesh->GetPointData()->AddArray(alphas);
  CHECK(refineSays("2 components"));
  alphas->SetNumberOfComponents(1);
  alphas->SetNumberOfTuples(mesh->GetNumberOfPoints());
  alphas->Fill(0.5);
  alphas->SetValue(3, std::nanf(""));
  alphas->Modified();
  CHECK(refineSays("not finite at point 3"));
}
}

int TestPhongSurface(int, char*[])
{
  RelevoCheck check;
  testFormula(check);
  testSplitPoints(check);
  testErrors(check);
  return check.GetResult();
}
