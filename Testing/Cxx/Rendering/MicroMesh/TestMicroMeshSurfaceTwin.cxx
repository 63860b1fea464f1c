// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshSurface promises the same picture from vtkAdaptiveRefinementMapper as from the
// filter's output in a vtkPolyDataMapper, and closed surfaces without cracks in the picture, for
// every method.
#include "RelevoCheck.h"
#include "RelevoLeaks.h"
#include "RelevoMethods.h"
#include "RelevoMicroMeshes.h"
#include "RelevoScene.h"

#include "vtkMicroMeshSurface.h"
#include "vtkProperty.h"

#include <string>
#include <vector>

using namespace RelevoMeshes;

int TestMicroMeshSurfaceTwin(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  // The tolerance is that of TestAdaptiveRefinementMapperTwin.
  const RelevoTolerance close{ 2, 2e-6, 10 };
  vtkNew<vtkMicroMeshSurface> surface;
  const auto compare = [&](const std::string& name, vtkPolyData* micro, int level)
  {
    comparison.Compare("MicroMeshTwin." + name, close,
      [&](RelevoScene& scene)
      {
        vtkProperty* property = scene.Add(micro, MakeRecipe(level, surface))->GetProperty();
        property->SetSpecular(0.3);
        property->SetSpecularPower(20.0);
      });
  };
  const Mesh sphere = RelevoMicroMeshes::Encode(RelevoMicroMeshes::ReliefSphere(48, 30), 0.005);
  const Mesh plate = RelevoMicroMeshes::Encode(RelevoMicroMeshes::Plate(40), 0.01);
  for (int level : { 0, 2, 4 })
  {
    compare("Sphere" + std::to_string(level), sphere, level);
    compare("Plate" + std::to_string(level), plate, level);
  }
  compare("Tagged", Tagged(sphere, 4), 4);

  for (int method : RelevoMethods::GetMethods())
  {
    CHECK_CASE(RelevoMethods::GetName(method));
    RelevoScene scene(RelevoScene::Refining);
    RelevoLeaks::AddWhite(scene, Tagged(sphere, 4), MakeRecipe(4, surface));
    scene.GetMapper(0)->SetMethod(method);
    size_t covered = 0;
    const size_t leaks = RelevoLeaks::CountLeaks(scene, 4, covered);
    CHECK_LESS_EQUAL(leaks, 1);
    CHECK_GREATER(covered, 15000);
  }
  return check.GetResult();
}
