// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a height map shared by filters in two threads is read once.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCommand.h"
#include "vtkDisplacement.h"
#include "vtkHeightMap.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace
{
// Waits, so that the other thread starts reading too.
class SlowReading : public vtkCommand
{
public:
  static SlowReading* New() { return new SlowReading; }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    ++this->Number;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }

  std::atomic<int> Number{ 0 };
};

void Run(vtkAdaptiveRefinement* recipe, double bounds[6])
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->SetRefinement(recipe);
  filter->Update();
  filter->GetOutput()->GetBounds(bounds);
}
}

int TestHeightMapThreads(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  RelevoRaster raster;
  raster.Width = 50;
  raster.Height = 40;
  raster.SetValues([](int, int column, int row) { return (column * 7 + row * 3) % 60; });
  const std::string file = folders.File("HeightMapThreads.tif");
  CHECK(raster.Write(file));

  vtkNew<vtkHeightMap> map;
  map->SetFileName(file.c_str());
  vtkNew<SlowReading> reading;
  map->AddObserver(vtkCommand::ProgressEvent, reading);
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(map);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(5);
  recipe->SetDisplacement(displacement);
  for (int i = 1; i <= 3; ++i)
  {
    map->Modified();
    double first[6];
    double second[6];
    std::thread thread([&] { Run(recipe, first); });
    Run(recipe, second);
    thread.join();
    CHECK_EQUAL(reading->Number, i);
    CHECK(first[5] == second[5] && first[5] > 10.0);
  }
  return check.GetResult();
}
