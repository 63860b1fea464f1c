// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md with real meshes and both methods: the tetrahedra of the coarse post, compared
// also with vtkVolumeRayCastFilter, and the can with cell values and parts that touch.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataSetReader.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cstdlib>
#include <string>

namespace
{
constexpr int NumberOfModes = 6;

void TestPost(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkDataSetReader> reader;
  reader->SetFileName((folder + "post.vtk").c_str());
  reader->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
  CHECK(mesh && mesh->GetNumberOfCells() == 8750);
  if (!mesh)
  {
    return;
  }
  mesh->GetPointData()->SetActiveScalars("Pressure");
  const auto property = MakeVolumeProperty(0.1, 1.0, mesh->GetLength() / 20.0);
  property->GetIsoSurfaceValues()->SetValue(0, 0.9);
  RelevoVolumeScene scene(mesh, property);
  const auto compare = [&](int mode, bool hasSurfaces)
  {
    scene.GetMapper()->SetBlendMode(mode);
    scene.GetMapper()->SetIsoSurfaces(hasSurfaces);
    return scene.Compare(0.001,
      [=](vtkVolumeRayCastFilter* filter)
      {
        filter->SetBlendMode(mode);
        filter->SetIsoSurfaces(hasSurfaces);
      });
  };
  for (int method : { vtkGPUUnstructuredGridVolumeMapper::RAY_CASTING,
         vtkGPUUnstructuredGridVolumeMapper::CELL_PROJECTION })
  {
    CHECK_CASE(method);
    scene.GetMapper()->SetMethod(method);
    property->SetDisableGradientOpacity(1);
    property->ShadeOff();
    for (int mode = 0; mode < NumberOfModes; ++mode)
    {
      CHECK_NEAR(compare(mode, false), 0.0, 1.0);
    }
    property->ShadeOn();
    CHECK_NEAR(compare(0, true), 0.0, 1.0);
    vtkNew<vtkPiecewiseFunction> gradients;
    gradients->AddPoint(0.0, 0.1);
    gradients->AddPoint(20.0 / mesh->GetLength(), 1.0);
    property->SetGradientOpacity(gradients);
    property->SetDisableGradientOpacity(0);
    CHECK_NEAR(compare(0, true), 0.0, 1.0);
  }
}

// Hexahedra, split or not.
void TestCan(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder + "can.vtu").c_str());
  vtkObject::GlobalWarningDisplayOff(); // warnings about keys of another reader
  reader->Update();
  vtkObject::GlobalWarningDisplayOn();
  vtkUnstructuredGrid* mesh = reader->GetOutput();
  CHECK_EQUAL(mesh->GetNumberOfCells(), 4800);
  mesh->GetCellData()->SetActiveScalars("EQPS");
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.1, 1.0, mesh->GetLength() / 20.0));
  for (int mode = 0; mode < NumberOfModes - 1; ++mode)
  {
    scene.GetMapper()->SetBlendMode(mode);
    scene.GetMapper()->SetMethodToRayCasting();
    const auto cast = scene.Draw();
    scene.GetMapper()->SetMethodToCellProjection();
    CHECK_NEAR(RelevoVolumeScene::Compare(scene.Draw(), cast, 0.02), 0.0, 4.0);
  }
}
}

int TestGPUUnstructuredGridVolumeMapperProjectionData(int, char*[])
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  if (!data || !*data)
  {
    return 125;
  }
  const std::string folder = std::string(data) + "/volume/";
  RelevoCheck check;
  TestPost(check, folder);
  TestCan(check, folder);
  return check.GetResult();
}
