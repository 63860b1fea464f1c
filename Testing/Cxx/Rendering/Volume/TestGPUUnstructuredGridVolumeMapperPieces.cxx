// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the merged ray segments of pieces equal the picture of the whole mesh, for pieces of
// any shape.
#include "RelevoCheck.h"
#include "RelevoVolumePieces.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkDataSetReader.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <string>

namespace
{
constexpr int NumberOfModes = 6;
constexpr RelevoDealing Dealings[] = { RelevoDealing::Random, RelevoDealing::Slabs,
  RelevoDealing::Blobs };

constexpr double Rounding = 1e-6;

// At most one pixel of 1000 differs by more than one step of 255, and none by more than two.
void CheckPicture(
  RelevoCheck& check, const std::vector<RelevoColor>& merged, const std::vector<RelevoColor>& drawn)
{
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(merged, drawn), 2.0 + Rounding);
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(merged, drawn, 0.001), 1.0 + Rounding);
}

void ComparePieces(RelevoCheck& check, RelevoVolumeScene& scene,
  const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& dealt)
{
  RelevoVolumePieces pieces(scene, dealt);
  const auto drawn = scene.Draw();
  pieces.Cast();
  CheckPicture(check, pieces.Merge(false), drawn);
  CheckPicture(check, pieces.Merge(true), drawn);
}

void SetSurfaces(RelevoVolumeScene& scene)
{
  vtkContourValues* values = scene.GetVolume()->GetProperty()->GetIsoSurfaceValues();
  values->SetNumberOfContours(2);
  values->SetValue(0, 0.45);
  values->SetValue(1, 0.8);
}

void TestModes(RelevoCheck& check, vtkUnstructuredGrid* mesh)
{
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), 100, 75);
  SetSurfaces(scene);
  for (int mode = 0; mode < NumberOfModes; ++mode)
  {
    scene.GetMapper()->SetBlendMode(mode);
    for (RelevoDealing dealing : Dealings)
    {
      CHECK_CASE(mode);
      CHECK_CASE(static_cast<int>(dealing));
      ComparePieces(check, scene, DealCells(mesh, dealing, 4));
    }
  }
}

// Isosurfaces inside the volume, clipping planes and an opaque ball that cuts the mesh.
void TestScene(RelevoCheck& check, vtkUnstructuredGrid* mesh, int width, int height)
{
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), width, height);
  SetSurfaces(scene);
  scene.GetMapper()->IsoSurfacesOn();
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(mesh->GetCenter());
  ball->SetRadius(0.2 * mesh->GetLength());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.GetRenderer()->AddActor(actor);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(mesh->GetCenter());
  plane->SetNormal(-0.6, 0.3, 0.1);
  ComparePieces(check, scene, DealCells(mesh, RelevoDealing::Awkward, 7));
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  scene.GetMapper()->SetClippingPlanes(planes);
  for (RelevoDealing dealing : Dealings)
  {
    CHECK_CASE(static_cast<int>(dealing));
    ComparePieces(check, scene, DealCells(mesh, dealing, 2));
  }
}

// The eye and the near plane are in the mesh.
void TestInside(RelevoCheck& check, vtkUnstructuredGrid* mesh)
{
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), 100, 75);
  scene.GetCamera()->SetPosition(mesh->GetCenter());
  scene.GetCamera()->SetFocalPoint(2.0, 1.4, 1.1);
  scene.GetCamera()->SetViewAngle(70.0);
  scene.GetCamera()->SetClippingRange(0.01, 10.0);
  ComparePieces(check, scene, DealCells(mesh, RelevoDealing::Random, 3));
}

// Several components, gradient opacities, scalars of cells, tables, and a mesh far from the origin.
void TestData(RelevoCheck& check)
{
  for (int components = 1; components <= 4; ++components)
  {
    const auto mesh = MakeBall(300, 5000.0);
    mesh->GetPointData()->SetScalars(MakeBusyArray(mesh, components));
    RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3, components), 100, 75);
    vtkVolumeProperty* property = scene.GetVolume()->GetProperty();
    property->SetIndependentComponents(components != 2);
    if (components == 3)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.1);
      opacity->AddPoint(2.0, 1.0);
      property->SetGradientOpacity(1, opacity);
    }
    for (int mode = 0; mode < NumberOfModes - 1; ++mode)
    {
      CHECK_CASE(components);
      CHECK_CASE(mode);
      scene.GetMapper()->SetBlendMode(mode);
      ComparePieces(check, scene, DealCells(mesh, RelevoDealing::Random, 4));
    }
  }
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(MakeBall(300));
  toCells->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(toCells->GetOutput());
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), 100, 75);
  ComparePieces(check, scene, DealCells(mesh, RelevoDealing::Random, 4));
  for (int integration : { vtkGPUUnstructuredGridVolumeMapper::PRE_INTEGRATED,
         vtkGPUUnstructuredGridVolumeMapper::PRE_INTEGRATED_2D })
  {
    CHECK_CASE(integration);
    scene.GetMapper()->SetIntegration(integration);
    ComparePieces(check, scene, DealCells(mesh, RelevoDealing::Blobs, 4));
  }
}

// Gradients at shared points need the cells of other pieces.
void TestShading(RelevoCheck& check, vtkUnstructuredGrid* mesh)
{
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3), 100, 75);
  SetSurfaces(scene);
  scene.GetVolume()->GetProperty()->ShadeOn();
  scene.GetMapper()->IsoSurfacesOn();
  for (RelevoDealing dealing : Dealings)
  {
    CHECK_CASE(static_cast<int>(dealing));
    ComparePieces(check, scene, DealCellsWithGhosts(mesh, dealing, 4));
  }
}

void TestFile(RelevoCheck& check, const std::string& name)
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  if (!data)
  {
    return;
  }
  CHECK_CASE(name);
  vtkNew<vtkDataSetReader> reader;
  reader->SetFileName((std::string(data) + "/volume/" + name).c_str());
  reader->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
  if (!mesh || mesh->GetNumberOfCells() == 0)
  {
    return;
  }
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("field");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    for (double& x : at)
    {
      x *= 4.0 / mesh->GetLength();
    }
    scalars->InsertNextValue(GetWaves(at));
  }
  mesh->GetPointData()->SetScalars(scalars);
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.1 * mesh->GetLength()), 400, 300);
  ComparePieces(check, scene, DealCells(mesh, RelevoDealing::Random, 7));
}
}

int TestGPUUnstructuredGridVolumeMapperPieces(int, char*[])
{
  RelevoCheck check;
  for (bool isMixed : { false, true })
  {
    CHECK_CASE(isMixed);
    const auto mesh = isMixed ? MakeMixedCells(6, GetWaves) : MakeBall(800);
    TestModes(check, mesh);
    TestScene(check, mesh, 120, 90);
    TestInside(check, mesh);
    TestShading(check, mesh);
  }
  TestData(check);
  TestScene(check, MakeBall(300), 400, 300);
  TestFile(check, "CylinderQuadratic.vtk");
  TestFile(check, "PentaHexa.vtk");
  return check.GetResult();
}
