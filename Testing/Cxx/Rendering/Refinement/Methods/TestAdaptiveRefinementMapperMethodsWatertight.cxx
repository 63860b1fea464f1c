// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that no method shows a crack between faces of random levels (see RelevoLeaks.h).
#include "RelevoDisplacements.h"
#include "RelevoLeaks.h"
#include "RelevoMethods.h"
#include "RelevoTestMeshes.h"

#include "vtkPNTriangleSurface.h"

#include <iostream>

namespace
{
using namespace RelevoLeaks;
using namespace RelevoMeshes;
using namespace RelevoMethods;

void TestClosed(RelevoCheck& check, const std::string& name, Mesh mesh, bool wholeNumbers)
{
  const int level = 5;
  if (!IsClosed(mesh))
  {
    check.Fail(__FILE__, __LINE__, name + " is not closed: nothing is tested");
    return;
  }
  AddTags(mesh, 5, level);
  double bounds[6];
  mesh->GetBounds(bounds);
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(64, 64, 9);
  auto displacement = MakeDisplacement(rough, 0.1 * (bounds[1] - bounds[0]));
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(level);
  recipe->SetSurface(surface);
  recipe->SetDisplacement(displacement);
  recipe->SetGeomorphing(0);
  if (wholeNumbers)
  {
    recipe->SetSegmentPolicyToWholeNumbers();
  }
  RelevoScene scene(RelevoScene::Refining);
  AddWhite(scene, mesh, recipe);
  for (int method : GetMethods())
  {
    if (wholeNumbers && method == Mapper::METHOD_DMR)
    {
      continue; // bisects edges
    }
    scene.GetMapper(0)->SetMethod(method);
    size_t covered = 0;
    const size_t leaks = CountLeaks(scene, 12, covered);
    std::cout << name << ", " << GetName(method) << ": " << leaks << " leaks in " << covered
              << " pixels" << std::endl;
    CHECK_EQUAL(scene.GetMapper(0)->GetMethodInUse(), method);
    if (leaks > 0 || covered < 50000)
    {
      check.Fail(__FILE__, __LINE__, name + " leaks with " + GetName(method));
    }
  }
}
}

int TestAdaptiveRefinementMapperMethodsWatertight(int, char*[])
{
  RelevoCheck check;
  Mesh exploded = Explode(Sphere(9, 7));
  PerturbNormals(exploded, 2, 0.5);
  AddRandomTextureCoordinates(exploded, 6);
  TestClosed(check, "SphereWithTextureSeam", TexturedSphere(12, 8), false);
  TestClosed(check, "CubeWithSplitNormals", Cube(), false);
  TestClosed(check, "EveryTriangleWithPointsOfItsOwn", exploded, false);
  TestClosed(check, "WholeNumbers", TexturedSphere(12, 8), true);
  return check.GetResult();
}
