// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkProceduralSurface promises fur by its formula, computed here in double. Normals match finite
// differences, other base surfaces and functions work, and unusable settings are errors.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkProceduralSurface.h"

#include <cmath>
#include <limits>

using namespace RelevoMeshes;

namespace
{
using Vector = std::array<double, 3>;

// A height function of positions, of weights, or with values that are not finite.
class Bumps : public vtkProceduralSurface
{
public:
  static Bumps* New();
  vtkTypeMacro(Bumps, vtkProceduralSurface);

  enum Kinds
  {
    WAVES,
    WEIGHTS,
    HUGE,
    NOT_A_NUMBER
  };
  Kinds Kind = WAVES;

  bool HasHeightFunction() override { return true; }
  double EvaluateHeight(
    const double position[3], const float normal[3], const float weights[3]) override
  {
    switch (this->Kind)
    {
      case WAVES:
        return std::sin(3.0 * position[0]) * std::cos(2.0 * position[1] + position[2]);
      case WEIGHTS:
        return std::sin(9.0 * weights[0]) + 0.5 * weights[2] + normal[0];
      case HUGE:
        return 1e30 * position[0];
      default:
        return std::numeric_limits<double>::quiet_NaN();
    }
  }

protected:
  Bumps() { this->SetShaderFunction("float proceduralHeight(vec3, vec3, vec3) { return 0.0; }"); }
};
vtkStandardNewMacro(Bumps);

Mesh triangle(const double normals[3][3])
{
  Mesh mesh =
    FromTriangles({ { { 0, 0, 0 } }, { { 2, 0, 0.5 } }, { { 0.5, 1.5, 0 } } }, { { { 0, 1, 2 } } });
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  for (int i = 0; i < 3; ++i)
  {
    double normal[3] = { normals[i][0], normals[i][1], normals[i][2] };
    vtkMath::Normalize(normal);
    array->InsertNextTuple(normal);
  }
  mesh->GetPointData()->SetNormals(array);
  return mesh;
}

void testFur(RelevoCheck& check)
{
  const double normals[3][3] = { { 0.2, -0.1, 1 }, { 0.4, 0.1, 0.9 }, { -0.3, 0.3, 1 } };
  Mesh mesh = triangle(normals);
  for (double frequency : { 1.0, 3.0, 2.5 })
  {
    vtkNew<vtkProceduralSurface> fur;
    fur->SetAmplitude(0.3);
    fur->SetFrequency(frequency);
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetSurface(fur);
    relevo::RefinementMesh prepared;
    CHECK(prepared.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
    const relevo::RefinementEvaluator evaluator(prepared, recipe);
    double n[3][3];
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(i, p[i]);
      mesh->GetPointData()->GetNormals()->GetTuple(i, n[i]);
    }
    // The formula is in Lenz 2009, fig. 5.14.
    const double g =
      (vtkMath::Dot(n[0], n[1]) + vtkMath::Dot(n[1], n[2]) + vtkMath::Dot(n[2], n[0])) / 3.0;
    for (const auto& w : { std::array<float, 3>{ { 1, 0, 0 } }, { { 0.25f, 0.75f, 0 } },
           { { 0.375f, 0.25f, 0.375f } }, { { 0.125f, 0.625f, 0.25f } } })
    {
      double height = 0.3 * g;
      for (float weight : w)
      {
        height *= std::sin(weight * frequency * vtkMath::Pi());
      }
      float position[3];
      float normal[3];
      evaluator.Evaluate(0, w.data(), position, normal);
      for (int c = 0; c < 3; ++c)
      {
        double wanted = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          wanted += w[i] * (p[i][c] + height * n[i][c]);
        }
        CHECK_NEAR(position[c], wanted, 1e-6);
      }
    }
  }
}

// Angle in degrees between a normal and the one from differences of positions.
double angleToDifferences(const relevo::RefinementEvaluator& evaluator, const float w[3])
{
  const float step = 1.0f / 1024.0f;
  float normal[3];
  float unused[3];
  Vector along[2];
  for (int k = 0; k < 2; ++k)
  {
    float ends[2][3];
    for (int end = 0; end < 2; ++end)
    {
      float weights[3] = { w[0], w[1], w[2] };
      const float way = end == 0 ? -step : step;
      weights[0] -= way;
      weights[1 + k] += way;
      evaluator.Evaluate(0, weights, ends[end], unused);
    }
    for (int c = 0; c < 3; ++c)
    {
      along[k][c] = static_cast<double>(ends[1][c]) - ends[0][c];
    }
  }
  float position[3];
  evaluator.Evaluate(0, w, position, normal);
  double expected[3];
  vtkMath::Cross(along[0].data(), along[1].data(), expected);
  const double given[3] = { normal[0], normal[1], normal[2] };
  return vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(given, expected));
}

