// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinedCellLocator promises the intersections that VTK's locator finds on the refined mesh.
// The test uses lines to real terrain, some of them through its holes.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDisplacement.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkRefinedCellLocator.h"
#include "vtkStaticCellLocator.h"
#include "vtkTerrainSource.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace
{
struct Found
{
  int Hit;
  double T;
  double X[3];
  vtkIdType Cell;
};

Found Shoot(vtkAbstractCellLocator* locator, const double p1[3], const double p2[3])
{
  Found found{};
  double pcoords[3];
  int subId;
  vtkNew<vtkGenericCell> cell;
  found.Hit =
    locator->IntersectWithLine(p1, p2, 0.0, found.T, found.X, pcoords, subId, found.Cell, cell);
  return found;
}

void TestFile(RelevoCheck& check, const std::string& name, bool hasHoles)
{
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(name.c_str());
  source->SetResolution(24);
  source->SetExaggeration(3.0);
  source->Update();
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(3);
  recipe->SetDisplacement(source->GetDisplacement());
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetRefinement(recipe);
  filter->Update();
  vtkPolyData* refined = filter->GetOutput();
  vtkNew<vtkStaticCellLocator> oracle;
  oracle->SetDataSet(refined);
  oracle->BuildLocator();
  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(source->GetOutput());
  locator->SetRefinement(recipe);

  double bounds[6];
  refined->GetBounds(bounds);
  std::mt19937 random(17);
  const auto number = [&random]() { return random() / 4294967296.0; };
  vtkDataArray* ids = refined->GetCellData()->GetArray("vtkOriginalCellIds");
  int hits = 0;
  int wrong = 0;
  const int lines = 2000;
  for (int i = 0; i < lines; ++i)
  {
    // Lines lead from above to below. Every second line grazes.
    double p1[3];
    double p2[3];
    for (int c = 0; c < 2; ++c)
    {
      const double length = bounds[2 * c + 1] - bounds[2 * c];
      p1[c] = bounds[2 * c] + length * number();
      p2[c] = i % 2 ? bounds[2 * c] + length * number() : p1[c] + 0.01 * length * number();
    }
    p1[2] = bounds[5] + 1.0;
    p2[2] = bounds[4] - 1.0;
    const Found found = Shoot(locator, p1, p2);
    const Found expected = Shoot(oracle, p1, p2);
    hits += found.Hit;
    const bool same = found.Hit == expected.Hit &&
      (!found.Hit ||
        (std::sqrt(vtkMath::Distance2BetweenPoints(found.X, expected.X)) <
            1e-5 * refined->GetLength() &&
          found.Cell == static_cast<vtkIdType>(ids->GetTuple1(expected.Cell))));
    wrong += same ? 0 : 1;
  }
  CHECK_LESS_EQUAL(wrong, 2); // grazing a rim within rounding
  CHECK_GREATER(hits, lines / 4);
  CHECK_EQUAL((hits < 0.9 * lines), hasHoles); // a few leave at the rim
}
}

int TestTerrainSourcePicks(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  if (folders.RealData.empty())
  {
    std::cout << "Skipped: no relief in RELEVO_TEST_DATA.\n";
    return 125;
  }
  RelevoCheck check;
  const std::string folder = folders.RealData;
  TestFile(check, folder + "luxembourg_elev.tif", true);
  TestFile(check, folder + "olinda_dem_utm25s.tif", false);
  TestFile(check, folder + "N57E011.hgt", false);
  return check.GetResult();
}
