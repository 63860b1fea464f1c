// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that both faces of an edge compute its points bit for bit alike. Except at creases, so do
// their normals if both faces have the same normals at its ends.
#include "RelevoCheck.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "Evaluation/RefinementEvaluator.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkPointData.h"
#include "vtkProceduralSurface.h"
#include "vtkScalarTaggedSurface.h"

#include <cmath>
#include <cstring>
#include <map>
#include <random>

namespace
{
using relevo::EdgeCorners;
using relevo::RefinementEvaluator;
using relevo::RefinementMesh;

// Weights along an edge, lower end first.
std::vector<std::array<float, 2>> makeSteps()
{
  std::vector<std::array<float, 2>> steps;
  for (int k = 0; k <= 32; ++k)
  {
    steps.push_back({ { 1.0f - k / 32.0f, k / 32.0f } });
  }
  return steps;
}

// Edges whose faces must compute the same normals.
enum SharedNormals
{
  EVERYWHERE,
  INSIDE_EDGES,
  NOWHERE
};

void compareFaces(RelevoCheck& check, vtkPolyData* input, vtkAdaptiveRefinement* recipe,
  SharedNormals shared, const std::string& name)
{
  RefinementMesh mesh;
  CHECK(mesh.Build(input, recipe->GetSurface(), recipe->GetDisplacement()));
  const RefinementEvaluator evaluator(mesh, recipe);
  // Bits of positions by merged ends and step, and bits of normals also by the ends' points.
  std::map<std::array<int, 3>, std::array<float, 3>> positions;
  std::map<std::array<int, 5>, std::array<float, 3>> normals;
  int compared = 0;
  const auto steps = makeSteps();
  for (int face = 0; face < static_cast<int>(mesh.Faces.size()); ++face)
  {
    for (const auto& edge : EdgeCorners)
    {
      const int* corners = mesh.Faces[face].Corners;
      const int a = corners[edge[0]];
      const int b = corners[edge[1]];
      for (int k = 0; k < static_cast<int>(steps.size()); ++k)
      {
        float weights[3] = { 0.0f, 0.0f, 0.0f };
        weights[edge[0]] = steps[k][0];
        weights[edge[1]] = steps[k][1];
        std::array<float, 3> position;
        std::array<float, 3> normal;
        evaluator.Evaluate(face, weights, position.data(), normal.data());
        for (int c = 0; c < 3; ++c)
        {
          CHECK(std::isfinite(position[c]) && std::isfinite(normal[c]));
        }
        const auto known = positions.emplace(
          std::array<int, 3>{ { mesh.GetMergedPoint(a), mesh.GetMergedPoint(b), k } }, position);
        compared += known.second ? 0 : 1;
        if (std::memcmp(known.first->second.data(), position.data(), sizeof(position)) != 0)
        {
          check.Fail(__FILE__, __LINE__, name + ": positions differ on an edge");
          return;
        }
        const bool inside = k > 0 && k + 1 < static_cast<int>(steps.size());
        if (shared == NOWHERE || (shared == INSIDE_EDGES && !inside))
        {
          continue;
        }
        const auto knownNormal = normals.emplace(
          std::array<int, 5>{ { a, b, k, mesh.GetMergedPoint(a), mesh.GetMergedPoint(b) } },
          normal);
        if (std::memcmp(knownNormal.first->second.data(), normal.data(), sizeof(normal)) != 0)
        {
          check.Fail(__FILE__, __LINE__, name + ": normals differ on an edge");
          return;
        }
      }
    }
  }
  CHECK_GREATER(compared, 0);
}
// Zeros of both signs in points and normals.
RelevoMeshes::Mesh makeBothZeros()
{
  RelevoMeshes::Mesh flat = RelevoMeshes::FromTriangles(
    { { { -1, 0, 0 } }, { { 0, -1, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 0 } } },
    { { { 0, 1, 4 } }, { { 1, 2, 4 } }, { { 2, 3, 4 } }, { { 3, 0, 4 } } });
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 5; ++i)
  {
    normals->InsertNextTuple3(-0.0, -0.0, -1.0);
  }
  normals->SetTuple3(0, 0.0, 0.6, -0.8);
  normals->SetTuple3(2, 0.0, -0.6, -0.8);
  flat->GetPointData()->SetNormals(normals);
  return flat;
}

