// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinementSurface promises: refined meshes are closed, bit for bit, wherever the coarse mesh
// is, and keep its winding. Tests many meshes, surfaces and displacements with random depth-tags.
#include "RelevoCheck.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"
#include "RelevoWatertight.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDisplacement.h"
#include "vtkPointData.h"

namespace
{
constexpr int MaximumLevel = 4;

struct Case
{
  std::string Name;
  RelevoMeshes::Mesh Mesh;
};

std::vector<Case> makeCases()
{
  using namespace RelevoMeshes;
  const double none[3] = { 0.0, 0.0, 0.0 };
  const double utm[3] = { 412345.678, 5654321.987, 312.5 };
  std::vector<Case> cases = { { "sphere", Sphere(8, 6) },
    { "textured sphere", TexturedSphere(8, 6) }, { "plane", Plane(4, 3) }, { "cube", Cube() },
    { "cone", Cone() }, { "strips", Strips() }, { "non-manifold", NonManifold() },
    { "Moebius strip", Moebius() }, { "slivers", Slivers() }, { "mixed cells", Mixed() },
    { "negative zeros", NegativeZeros() }, { "exploded sphere", Explode(Sphere(8, 6)) },
    { "exploded non-manifold", Explode(NonManifold()) },
    { "double", Moved(Sphere(7, 5), 3.0, none, VTK_DOUBLE) },
    { "projected metres", Moved(TexturedSphere(7, 5), 2000.0, utm, VTK_DOUBLE) },
    { "exploded projected metres", Moved(Explode(Sphere(7, 5)), 2000.0, utm, VTK_DOUBLE) },
    { "tiny", Moved(Cube(), 1e-12, none, VTK_FLOAT) },
    { "tiny double", Moved(Explode(Sphere(7, 5)), 1e-12, none, VTK_DOUBLE) },
    { "huge", Moved(Cone(), 1e12, none, VTK_FLOAT) } };

  // Normals differ between the two sides of every edge.
  Mesh split = Explode(Sphere(8, 6));
  PerturbNormals(split, 3, 0.8);
  cases.push_back({ "split normals", split });
  Mesh some = Cone();
  PerturbNormals(some, 4, 0.5);
  cases.push_back({ "normals split here and there", some });

  // Degenerate triangles have repeated, coincident or collinear points.
  Mesh degenerate = Sphere(8, 6);
  const vtkIdType twice[3] = { 4, 4, 5 };
  degenerate->GetPolys()->InsertNextCell(3, twice);
  const vtkIdType copy = degenerate->GetPoints()->InsertNextPoint(degenerate->GetPoint(4));
  const vtkIdType onePlace[3] = { 4, 5, copy };
  degenerate->GetPolys()->InsertNextCell(3, onePlace);
  degenerate->GetPointData()->SetNormals(nullptr);
  cases.push_back({ "degenerate", degenerate });
  cases.push_back({ "on a line",
    FromTriangles({ { { 0, 0, 0 } }, { { 0.7, 0.7, 0 } }, { { 2, 2, 0 } }, { { 2, 0, 0 } } },
      { { { 0, 2, 1 } }, { { 0, 3, 2 } } }) });
  return cases;
}

void run(RelevoCheck& check, const Case& mesh, vtkAdaptiveRefinement* recipe,
  const std::string& recipeName, int seed)
{
  if (seed >= 0)
  {
    RelevoMeshes::AddTags(mesh.Mesh, static_cast<unsigned int>(seed), MaximumLevel + 1);
  }
  else
  {
    mesh.Mesh->GetPointData()->RemoveArray("DepthTag");
  }
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  RelevoErrors errors(filter); // degenerate cells give a warning
  filter->SetInputData(mesh.Mesh);
  filter->SetRefinement(recipe);
  filter->Update();
  const std::string error = RelevoWatertight::FindError(mesh.Mesh, filter->GetOutput(),
    recipe->GetMaximumLevel(), recipe->GetGeomorphing() == vtkAdaptiveRefinement::GEOMORPHING_ON);
  if (!error.empty())
  {
    check.Fail(__FILE__, __LINE__,
      mesh.Name + ", " + recipeName + ", seed " + std::to_string(seed) + ": " + error);
  }
}
}

int TestWatertight(int, char*[])
{
  RelevoCheck check;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(37, 23, 1);
  for (Case& mesh : makeCases())
  {
    RelevoMeshes::AddRandomScalarTags(mesh.Mesh, 23);
    double bounds[6];
    mesh.Mesh->GetBounds(bounds);
    const double size = bounds[1] - bounds[0];
    for (const auto& surface : RelevoMakeSurfaces(size))
    {
      // One surface is tested with all displacements, the others with some.
      const int step = surface.first == "PN, quadratic normals" ? 1 : 3;
      for (int displaced = 0; displaced < 5; displaced += step)
      {
        vtkNew<vtkAdaptiveRefinement> recipe;
        recipe->SetMaximumLevel(MaximumLevel);
        recipe->SetSurface(surface.second);
        std::string name = surface.first;
        vtkSmartPointer<vtkDataArray> given = mesh.Mesh->GetPointData()->GetTCoords();
        if (displaced > 0)
        {
          vtkNew<vtkDisplacement> displacement;
          displacement->SetScale(0.3 * size);
          displacement->SetHeightMap(displaced > 1 ? heights.Get() : nullptr);
          displacement->SetOffset(0.1 * size);
          name += displaced > 1 ? ", heights" : ", offset";
          if (displaced % 2 == 0)
          {
            displacement->SetDirection(1.0, -0.3, 2.0);
            name += " in a direction";
          }
          recipe->SetDisplacement(displacement);
          // From 3 on, texture coordinates of points are unrelated.
          if (displaced > 1 && (displaced > 2 || !given))
          {
            RelevoMeshes::AddRandomTextureCoordinates(mesh.Mesh, 17);
          }
        }
        for (int seed = -1; seed < 5; ++seed)
        {
          recipe->SetGeomorphing(seed > 2);
          run(check, mesh, recipe, name + (seed > 2 ? ", morphing" : ""), seed);
        }
        mesh.Mesh->GetPointData()->SetTCoords(given);
      }
    }
  }

  // One face gets every combination of levels.
  using namespace RelevoMeshes;
  for (int levels = 0; levels < 6 * 6 * 6; ++levels)
  {
    Mesh pair =
      FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0.3, 1, 0 } }, { { 1, 2, 0 } } },
        { { { 2, 0, 1 } }, { { 1, 3, 2 } } });
    vtkNew<vtkFloatArray> tags;
    tags->SetName("DepthTag");
    tags->InsertNextValue(levels % 6);
    tags->InsertNextValue(levels / 6 % 6);
    tags->InsertNextValue(levels / 36);
    tags->InsertNextValue(2.5f);
    pair->GetPointData()->AddArray(tags);
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetMaximumLevel(5);
    vtkNew<vtkAdaptiveRefinementFilter> filter;
    filter->SetInputData(pair);
    filter->SetRefinement(recipe);
    filter->Update();
    CHECK(RelevoWatertight::FindError(pair, filter->GetOutput(), 5).empty());
  }
  return check.GetResult();
}
