// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Both faces of an edge compute the same bits for its points; for its normals too where the two
// faces see the same normals at its ends, but for creases.
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

// Weights at steps along an edge, its lower end first.
std::vector<std::array<float, 2>> makeSteps()
{
  std::vector<std::array<float, 2>> steps;
  for (int k = 0; k <= 32; ++k)
  {
    steps.push_back({ { 1.0f - k / 32.0f, k / 32.0f } });
  }
  return steps;
}

// Where the faces of an edge must see the same normals.
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
  // By ends' places and step: the position's bytes; by ends' points too: the normal's.
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
          std::array<int, 3>{ { mesh.GetPlace(a), mesh.GetPlace(b), k } }, position);
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
          std::array<int, 5>{ { a, b, k, mesh.GetPlace(a), mesh.GetPlace(b) } }, normal);
        if (std::memcmp(knownNormal.first->second.data(), normal.data(), sizeof(normal)) != 0)
        {
          check.Fail(__FILE__, __LINE__, name + ": normals differ on an edge");
          return;
        }
      }
    }
  }
  CHECK(compared > 0);
}
}

int TestWatertightEvaluator(int, char*[])
{
  using namespace RelevoMeshes;
  RelevoCheck check;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(19, 31, 2);
  // Zeros of both signs in points and normals.
  Mesh flat = FromTriangles(
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
  Mesh split = Explode(Sphere(9, 7));
  PerturbNormals(split, 8, 0.9);
  // Triangles at random among few places, several points at each: edges with any number of faces,
  // normals and charts of all kinds.
  std::mt19937 random(12);
  std::vector<std::array<double, 3>> places;
  for (int i = 0; i < 60; ++i)
  {
    places.push_back({ { random() % 3 - 1.0, random() % 3 - 1.0, random() % 2 - 0.5 } });
  }
  std::vector<Triangle> triangles;
  for (int i = 0; i < 300; ++i)
  {
    Triangle triangle;
    for (vtkIdType& corner : triangle)
    {
      corner = static_cast<vtkIdType>(random() % 60);
    }
    triangles.push_back(triangle);
  }
  Mesh soup = FromTriangles(places, triangles);
  vtkNew<vtkFloatArray> soupNormals;
  soupNormals->SetNumberOfComponents(3);
  soupNormals->SetNumberOfTuples(60);
  soupNormals->Fill(0.0);
  soup->GetPointData()->SetNormals(soupNormals);
  PerturbNormals(soup, 13, 1.0);
  const double utm[3] = { 412345.678, 5654321.987, 312.5 };
  const std::pair<const char*, Mesh> meshes[] = { { "sphere", Sphere(12, 9) },
    { "textured sphere", TexturedSphere(12, 9) }, { "cube", Cube() }, { "cone", Cone() },
    { "non-manifold", NonManifold() }, { "Moebius strip", Moebius() }, { "split normals", split },
    { "both zeros", flat }, { "negative zeros", NegativeZeros() }, { "slivers", Slivers() },
    { "soup", soup }, { "projected metres", Moved(split, 2000.0, utm, VTK_DOUBLE) } };

  for (const auto& mesh : meshes)
  {
    if (!mesh.second->GetPointData()->GetTCoords())
    {
      AddRandomTextureCoordinates(mesh.second, 5);
    }
    AddRandomScalarTags(mesh.second, 7);
    double bounds[6];
    mesh.second->GetBounds(bounds);
    for (const auto& surface : RelevoMakeSurfaces(bounds[1] - bounds[0]))
    {
      for (int displaced = 0; displaced < 4; ++displaced)
      {
        vtkNew<vtkAdaptiveRefinement> recipe;
        recipe->SetSurface(surface.second);
        // Creases, and cusps alone.
        auto* procedural = vtkProceduralSurface::SafeDownCast(surface.second);
        auto* tagged = vtkScalarTaggedSurface::SafeDownCast(
          procedural ? procedural->GetBaseSurface() : surface.second.Get());
        const bool creased = tagged && *tagged->GetDirectionArrayName();
        const SharedNormals shared = creased ? NOWHERE : (tagged ? INSIDE_EDGES : EVERYWHERE);
        if (displaced > 0)
        {
          vtkNew<vtkDisplacement> displacement;
          displacement->SetHeightMap(displaced > 1 ? heights.Get() : nullptr);
          displacement->SetScale(0.3);
          displacement->SetOffset(0.1);
          if (displaced == 3)
          {
            displacement->SetDirection(-1.0, 0.0, 2.0);
          }
          recipe->SetDisplacement(displacement);
        }
        compareFaces(check, mesh.second, recipe, shared,
          std::string(mesh.first) + ", " + surface.first + ", displacement " +
            std::to_string(displaced));
      }
    }
  }
  return check.GetResult();
}
