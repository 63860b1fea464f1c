// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What vtkGPUUnstructuredGridVolumeMapper counts, and what it does not build anew.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkPiecewiseFunction.h"
#include "vtkUnstructuredGrid.h"

int TestGPUUnstructuredGridVolumeMapperCounters(int, char*[])
{
  RelevoCheck check;
  const auto mesh = MakeTetrahedra(5, GetLinearField);
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.0, 1.0));
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  scene.Draw();
  const vtkIdType cells = mesh->GetNumberOfCells();
  CHECK(mapper->GetNumberOfDrawnCells() == cells);
  CHECK(mapper->GetNumberOfBufferBuilds() == 1);
  CHECK(mapper->GetNumberOfTableBuilds() == 1);
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  CHECK(shaders > 0);
  const int border = 6 * 2 * 25;
  CHECK(mapper->GetGraphicsMemorySize() <=
    20 * cells + 16 * mesh->GetNumberOfPoints() + 32 * border + (4 << 20));

  // Cameras, sizes, edits and isovalues build nothing.
  scene.GetCamera()->Azimuth(20.0);
  scene.Draw();
  scene.GetWindow()->SetSize(90, 80);
  const auto before = scene.Draw();
  scene.GetVolume()->GetProperty()->GetScalarOpacity()->AddPoint(0.5, 1.0);
  const auto after = scene.Draw();
  CHECK(FindLargestDifference(before, after) > 0.1);
  CHECK(scene.Compare() <= 1.0);
  scene.GetVolume()->GetProperty()->SetScalarOpacityUnitDistance(3.0);
  CHECK(scene.Compare() <= 1.0);
  CHECK(mapper->GetNumberOfBufferBuilds() == 1);
  CHECK(mapper->GetNumberOfTableBuilds() == 1);
  CHECK(mapper->GetNumberOfShaderBuilds() == shaders);

  // A new mesh does.
  mesh->Modified();
  scene.Draw();
  CHECK(mapper->GetNumberOfBufferBuilds() == 2);
  CHECK(mapper->GetNumberOfShaderBuilds() == shaders);
  return check.GetResult();
}
