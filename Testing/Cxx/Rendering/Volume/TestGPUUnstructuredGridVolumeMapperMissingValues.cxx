// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: cells with values that are not finite are transparent. The mapper and the
// filter report them once, with their number, the array and the blocks.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <limits>
#include <string>

namespace
{
constexpr int Width = 40;
constexpr int Height = 30;
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  return MakeVolumeProperty(0.2, 1.0, 0.5);
}

Grid MakeMesh(int type)
{
  return type == VTK_TRIQUADRATIC_HEXAHEDRON ? RelevoCurvedCells(2).Make(type, 3)
                                             : MakeBlocksOfCells(type, GetLinearField);
}

Grid CopyMesh(vtkUnstructuredGrid* mesh)
{
  auto copy = Grid::New();
  copy->DeepCopy(mesh);
  return copy;
}

// The mesh without some of its cells.
Grid LeaveOut(vtkUnstructuredGrid* mesh, vtkIdList* cells)
{
  auto rest = Grid::New();
  rest->SetPoints(mesh->GetPoints());
  rest->GetPointData()->ShallowCopy(mesh->GetPointData());
  rest->GetCellData()->CopyAllocate(mesh->GetCellData());
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (cells->IsId(i) < 0)
    {
      mesh->GetCellPoints(i, points);
      const vtkIdType cell = rest->InsertNextCell(mesh->GetCellType(i), points);
      rest->GetCellData()->CopyData(mesh->GetCellData(), i, cell);
    }
  }
  return rest;
}

std::string GetMessage(
  vtkIdType some, vtkIdType all, const std::string& array, const std::string& blocks = "")
{
  return ": " + std::to_string(some) + " of " + std::to_string(all) +
    " cells have values of the array \"" + array + "\" that are not finite" + blocks +
    "; they are transparent.";
}

// Mapper and filter report the mesh once, and draw it as the mesh without the cells.
void CheckMesh(
  RelevoCheck& check, vtkUnstructuredGrid* mesh, vtkIdList* cells, const std::string& array)
{
  const std::string message = GetMessage(cells->GetNumberOfIds(), mesh->GetNumberOfCells(), array);
  const Grid rest = LeaveOut(mesh, cells);
  RelevoVolumeScene scene(rest, MakeProperty(), Width, Height);
  const auto expected = scene.Draw();
  scene.GetMapper()->SetInputData(mesh);
  RelevoErrors errors(scene.GetMapper());
  CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(scene.Draw(), expected, 0.002), 1.0);
  CHECK(errors.Warned(message));
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), rest->GetNumberOfCells());
  scene.Draw();
  scene.GetMapper()->SetMethodToCellProjection();
  scene.GetVolume()->GetProperty()->ShadeOn();
  scene.Draw();
  CHECK(errors.None());

  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetVolumeProperty(MakeProperty());
  filter->SetCamera(scene.GetCamera());
  filter->SetViewportSize(Width, Height);
  RelevoErrors cast(filter);
  const auto picture = Cast(filter);
  CHECK(cast.Warned(message));
  filter->SetInputData(rest);
  CHECK_LESS(FindLargestDifference(Cast(filter), picture), 1e-12);
  CHECK(cast.None());
}

void TestCells(RelevoCheck& check)
{
  for (int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_QUADRATIC_TETRA, VTK_HEXAGONAL_PRISM,
         VTK_TRIQUADRATIC_HEXAHEDRON })
  {
    CHECK_CASE(type);
    const Grid mesh = MakeMesh(type);
    const std::string name = mesh->GetPointData()->GetScalars()->GetName();
    mesh->BuildLinks();
    vtkNew<vtkIdList> cells;
    const vtkIdType point = mesh->GetCell(0)->GetPointId(0);
    mesh->GetPointCells(point, cells);
    CHECK_GREATER(cells->GetNumberOfIds(), 0);
    for (double value : { NaN, Infinity, -Infinity })
    {
      CHECK_CASE(value);
      const Grid ofPoints = CopyMesh(mesh);
      ofPoints->GetPointData()->GetScalars()->SetComponent(point, 0, value);
      CheckMesh(check, ofPoints, cells, name);
    }
    vtkNew<vtkDoubleArray> values;
    values->SetName("stress");
    values->SetNumberOfTuples(mesh->GetNumberOfCells());
    values->Fill(0.5);
    values->SetValue(4, NaN);
    mesh->GetPointData()->Initialize();
    mesh->GetCellData()->SetScalars(values);
    cells->Reset();
    cells->InsertNextId(4);
    CheckMesh(check, mesh, cells, "stress");
  }
}

// The message comes again if the cells are others, or the array.
void TestChanges(RelevoCheck& check)
{
  const Grid mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetLinearField);
  const std::string name = mesh->GetPointData()->GetScalars()->GetName();
  RelevoVolumeScene scene(mesh, MakeProperty(), Width, Height);
  RelevoErrors errors(scene.GetMapper());
  scene.Draw();
  CHECK(errors.None());
  for (const vtkIdType point : { 0, 21 })
  {
    const Grid bad = CopyMesh(mesh);
    bad->GetPointData()->GetScalars()->SetComponent(point, 0, NaN);
    vtkNew<vtkIdList> cells;
    bad->BuildLinks();
    bad->GetPointCells(point, cells);
    const std::string message = GetMessage(cells->GetNumberOfIds(), 27, name);
    scene.GetMapper()->SetInputData(bad);
    scene.Draw();
    CHECK(errors.Warned(message));
    scene.GetMapper()->SetInputData(mesh);
    scene.Draw();
    CHECK(errors.None());
    scene.GetMapper()->SetInputData(bad);
    scene.Draw();
    CHECK(errors.Warned(message));
  }
}

void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 8; ++i)
  {
    blocks->SetBlock(i, MakeTetrahedra(1, GetLinearField, 2.0 * i));
    blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), ("b" + std::to_string(i)).c_str());
  }
  const auto spoil = [&](unsigned int block)
  {
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(block));
    mesh->GetPointData()->GetScalars()->Fill(NaN);
    mesh->Modified();
  };
  RelevoVolumeScene scene(blocks, MakeProperty(), Width, Height);
  RelevoErrors errors(scene.GetMapper());
  scene.Draw();
  CHECK(errors.None());
  spoil(1);
  spoil(3);
  scene.Draw();
  CHECK(errors.Warned(GetMessage(12, 48, "field", ", in Block 2 (\"b1\"), Block 4 (\"b3\")")));
  auto* far = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(5));
  far->GetPoints()->SetPoint(0, NaN, 0.0, 0.0); // a corner of all cells
  far->GetPoints()->Modified();
  scene.Draw();
  CHECK(errors.Warned("cells have no volume, or points that are not finite, in Block 6 (\"b5\"); "
                      "they are left out."));
  for (unsigned int i = 0; i < 7; ++i)
  {
    spoil(i);
  }
  scene.Draw();
  CHECK(errors.Warned("Block 5 (\"b4\") and 1 more block; they are transparent."));
  spoil(7);
  scene.Draw();
  CHECK(errors.Warned("Block 5 (\"b4\") and 2 more blocks; they are transparent."));
}
}

int TestGPUUnstructuredGridVolumeMapperMissingValues(int, char*[])
{
  RelevoCheck check;
  TestCells(check);
  TestChanges(check);
  TestBlocks(check);
  return check.GetResult();
}
