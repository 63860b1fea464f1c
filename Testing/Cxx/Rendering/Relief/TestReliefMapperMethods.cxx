// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// All methods and searches of vtkReliefMapper, against rays in double precision, in moderate views.
#include "RelevoCheck.h"
#include "RelevoReliefScene.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <iostream>

namespace
{
using relevo::ReliefProjection;

struct Way
{
  int Method;
  int Search;
  double ShareHit;   // at least of the pixels that rays hit
  double ShareRight; // at least of the hits, within half a texel
};

void TestWay(RelevoCheck& check, vtkImageData* relief, const Way& way)
{
  RelevoReliefScene scene(relief, 120, 90);
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetMethod(way.Method);
  scene.Mapper->SetSearch(way.Search);
  for (double azimuth : { -30.0, 0.0, 40.0 })
  {
    scene.ResetCamera();
    scene.GetCamera()->Azimuth(azimuth);
    scene.Renderer->ResetCameraClippingRange();
    const RelevoReliefComparison result = scene.Compare(relief);
    std::cout << "method " << way.Method << ", search " << way.Search << ", azimuth " << azimuth
              << ": " << result.NumberOfHits << " hits, " << result.NumberOfMisses << " missed, "
              << result.NumberOfWrong << " wrong, " << result.NumberFar << " far\n";
    CHECK(result.NumberOfHits > 500);
    CHECK(result.NumberOfMisses <= (1.0 - way.ShareHit) * result.NumberOfHits);
    CHECK(result.GetShareRight() >= way.ShareRight);
  }
  CHECK(errors.None());
}
}

int TestReliefMapperMethods(int, char*[])
{
  RelevoCheck check;
  const auto parallel =
    RelevoMakeRelief(48, 40, ReliefProjection::Parallel, RelevoSmallTexels(), RelevoHillsWithHoles);
  const auto perspective =
    RelevoMakeRelief(48, 40, ReliefProjection::Perspective, RelevoPinhole(48, 40, 0.025),
      [](int column, int row) { return 0.5 * RelevoHillsWithHoles(column, row); });
  using Mapper = vtkReliefMapper;
  for (const auto& relief : { parallel, perspective })
  {
    TestWay(check, relief, { Mapper::METHOD_REFINEMENT, 3, 0.998, 0.998 });
    TestWay(check, relief, { Mapper::METHOD_RAY_MARCH, Mapper::SEARCH_LINEAR_BINARY, 0.98, 0.98 });
    TestWay(check, relief, { Mapper::METHOD_RAY_MARCH, Mapper::SEARCH_LINEAR_SECANT, 0.98, 0.98 });
  }
  return check.GetResult();
}
