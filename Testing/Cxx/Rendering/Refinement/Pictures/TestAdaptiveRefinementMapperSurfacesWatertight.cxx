// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves surfaces.md: no surface opens a crack, with or without displacement. Faces share points
// bit for bit, with split or shared normals.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoLeaks.h"
#include "RelevoScene.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"
#include "RelevoVertexCapture.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkIdList.h"

#include <array>
#include <set>

using namespace RelevoMeshes;

namespace
{
// Number of distinct vertex positions in the shader. If faces differed by a single bit, there would
// be more.
size_t CountPlaces(RelevoCheck& check, vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  RelevoScene scene(RelevoScene::Refining);
  vtkActor* actor = scene.Add(mesh, recipe);
  scene.GetMapper(0)->FrustumCullingOff();
  scene.ResetCameras();
  RelevoVertexCapture capture(actor, 400000);
  return capture.Capture(check, scene).size();
}

// Number of distinct positions of triangle corners. Points of dropped faces are not displaced.
size_t CountPlaces(vtkPolyData* mesh)
{
  std::set<std::array<float, 3>> places;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType id : *ids)
    {
      const double* p = mesh->GetPoint(id);
      places.insert(
        { { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) } });
    }
  }
  return places.size();
}
}

int TestAdaptiveRefinementMapperSurfacesWatertight(int, char*[])
{
  RelevoCheck check;
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(64, 64, 9);
  auto displacement = MakeDisplacement(rough, 0.05);
  Mesh split = Explode(Sphere(9, 7));
  PerturbNormals(split, 2, 0.5);
  AddRandomTextureCoordinates(split, 6);
  const std::pair<const char*, Mesh> meshes[] = { { "seam", TexturedSphere(10, 7) },
    { "split", split } };
  for (const auto& mesh : meshes)
  {
    CHECK(RelevoLeaks::IsClosed(mesh.second));
    for (const auto& surface : RelevoMakeSurfaces(0.3))
    {
      for (vtkDisplacement* displaced :
        { static_cast<vtkDisplacement*>(nullptr), displacement.Get() })
      {
        RelevoScene scene(RelevoScene::Refining);
        const auto recipe = MakeRecipe(5, surface.second, displaced);
        RelevoLeaks::AddWhite(scene, Tagged(mesh.second, 5), recipe);
        size_t covered = 0;
        const size_t leaks = RelevoLeaks::CountLeaks(scene, 12, covered);
        // OpenGL may treat the front of a sliver seen edge-on as its back. CountPlaces() proves
        // that faces share their points.
        if (leaks > 1 || covered < 50000)
        {
          check.Fail(__FILE__, __LINE__,
            std::string(mesh.first) + ", " + surface.first + (displaced ? ", displaced: " : ": ") +
              std::to_string(leaks) + " leaks in " + std::to_string(covered) + " pixels");
        }
        const size_t places = CountPlaces(check, mesh.second, recipe);
        const size_t expected = CountPlaces(Refine(mesh.second, recipe));
        if (places != expected)
        {
          check.Fail(__FILE__, __LINE__,
            std::string(mesh.first) + ", " + surface.first + (displaced ? ", displaced: " : ": ") +
              std::to_string(places) + " places drawn, the filter's are " +
              std::to_string(expected));
        }
      }
    }
  }
  return check.GetResult();
}
