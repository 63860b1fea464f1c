// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkScalarTaggedSurface promises the same creases and cusps on the GPU as in the filter. Without
// tags, pictures equal those of PN triangles, bit for bit. Tags may change between frames.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDisplacement.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkScalarTaggedSurface.h"

#include <cmath>

namespace
{
using namespace RelevoMeshes;

Mesh ScalarTagged(Mesh mesh, unsigned int seed)
{
  AddTags(mesh, seed, 5);
  AddRandomScalarTags(mesh, seed);
  return mesh;
}

// A crease around the equator.
Mesh Creased()
{
  Mesh mesh = Sphere(12, 7);
  AddTags(mesh, 2, 5);
  const auto sharpness = AddScalarTags(mesh, "Sharpness");
  const auto direction = AddScalarTags(mesh, "Direction", 3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    sharpness->SetValue(i, std::abs(p[2]) < 1e-6 ? 1.0f : 0.0f);
    direction->SetTuple3(i, -p[1], p[0], 0.0);
  }
  return mesh;
}

RelevoPicture Draw(vtkPolyData* mesh, vtkRefinementSurface* surface)
{
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, MakeRecipe(5, surface));
  scene.ResetCameras();
  scene.Render();
  return RelevoPicture(scene.Window);
}
}

int TestAdaptiveRefinementMapperScalarTags(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  vtkNew<vtkScalarTaggedSurface> surface;
  vtkNew<vtkPNTriangleSurface> pn;
  // The tolerance is that of TestAdaptiveRefinementMapperTwin.
  const RelevoTolerance close{ 2, 2e-6, 10 };
  const auto compare = [&](const std::string& name, const RelevoComparison::Builder& build,
                         const std::vector<RelevoComparison::Step>& steps = {})
  { comparison.Compare("ScalarTags." + name, close, build, steps); };

  compare("Crease", [&](RelevoScene& s) { s.Add(Creased(), MakeRecipe(5, surface)); });
  for (unsigned int seed = 1; seed < 6; ++seed)
  {
    compare("Random" + std::to_string(seed),
      [&](RelevoScene& s) { s.Add(ScalarTagged(Sphere(9, 7), seed), MakeRecipe(5, surface)); });
  }
  compare("Seams",
    [&](RelevoScene& s) { s.Add(ScalarTagged(TexturedSphere(9, 7), 3), MakeRecipe(5, surface)); });
  compare("SplitNormals",
    [&](RelevoScene& s) { s.Add(ScalarTagged(Cone(), 4), MakeRecipe(5, surface)); });
  vtkNew<vtkDisplacement> displacement;
  vtkNew<RelevoHeights> heights;
  heights->Fill(64, 64, [](double u, double v) { return std::sin(19 * u) * std::sin(17 * v); });
  displacement->SetHeightMap(heights);
  displacement->SetScale(0.05);
  compare("Displaced",
    [&](RelevoScene& s)
    { s.Add(ScalarTagged(TexturedSphere(9, 7), 5), MakeRecipe(5, surface, displacement)); });

  // These tags change between frames.
  Mesh changing = Creased();
  compare("Changing", [&](RelevoScene& s) { s.Add(changing, MakeRecipe(5, surface)); },
    { { "Soft",
        [&](RelevoScene&)
        {
          changing->GetPointData()->GetArray("Sharpness")->Fill(0.3);
          changing->GetPointData()->GetArray("Sharpness")->Modified();
        } },
      { "Tense",
        [&](RelevoScene&)
        {
          if (!changing->GetPointData()->HasArray("Tension"))
          {
            AddScalarTags(changing, "Tension")->Fill(0.8);
          }
        } },
      { "NoDirection", [&](RelevoScene&) { surface->SetDirectionArrayName(""); } } });
  surface->SetDirectionArrayName("Direction");

  // The mesh has no tags, or zero tags.
  for (bool zeros : { false, true })
  {
    for (Mesh mesh : { Sphere(9, 7), Cone() })
    {
      AddTags(mesh, 6, 5);
      if (zeros)
      {
        AddScalarTags(mesh, "Sharpness");
        AddScalarTags(mesh, "Tension");
        AddScalarTags(mesh, "Bias");
      }
      comparison.Compare(
        zeros ? "ScalarTags.Zeros" : "ScalarTags.None", {}, Draw(mesh, surface), Draw(mesh, pn));
    }
  }

  // An invalid array is an error of the mapper.
  Mesh mesh = Sphere(9, 7);
  AddScalarTags(mesh, "Tension", 2);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, MakeRecipe(5, surface));
  RelevoErrors errors(scene.GetMapper(0));
  scene.ResetCameras();
  scene.Render();
  CHECK(errors.Said("\"Tension\" has 47 tuples of 2 components"));
  return check.GetResult();
}
