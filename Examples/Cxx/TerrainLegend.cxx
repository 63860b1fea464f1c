// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a terrain with water and land, and a legend that names the unit of the heights, without a
 * display: TerrainLegend [HEIGHTMAP]. Without an argument, it draws an island.
 */
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkEGLOffscreenRenderWindow.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

// Writes heights from -60 to 40 as an ESRI ASCII grid.
static std::string WriteIsland()
{
  const std::string name = "island.asc";
  const int size = 65;
  std::ofstream file(name);
  file << "ncols " << size << "\nnrows " << size << "\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const double distance = std::hypot(column - size / 2, row - size / 2) / (size / 2);
      file << std::fmax(40.0 - 80.0 * distance, -60.0) << (column + 1 < size ? ' ' : '\n');
    }
  }
  return name;
}

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : WriteIsland();
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(name.c_str());
  if (!pyramid->Update() || !pyramid->WaitForIndex())
  {
    std::cerr << pyramid->GetErrorMessage() << "\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkTerrainMapper> mapper;
  mapper->SetPyramid(pyramid);
  mapper->SetLoadingModeToComplete(); // there is only one frame
  mapper->SetColorModeToElevation();
  mapper->UseSeaLevelOn();

  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(mapper->GetLegendLookupTable());
  bar->SetTitle(mapper->GetLegendTitle().c_str());

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->AddViewProp(bar);
  vtkNew<vtkEGLOffscreenRenderWindow> window;
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render(); // looks from above
  std::cout << bar->GetTitle() << "\n";

  // The centre of the island is land, and its shore is in the water.
  const auto isBlue = [&](int x, int y)
  {
    const std::unique_ptr<unsigned char[]> pixel(window->GetPixelData(x, y, x, y, 0, 0));
    return pixel[2] > pixel[0] + 20;
  };
  return argc > 1 || (!isBlue(200, 150) && isBlue(200, 60)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
