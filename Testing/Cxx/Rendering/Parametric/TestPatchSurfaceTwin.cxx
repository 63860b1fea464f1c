// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurface promises the same picture from vtkAdaptiveRefinementMapper as from the filter's
// output in a vtkPolyDataMapper, including sharp edges.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoPatchMeshes.h"
#include "RelevoPatches.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCellType.h"
#include "vtkPatchSurface.h"
#include "vtkProperty.h"

using namespace RelevoMeshes;

int TestPatchSurfaceTwin(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  // The tolerance is that of TestAdaptiveRefinementMapperTwin.
  const RelevoTolerance close{ 2, 2e-6, 10 };
  vtkNew<vtkPatchSurface> surface;
  vtkNew<RelevoHeights> heights;
  heights->FillWaves();
  const auto compare = [&](const std::string& name, vtkPolyData* patches, int level,
                         vtkDisplacement* displacement = nullptr)
  {
    comparison.Compare("PatchTwin." + name, close,
      [&](RelevoScene& scene)
      {
        vtkProperty* property =
          scene.Add(patches, MakeRecipe(level, surface, displacement))->GetProperty();
        property->SetSpecular(0.3);
        property->SetSpecularPower(20.0);
      });
  };
  const Mesh bracket = RelevoMakePatches(RelevoNewBracket());
  const Mesh bent = RelevoMakePatches(RelevoNewBracket(0.15));
  for (int level : { 0, 1, 3 })
  {
    compare("Bracket" + std::to_string(level), bracket, level);
    compare("Bent" + std::to_string(level), bent, level);
  }
  compare("Tagged", Tagged(bent, 4), 4);
  compare("Displaced", bent, 3, MakeDisplacement(nullptr, 1.0, 0.1));
  compare("Heights", Textured(bent), 4, MakeDisplacement(heights, 0.05));
  compare("Cube", RelevoNewPatchCube(), 4);
  compare("Sphere", RelevoNewPatchSphere(), 4);
  compare(
    "Wedge", RelevoMakePatches(RelevoNewCell(VTK_LAGRANGE_WEDGE, { { 2, 2, 2 } }, 0.1), true), 3);
  return check.GetResult();
}
