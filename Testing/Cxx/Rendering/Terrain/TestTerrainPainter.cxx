// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The painter of terrains draws the same picture as vtkPolyDataMapper draws of the same triangles.
#include "RelevoTerrainScene.h"

#include "vtkProperty.h"

int TestTerrainPainter(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  RelevoTerrainScene scene;
  scene.Look({ { -80.0, 600.0, 120.0 } }, { { 250.0, 250.0, 0.0 } });
  scene.GetProperty()->SetInterpolationToFlat();
  const RelevoPicture picture = scene.Draw();
  CHECK_EQUAL(scene.Mapper->Error, "");
  picture.Save(comparison.GetFolder() + "/TerrainPainter.png");
  std::cout << scene.Mapper->GetFaces().size() << " faces\n";
  comparison.Compare("TerrainPainter.Flat", { 2, 2e-6, 10 }, picture, scene.DrawTwin());
  scene.GetProperty()->SetInterpolationToGouraud();
  scene.Draw().Save(comparison.GetFolder() + "/TerrainPainter.Smooth.png");
  return check.GetResult();
}
