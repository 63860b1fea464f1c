// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Rasters of several formats, with sizes, values and georeferences that may be invalid: height
// maps, terrains and pyramids. The first byte chooses the format.
#include "RelevoFuzz.h"
#include "RelevoFuzzAssert.h"
#include "RelevoFuzzFolder.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkHeightMap.h"
#include "vtkNew.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainSource.h"

#include <cmath>

namespace
{
void ReadHeights(const char* file)
{
  vtkNew<vtkHeightMap> map;
  map->SetFileName(file);
  map->SetMaximumDimension(256);
  if (!map->Update())
  {
    return;
  }
  double range[2];
  map->GetRange(range);
  FUZZ_ASSERT(range[0] <= range[1]);
  FUZZ_ASSERT(std::isfinite(map->GetHeight(0.3, 0.6)));
}

void ReadTerrain(const char* file)
{
  vtkNew<vtkTerrainSource> terrain;
  terrain->SetFileName(file);
  terrain->SetResolution(4);
  terrain->SetMaximumDimension(256);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(1);
  recipe->SetDisplacement(terrain->GetDisplacement());
  vtkNew<vtkAdaptiveRefinementFilter> refined;
  refined->SetInputConnection(terrain->GetOutputPort());
  refined->SetRefinement(recipe);
  refined->Update();
  FUZZ_ASSERT(RelevoFuzz::IsFinite(terrain->GetOutput()));
  FUZZ_ASSERT(RelevoFuzz::IsFinite(refined->GetOutput()));
}

void ReadPyramid(const char* file)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(file);
  if (!pyramid->Update())
  {
    return;
  }
  pyramid->WaitForIndex();
  const int* size = pyramid->GetDimensions();
  if (size[0] > 512 || size[1] > 512)
  {
    return; // larger meshes only take longer
  }
  vtkNew<vtkTerrainMeshSource> mesh;
  mesh->SetPyramid(pyramid);
  mesh->SetMaximumError(1.0);
  mesh->Update();
  FUZZ_ASSERT(RelevoFuzz::IsFinite(mesh->GetOutput()));
}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  static const RelevoFuzzFolder folder;
  static const std::vector<std::string> formats = { ".asc", ".pgm", ".tif", ".hgt", ".png" };
  vtkObject::GlobalWarningDisplayOff();
  RelevoFuzz::Dice dice(bytes, size);
  const std::string extension = dice.Choose(formats);
  const std::string file = folder.Write("a" + extension, dice.TakeBytes());
  ReadHeights(file.c_str());
  ReadTerrain(file.c_str());
  ReadPyramid(file.c_str());
  return 0;
}
