// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves the counters of vtkGPUUnstructuredGridVolumeMapper, and volumes.md: cameras and edited
// functions build nothing.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkContourValues.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkUnstructuredGrid.h"

namespace
{
// Draws the volume in all modes, with edited settings.
void DrawAll(RelevoVolumeScene& scene, double edit)
{
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  vtkVolumeProperty* property = scene.GetVolume()->GetProperty();
  property->GetIsoSurfaceValues()->SetValue(0, 0.5 + edit);
  for (int mode = 1; mode < 6; ++mode)
  {
    mapper->SetBlendMode(mode);
    scene.Draw();
  }
  mapper->SetBlendModeToComposite();
  mapper->IsoSurfacesOn();
  scene.Draw();
  mapper->IsoSurfacesOff();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.4 + edit, 0.0, 0.0);
  mapper->AddClippingPlane(plane);
  scene.Draw();
  mapper->AddClippingPlane(plane);
  scene.Draw();
  mapper->RemoveAllClippingPlanes();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, edit);
  opacity->AddPoint(0.6, 0.7);
  property->SetGradientOpacity(opacity);
  property->SetDisableGradientOpacity(0);
  scene.Draw();
  property->SetDisableGradientOpacity(1);
  property->ShadeOn();
  property->SetDiffuse(0.7 + edit);
  scene.Draw();
  property->ShadeOff();
  scene.Draw();
}

void TestFeatures(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(5, GetLinearField), MakeVolumeProperty(0.0, 1.0));
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  const auto before = scene.Draw();
  const vtkTypeInt64 size = mapper->GetGraphicsMemorySize();
  DrawAll(scene, 0.0);
  CHECK_EQUAL(FindLargestDifference(scene.Draw(), before), 0.0);
  // The mesh is uploaded again with its gradients.
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 2);
  CHECK_GREATER_EQUAL(mapper->GetGraphicsMemorySize(), size + 16 * 6 * 6 * 6 - 16);
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  DrawAll(scene, 0.1);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 2);
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 0);
}
}

int TestGPUUnstructuredGridVolumeMapperCounters(int, char*[])
{
  RelevoCheck check;
  TestFeatures(check);
  const auto mesh = MakeTetrahedra(5, GetLinearField);
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.0, 1.0));
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  scene.Draw();
  const vtkIdType cells = mesh->GetNumberOfCells();
  CHECK_EQUAL(mapper->GetNumberOfDrawnCells(), cells);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 1);
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 0);
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  CHECK_GREATER(shaders, 0);
  const int border = 6 * 2 * 25;
  CHECK_LESS_EQUAL(mapper->GetGraphicsMemorySize(),
    20 * cells + 16 * mesh->GetNumberOfPoints() + 32 * border + (4 << 20));

  // Cameras, sizes, edits and isovalues build nothing.
  scene.GetCamera()->Azimuth(20.0);
  scene.Draw();
  scene.GetWindow()->SetSize(90, 80);
  const auto before = scene.Draw();
  scene.GetVolume()->GetProperty()->GetScalarOpacity()->AddPoint(0.5, 1.0);
  const auto after = scene.Draw();
  CHECK_GREATER(FindLargestDifference(before, after), 0.1);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  scene.GetVolume()->GetProperty()->SetScalarOpacityUnitDistance(3.0);
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 1);
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 0);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);

  // A new mesh is uploaded.
  mesh->Modified();
  scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 2);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
  return check.GetResult();
}
