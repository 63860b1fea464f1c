// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurface promises closed surfaces without cracks in the picture, for every method, with
// and without displacement.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoLeaks.h"
#include "RelevoMethods.h"
#include "RelevoPatchMeshes.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkPatchSurface.h"

#include <string>
#include <utility>
#include <vector>

using namespace RelevoMeshes;

int TestPatchSurfaceWatertight(int, char*[])
{
  RelevoCheck check;
  const std::pair<const char*, Mesh> meshes[] = { { "torus", RelevoNewPatchTorus() },
    { "sphere", RelevoNewPatchSphere() }, { "cube", RelevoNewPatchCube() } };
  auto displacement = MakeDisplacement(nullptr, 1.0, 0.1);
  std::vector<int> methods = RelevoMethods::GetMethods();
  if (RelevoMethods::HasTessellation())
  {
    methods.push_back(vtkAdaptiveRefinementMapper::METHOD_HARDWARE_TESSELLATION);
  }
  vtkNew<vtkPatchSurface> surface;
  for (const auto& mesh : meshes)
  {
    for (vtkDisplacement* displaced :
      { static_cast<vtkDisplacement*>(nullptr), displacement.Get() })
    {
      for (int method : methods)
      {
        RelevoScene scene(RelevoScene::Refining);
        RelevoLeaks::AddWhite(scene, Tagged(mesh.second, 4), MakeRecipe(4, surface, displaced));
        scene.GetMapper(0)->SetMethod(method);
        size_t covered = 0;
        const size_t leaks = RelevoLeaks::CountLeaks(scene, 6, covered);
        if (leaks > 1 || covered < 20000)
        {
          check.Fail(__FILE__, __LINE__,
            std::string(mesh.first) + ", " + RelevoMethods::GetName(method) +
              (displaced ? ", displaced: " : ": ") + std::to_string(leaks) + " leaks in " +
              std::to_string(covered) + " pixels");
        }
      }
    }
  }
  return check.GetResult();
}