// Random triangles between few merged points, each with several points. Edges have any number of
// faces, and normals and texture coordinates vary.
RelevoMeshes::Mesh makeSoup()
{
  std::mt19937 random(12);
  std::vector<std::array<double, 3>> places;
  for (int i = 0; i < 60; ++i)
  {
    places.push_back({ { random() % 3 - 1.0, random() % 3 - 1.0, random() % 2 - 0.5 } });
  }
  std::vector<RelevoMeshes::Triangle> triangles;
  for (int i = 0; i < 300; ++i)
  {
    RelevoMeshes::Triangle triangle;
    for (vtkIdType& corner : triangle)
    {
      corner = static_cast<vtkIdType>(random() % 60);
    }
    triangles.push_back(triangle);
  }
  RelevoMeshes::Mesh soup = RelevoMeshes::FromTriangles(places, triangles);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(60);
  normals->Fill(0.0);
  soup->GetPointData()->SetNormals(normals);
  RelevoMeshes::PerturbNormals(soup, 13, 1.0);
  return soup;
}

std::vector<std::pair<std::string, RelevoMeshes::Mesh>> makeMeshes()
{
  using namespace RelevoMeshes;
  Mesh split = Explode(Sphere(9, 7));
  PerturbNormals(split, 8, 0.9);
  const double utm[3] = { 412345.678, 5654321.987, 312.5 };
  return { { "sphere", Sphere(12, 9) }, { "textured sphere", TexturedSphere(12, 9) },
    { "cube", Cube() }, { "cone", Cone() }, { "non-manifold", NonManifold() },
    { "Moebius strip", Moebius() }, { "split normals", split }, { "both zeros", makeBothZeros() },
    { "negative zeros", NegativeZeros() }, { "slivers", Slivers() }, { "soup", makeSoup() },
    { "projected metres", Moved(split, 2000.0, utm, VTK_DOUBLE) } };
}

// Creases have different normals on both sides. Cusps alone share them.
SharedNormals getSharedNormals(vtkRefinementSurface* surface)
{
  auto* procedural = vtkProceduralSurface::SafeDownCast(surface);
  auto* tagged =
    vtkScalarTaggedSurface::SafeDownCast(procedural ? procedural->GetBaseSurface() : surface);
  const bool creased = tagged && *tagged->GetDirectionArrayName();
  return creased ? NOWHERE : (tagged ? INSIDE_EDGES : EVERYWHERE);
}

// No displacement, a constant one, and heights along the normal and along a fixed direction.
constexpr int NumberOfDisplacements = 4;
vtkSmartPointer<vtkDisplacement> makeDisplacement(int kind, vtkHeightField* heights)
{
  if (kind == 0)
  {
    return nullptr;
  }
  auto displacement = vtkSmartPointer<vtkDisplacement>::New();
  displacement->SetHeightMap(kind > 1 ? heights : nullptr);
  displacement->SetScale(0.3);
  displacement->SetOffset(0.1);
  if (kind == 3)
  {
    displacement->SetDirection(-1.0, 0.0, 2.0);
  }
  return displacement;
}
}

int TestWatertightEvaluator(int, char*[])
{
  RelevoCheck check;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(19, 31, 2);
  for (const auto& mesh : makeMeshes())
  {
    if (!mesh.second->GetPointData()->GetTCoords())
    {
      RelevoMeshes::AddRandomTextureCoordinates(mesh.second, 5);
    }
    RelevoMeshes::AddRandomScalarTags(mesh.second, 7);
    double bounds[6];
    mesh.second->GetBounds(bounds);
    for (const auto& surface : RelevoMakeSurfaces(bounds[1] - bounds[0]))
    {
      for (int displaced = 0; displaced < NumberOfDisplacements; ++displaced)
      {
        vtkNew<vtkAdaptiveRefinement> recipe;
        recipe->SetSurface(surface.second);
        recipe->SetDisplacement(makeDisplacement(displaced, heights));
        compareFaces(check, mesh.second, recipe, getSharedNormals(surface.second),
          mesh.first + ", " + surface.first + ", displacement " + std::to_string(displaced));
      }
    }
  }
  return check.GetResult();
}