void testNormals(RelevoCheck& check)
{
  // All corners have the same normal, so the direction is constant.
  const double normals[3][3] = { { -0.25, 0.25 / 3, 1 }, { -0.25, 0.25 / 3, 1 },
    { -0.25, 0.25 / 3, 1 } };
  Mesh mesh = triangle(normals);
  vtkNew<vtkProceduralSurface> fur;
  fur->SetAmplitude(0.2);
  fur->SetFrequency(3.0);
  vtkNew<Bumps> waves;
  waves->SetAmplitude(0.2);
  const float inner[][3] = { { 0.375f, 0.25f, 0.375f }, { 0.125f, 0.625f, 0.25f },
    { 0.5f, 0.25f, 0.25f } };
  for (vtkProceduralSurface* surface : { fur.Get(), static_cast<vtkProceduralSurface*>(waves) })
  {
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetSurface(surface);
    relevo::RefinementMesh prepared;
    CHECK(prepared.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
    const relevo::RefinementEvaluator evaluator(prepared, recipe);
    for (const float* w : inner)
    {
      CHECK_NEAR(angleToDifferences(evaluator, w), 0.0, surface == fur.Get() ? 0.2 : 1.0);
    }
  }
}

// At amplitude 0 it equals the base surface. Bounds follow the amplitude.
void testBase(RelevoCheck& check)
{
  Mesh mesh = Sphere(8, 6);
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkProceduralSurface> fur;
  fur->SetBaseSurface(pn);
  fur->SetAmplitude(0.0);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  recipe->SetSurface(fur);
  Mesh furry = Refine(mesh, recipe);
  recipe->SetSurface(pn);
  Mesh smooth = Refine(mesh, recipe);
  for (vtkIdType i = 0; i < smooth->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      CHECK_EQUAL(furry->GetPoint(i)[c], smooth->GetPoint(i)[c]);
      CHECK_NEAR(furry->GetPointData()->GetNormals()->GetComponent(i, c),
        smooth->GetPointData()->GetNormals()->GetComponent(i, c), 1e-6);
    }
  }
  const vtkMTimeType prepared = fur->GetPreparationMTime();
  fur->SetAmplitude(0.3);
  fur->SetFrequency(2.0);
  fur->SetUniform("any", 1.0);
  fur->SetUniform("any", 1.0, 2.0, 3.0);
  CHECK_EQUAL(fur->GetPreparationMTime(), prepared);
  CHECK_EQUAL(fur->GetReach(), 0.3);
  pn->QuadraticNormalsOff();
  CHECK_GREATER(fur->GetPreparationMTime(), prepared);
}

// The surface stays closed and finite for every function.
void testFunctions(RelevoCheck& check)
{
  for (Bumps::Kinds kind : { Bumps::WAVES, Bumps::WEIGHTS, Bumps::HUGE, Bumps::NOT_A_NUMBER })
  {
    for (Mesh mesh : { Sphere(8, 6), Cube(), Explode(Sphere(6, 5)) })
    {
      vtkNew<Bumps> surface;
      surface->Kind = kind;
      surface->SetAmplitude(0.2);
      AddTags(mesh, 3, 4);
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(4);
      recipe->SetSurface(surface);
      Mesh fine = Refine(mesh, recipe);
      const std::string error = RelevoWatertight::FindError(mesh, fine, 4);
      if (!error.empty())
      {
        check.Fail(__FILE__, __LINE__, "kind " + std::to_string(kind) + ": " + error);
      }
      relevo::RefinementMesh prepared;
      CHECK(prepared.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement()));
      double bounds[6];
      double reached[6];
      relevo::ComputeBounds(prepared, recipe->GetSurface(), recipe->GetDisplacement(), bounds);
      fine->GetBounds(reached);
      for (int c = 0; c < 3; ++c)
      {
        CHECK_LESS_EQUAL(bounds[2 * c], reached[2 * c] + 1e-6);
        CHECK_GREATER_EQUAL(bounds[2 * c + 1], reached[2 * c + 1] - 1e-6);
      }
      for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
      {
        const double* normal = fine->GetPointData()->GetNormals()->GetTuple3(i);
        CHECK_NEAR(vtkMath::Norm(normal), 1.0, 1e-5);
      }
    }
  }
}

void testErrors(RelevoCheck& check)
{
  vtkNew<vtkProceduralSurface> surface;
  RelevoErrors errors(surface);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  surface->SetAmplitude(nan);
  CHECK(errors.Said("Amplitude"));
  surface->SetFrequency(std::numeric_limits<double>::infinity());
  CHECK(errors.Said("Frequency"));
  surface->SetUniform("x", nan);
  CHECK(errors.Said("\"x\""));
  surface->SetUniform(nullptr, 1.0);
  CHECK(errors.Said("name"));
  vtkNew<vtkProceduralSurface> other;
  surface->SetBaseSurface(other);
  CHECK(errors.Said("BaseSurface") && !surface->GetBaseSurface());

  surface->SetShaderFunction("float proceduralHeight(vec3 p, vec3 n, vec3 w) { return p.x; }");
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(surface);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  RelevoErrors filterErrors(filter);
  filter->SetInputData(Sphere(5, 4));
  filter->SetRefinement(recipe);
  filter->Update();
  CHECK(filterErrors.Said("ShaderFunction"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  surface->SetShaderFunction(nullptr);
  filter->Update();
  CHECK(filterErrors.None() && filter->GetOutput()->GetNumberOfCells() > 0);
}
}

int TestProceduralSurface(int, char*[])
{
  RelevoCheck check;
  testFur(check);
  testNormals(check);
  testBase(check);
  testFunctions(check);
  testErrors(check);
  return check.GetResult();
}
