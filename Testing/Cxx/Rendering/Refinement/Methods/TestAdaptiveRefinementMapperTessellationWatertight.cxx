// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves methods.md: hardware tessellation leaves no cracks. Shared points agree bit for bit, and
// no pixel shows the background.
#include "RelevoDisplacements.h"
#include "RelevoLeaks.h"
#include "RelevoMethods.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"
#include "RelevoVertexCapture.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPNTriangleSurface.h"

#include <cmath>
#include <iostream>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

// Points shared by two faces equal those of ARKFPI and the filter, bit for bit.
void TestPoints(RelevoCheck& check)
{
  for (int kind = 0; kind < 4; ++kind)
  {
    const bool curved = kind & 1;
    const bool whole = kind & 2;
    vtkNew<vtkPNTriangleSurface> surface;
    auto recipe = MakeRecipe(5, curved ? surface.Get() : nullptr);
    recipe->SetSegmentPolicy(
      whole ? vtkAdaptiveRefinement::WHOLE_NUMBERS : vtkAdaptiveRefinement::POWERS_OF_TWO);
    Mesh mesh = Tagged(Sphere(7, 5), 5);
    Mesh fine = Refine(mesh, recipe);

    RelevoScene scene(RelevoScene::Refining);
    vtkActor* actor = scene.Add(mesh, recipe);
    scene.GetMapper(0)->FrustumCullingOff();
    scene.GetMapper(0)->SetSelectionDeviceToCPU();
    scene.ResetCameras();
    RelevoErrors errors(scene.GetMapper(0));
    RelevoVertexCapture capture(actor, 200000);
    scene.GetMapper(0)->SetMethodToARKFPI();
    const RelevoVertexCapture::Points expected = capture.Capture(check, scene);
    scene.GetMapper(0)->SetMethodToHardwareTessellation();
    const RelevoVertexCapture::Points actual = capture.Capture(check, scene);
    CHECK_EQUAL(scene.GetMapper(0)->GetMethodInUse(), Mapper::METHOD_HARDWARE_TESSELLATION);
    CHECK(errors.None());

    // For the filter's points: the face they belong to, or -1 for several.
    std::vector<vtkIdType> owners(static_cast<size_t>(fine->GetNumberOfPoints()), -2);
    auto* cells = vtkIdTypeArray::SafeDownCast(fine->GetCellData()->GetArray("vtkOriginalCellIds"));
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < fine->GetNumberOfCells(); ++cell)
    {
      fine->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        vtkIdType& owner = owners[static_cast<size_t>(ids->GetId(i))];
        owner = owner == -2 || owner == cells->GetValue(cell) ? cells->GetValue(cell) : -1;
      }
    }
    size_t shared = 0;
    size_t lost = 0;
    size_t moved = 0;
    for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
    {
      if (owners[static_cast<size_t>(i)] != -1)
      {
        continue;
      }
      ++shared;
      double p[3];
      fine->GetPoint(i, p);
      const float x = static_cast<float>(p[0]);
      // ARKFPI has these vertices at this point.
      size_t found = 0;
      for (auto near = expected.lower_bound({ { x - 1e-6f, -1e30f, -1e30f } });
           near != expected.end() && (*near)[0] <= x + 1e-6f; ++near)
      {
        if (std::abs((*near)[1] - p[1]) < 1e-6 && std::abs((*near)[2] - p[2]) < 1e-6)
        {
          ++found;
          moved += 1 - actual.count(*near);
        }
      }
      lost += found == 0 ? 1 : 0;
    }
    std::cout << (curved ? "PN" : "Linear") << (whole ? ", whole numbers" : "") << ": " << shared
              << " shared points, " << lost << " not found, " << moved << " moved" << std::endl;
    CHECK_GREATER(shared, 500);
    CHECK_EQUAL(lost, 0);
    CHECK_EQUAL(moved, 0);
  }
}

void TestLeaks(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(64, 64, 9);
  auto displacement = MakeDisplacement(rough, 0.1);
  const struct
  {
    const char* Name;
    Mesh Surface;
    int Level;
    int Views;
    bool WholeNumbers;
  } subjects[] = { { "Sphere", Tagged(Textured(Sphere(9, 7)), 5), 5, 12, false },
    { "Cube", Tagged(Textured(Cube()), 6), 6, 12, false },
    { "Strips", Tagged(Textured(Strips()), 5), 5, 8, true },
    { "MoreThan64", Tagged(Textured(Sphere(3, 3)), 7), 7, 8, false } };
  for (const auto& subject : subjects)
  {
    CHECK_CASE(subject.Name);
    auto recipe = MakeRecipe(subject.Level, surface, displacement);
    recipe->SetSegmentPolicy(subject.WholeNumbers ? vtkAdaptiveRefinement::WHOLE_NUMBERS
                                                  : vtkAdaptiveRefinement::POWERS_OF_TWO);
    RelevoScene scene(RelevoScene::Refining);
    RelevoLeaks::AddWhite(scene, subject.Surface, recipe);
    scene.GetMapper(0)->SetMethodToHardwareTessellation();
    size_t covered = 0;
    const size_t leaks = RelevoLeaks::CountLeaks(scene, subject.Views, covered);
    std::cout << subject.Name << ": " << leaks << " leaks in " << covered << " pixels" << std::endl;
    CHECK_EQUAL(leaks, 0);
    CHECK_GREATER(covered, 50000);
    CHECK_EQUAL(scene.GetMapper(0)->GetMethodInUse(), Mapper::METHOD_HARDWARE_TESSELLATION);
  }
}

// Surfaces are closed where faces of several levels meet, and at corners with several normals.
void TestLeaksOfSurfaces(RelevoCheck& check)
{
  for (const auto& kind : RelevoMakeSurfaces())
  {
    for (const Mesh& mesh : { Tagged(Sphere(7, 5), 5), Tagged(Cube(), 5) })
    {
      RelevoScene scene(RelevoScene::Refining);
      RelevoLeaks::AddWhite(scene, mesh, MakeRecipe(5, kind.second));
      scene.GetMapper(0)->SetMethodToHardwareTessellation();
      size_t covered = 0;
      const size_t leaks = RelevoLeaks::CountLeaks(scene, 4, covered);
      std::cout << kind.first << ": " << leaks << " leaks in " << covered << " pixels" << std::endl;
      CHECK_EQUAL(leaks, 0);
      CHECK_GREATER(covered, 10000);
    }
  }
}
}

int TestAdaptiveRefinementMapperTessellationWatertight(int, char*[])
{
  RelevoCheck check;
  if (RelevoMethods::HasTessellation())
  {
    TestPoints(check);
    TestLeaks(check);
    TestLeaksOfSurfaces(check);
  }
  return check.GetResult();
}
