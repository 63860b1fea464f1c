// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Moving views draw a simplified mesh that is made in the background; still views draw the full
// one. The error is that of the field. Changes and deletion while it is made are safe.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"

#include <chrono>
#include <cmath>
#include <thread>

namespace
{
constexpr int Width = 60;
constexpr int Height = 48;

double GetBump(const RelevoPoint& at)
{
  const double distance =
    std::pow(at[0] - 0.5, 2.0) + std::pow(at[1] - 0.4, 2.0) + std::pow(at[2] - 0.6, 2.0);
  return std::exp(-8.0 * distance);
}

// Draws until the simplified mesh is ready. Ends without one if it is never made.
vtkIdType Wait(RelevoVolumeScene& scene)
{
  for (int i = 0; i < 6000 && scene.GetMapper()->GetNumberOfLevelOfDetailCells() == 0; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return scene.GetMapper()->GetNumberOfLevelOfDetailCells();
}

double FindMean(const std::vector<RelevoColor>& a, const std::vector<RelevoColor>& b)
{
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(a[i][0] - b[i][0]) + std::abs(a[i][2] - b[i][2]);
  }
  return sum / static_cast<double>(a.size());
}

void SetMoving(RelevoVolumeScene& scene, bool isMoving)
{
  scene.GetWindow()->SetDesiredUpdateRate(isMoving ? 15.0 : 1e-3);
}

struct Scene : public RelevoVolumeScene
{
  explicit Scene(vtkDataObject* mesh)
    : RelevoVolumeScene(mesh, MakeVolumeProperty(0.1, 1.0, 0.4), Width, Height)
  {
    this->GetMapper()->AutoAdjustSampleDistancesOff();
    this->GetMapper()->SetLevelOfDetail(0.2);
  }
};

// Still frames are full, moving ones nearly so. Isosurfaces, functions and the other method work.
void TestMoving(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(8, GetBump);
  Scene scene(mesh);
  RelevoErrors errors(scene.GetMapper());
  CHECK_EQUAL(scene.GetMapper()->GetLevelOfDetailError(), 0.0);
  const auto full = scene.Draw();
  const vtkIdType cells = Wait(scene);
  CHECK_LESS_EQUAL(cells, 0.25 * static_cast<double>(mesh->GetNumberOfCells()));
  CHECK_GREATER(cells, 0.1 * static_cast<double>(mesh->GetNumberOfCells()));
  const double error = scene.GetMapper()->GetLevelOfDetailError();
  CHECK_GREATER(error, 1e-3);
  CHECK_LESS(error, 0.2);
  const vtkIdType builds = scene.GetMapper()->GetNumberOfBufferBuilds();
  for (const int method : { 0, 1 })
  {
    CHECK_CASE(method);
    scene.GetMapper()->SetMethod(method);
    scene.GetMapper()->SetLevelOfDetail(0.2);
    SetMoving(scene, false);
    scene.Draw();
    Wait(scene);
    SetMoving(scene, true);
    const auto moving = scene.Draw();
    const double mean = FindMean(full, moving);
    CHECK_GREATER(mean, 0.0);
    CHECK_LESS(mean, 0.02);
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
    SetMoving(scene, false);
    CHECK_LESS_EQUAL(FindLargestDifference(full, scene.Draw()), 2.0 / 255.0);
  }
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), builds + 1); // for the other method
  scene.GetMapper()->SetLevelOfDetail(0.0);
  SetMoving(scene, true);
  CHECK_LESS_EQUAL(FindLargestDifference(full, scene.Draw()), 2.0 / 255.0);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfLevelOfDetailCells(), 0);
  CHECK(errors.None());
  scene.GetMapper()->SetLevelOfDetail(1.5);
  CHECK(errors.Said("LevelOfDetail"));
  CHECK_EQUAL(scene.GetMapper()->GetLevelOfDetail(), 0.0);
}

// A linear field stays linear, in any cells, and with values of cells an error is told.
void TestCells(RelevoCheck& check)
{
  const auto linear = [](const RelevoPoint& at) { return 0.1 + 0.02 * at[0] + 0.08 * at[1]; };
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON })
  {
    CHECK_CASE(type);
    Scene scene(MakeBlocksOfCells(type, linear));
    scene.GetMapper()->SetLevelOfDetail(0.5);
    const auto full = scene.Draw();
    CHECK_GREATER(Wait(scene), 0);
    CHECK_LESS(scene.GetMapper()->GetLevelOfDetailError(), 0.03);
    SetMoving(scene, true);
    CHECK_LESS(FindMean(full, scene.Draw()), 0.05);
  }
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(MakeTetrahedra(5, GetBump));
  toCells->Update();
  Scene scene(toCells->GetOutput());
  const auto full = scene.Draw();
  CHECK_GREATER(Wait(scene), 0);
  SetMoving(scene, true);
  const double mean = FindMean(full, scene.Draw());
  CHECK_GREATER(mean, 0.0);
  CHECK_LESS(mean, 0.1);
}

// New values give a new mesh. Until it is ready, moving views show the full one.
void TestChanges(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(6, GetBump);
  Scene scene(mesh);
  scene.Draw();
  Wait(scene);
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 10.0 + values->GetComponent(i, 0));
  }
  values->Modified();
  mesh->Modified();
  SetMoving(scene, true);
  scene.Draw();
  Wait(scene);
  CHECK_LESS(scene.GetMapper()->GetLevelOfDetailError(), 0.3);
  const auto moving = scene.Draw();
  SetMoving(scene, false);
  CHECK_LESS(FindMean(moving, scene.Draw()), 0.02);

  vtkNew<vtkDoubleArray> two;
  two->SetNumberOfComponents(2);
  two->SetNumberOfTuples(mesh->GetNumberOfPoints());
  two->Fill(0.5);
  mesh->GetPointData()->SetScalars(two);
  mesh->Modified();
  RelevoErrors errors(scene.GetMapper());
  scene.Draw();
  CHECK(errors.Warned("LevelOfDetail supports only one component"));
  scene.Draw();
  CHECK(errors.None());
}

// Mappers end, or get other meshes, while the thread works.
void TestThread(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(12, GetBump);
  const auto other = MakeTetrahedra(3, GetLinearField);
  {
    Scene scene(mesh);
    scene.Draw();
  }
  Scene scene(mesh);
  for (int i = 0; i < 4; ++i)
  {
    scene.GetMapper()->SetInputData(i % 2 == 0 ? mesh : other);
    scene.Draw();
  }
  scene.GetMapper()->SetLevelOfDetail(0.0);
  scene.Draw();
  scene.GetMapper()->SetLevelOfDetail(0.4);
  scene.GetMapper()->SetInputData(other);
  const auto full = scene.Draw();
  const vtkIdType cells = Wait(scene);
  CHECK_GREATER(cells, 0);
  CHECK_LESS_EQUAL(cells, other->GetNumberOfCells());
  SetMoving(scene, true);
  CHECK_LESS(FindMean(full, scene.Draw()), 0.05);
}
}

int TestGPUUnstructuredGridVolumeMapperDetail(int, char*[])
{
  RelevoCheck check;
  TestMoving(check);
  TestCells(check);
  TestChanges(check);
  TestThread(check);
  return check.GetResult();
}
