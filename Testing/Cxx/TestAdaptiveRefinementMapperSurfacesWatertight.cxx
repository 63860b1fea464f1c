// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// No pixel shows a crack in any of the surfaces, displaced along their normals too; normals are
// split everywhere or nowhere.
#include "RelevoCheck.h"
#include "RelevoLeaks.h"
#include "RelevoScene.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"

using namespace RelevoMeshes;

int TestAdaptiveRefinementMapperSurfacesWatertight(int, char*[])
{
  RelevoCheck check;
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(64, 64, 9);
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(rough);
  displacement->SetScale(0.05);
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
        RelevoLeaks::AddWhite(
          scene, Tagged(mesh.second, 5), MakeRecipe(5, surface.second, displaced));
        size_t covered = 0;
        const size_t leaks = RelevoLeaks::CountLeaks(scene, 12, covered);
        // OpenGL may take the front of a sliver seen edge-on for its back; cracks show hundreds.
        if (leaks > 1 || covered < 50000)
        {
          check.Fail(__FILE__, __LINE__,
            std::string(mesh.first) + ", " + surface.first + (displaced ? ", displaced: " : ": ") +
              std::to_string(leaks) + " leaks in " + std::to_string(covered) + " pixels");
        }
      }
    }
  }
  return check.GetResult();
}
