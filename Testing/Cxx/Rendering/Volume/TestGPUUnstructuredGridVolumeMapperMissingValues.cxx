// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: cells with fill values, or with values that are not finite, are transparent.
// The mapper and the filter report them once, with their number, the array and the blocks.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkContourValues.h"
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
  const bool isOne = some == 1;
  return ": " + std::to_string(some) + " of " + std::to_string(all) +
    (isOne ? " cells has" : " cells have") + " values of the array \"" + array +
    "\" that are not finite" + blocks +
    (isOne ? "; it is transparent." : "; they are transparent.");
}

// Mapper and filter report the mesh once, and draw it as the mesh without the cells.
void CheckMesh(
  RelevoCheck& check, vtkUnstructuredGrid* mesh, vtkIdList* cells, const std::string& message)
{
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
    const auto checkMesh = [&](vtkUnstructuredGrid* bad, const std::string& array)
    {
      CheckMesh(
        check, bad, cells, GetMessage(cells->GetNumberOfIds(), bad->GetNumberOfCells(), array));
    };
    for (double value : { NaN, Infinity, -Infinity })
    {
      CHECK_CASE(value);
      const Grid ofPoints = CopyMesh(mesh);
      ofPoints->GetPointData()->GetScalars()->SetComponent(point, 0, value);
      checkMesh(ofPoints, name);
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
    checkMesh(mesh, "stress");
  }
}

// The other cells are drawn as precisely as without fill values.
void TestFillValues(RelevoCheck& check)
{
  const Grid mesh = MakeMesh(VTK_HEXAHEDRON);
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  mesh->BuildLinks();
  vtkNew<vtkIdList> cells;
  const vtkIdType point = mesh->GetCell(0)->GetPointId(6);
  mesh->GetPointCells(point, cells);
  const std::string some =
    std::to_string(cells->GetNumberOfIds()) + " of " + std::to_string(mesh->GetNumberOfCells());
  const auto getMessage = [&](const std::string& fill)
  {
    return ": " + some + " cells have values of the array \"" + values->GetName() +
      "\" that are fill values (" + fill + ") or not finite; they are transparent.";
  };
  for (double value : { 1e30, -1e30, 9.96921e36 })
  {
    const Grid bad = CopyMesh(mesh);
    bad->GetPointData()->GetScalars()->SetComponent(point, 0, value);
    CheckMesh(check, bad, cells, getMessage(value > 1e31 ? "9.96921e+36" : "1e+30"));
  }
  const Grid two = CopyMesh(mesh);
  vtkDataArray* all = two->GetPointData()->GetScalars();
  all->SetComponent(point, 0, NaN);
  vtkNew<vtkIdList> corners;
  two->GetCellPoints(0, corners);
  all->SetComponent(corners->GetId(1), 0, 1e30);
  all->SetComponent(corners->GetId(2), 0, -1e37);
  RelevoVolumeScene scene(two, MakeProperty(), Width, Height);
  RelevoErrors errors(scene.GetMapper());
  scene.Draw();
  CHECK(errors.Warned("that are fill values (1e+30, 1e+37) or not finite; they are transparent."));
  // Large values of a field are no fill values.
  const Grid large = CopyMesh(mesh);
  for (vtkIdType i = 0; i < large->GetNumberOfPoints(); ++i)
  {
    large->GetPointData()->GetScalars()->SetComponent(
      i, 0, i % 3 == 0 ? 0.0 : 1e18 * (1.0 + 1e5 * i));
  }
  scene.GetMapper()->SetInputData(large);
  scene.Draw();
  CHECK(errors.None());
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
}

// With isosurfaces, cells without a value do not get the averages of their neighbours.
void TestAverages(RelevoCheck& check)
{
  const Grid mesh = MakeMesh(VTK_HEXAHEDRON);
  vtkNew<vtkDoubleArray> values;
  values->SetName("stress");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(0.1 * static_cast<double>(i % 9));
  }
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->SetScalars(values);
  const std::string averaged =
    "Isosurfaces need point values, so the cell array \"stress\" is averaged at the points.";
  vtkNew<vtkIdList> cells;
  cells->InsertNextId(4);
  const Grid rest = LeaveOut(mesh, cells);
  RelevoVolumeScene scene(rest, MakeProperty(), Width, Height);
  scene.GetMapper()->IsoSurfacesOn();
  scene.GetVolume()->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 0.4);
  const auto expected = scene.Draw();
  for (double value : { NaN, 1e30 })
  {
    scene.GetMapper()->SetInputData(rest); // so that the message comes again
    scene.Draw();
    values->SetValue(4, value);
    values->Modified();
    const Grid bad = CopyMesh(mesh);
    scene.GetMapper()->SetInputData(bad);
    RelevoErrors errors(scene.GetMapper());
    CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(scene.Draw(), expected, 0.002), 1.0);
    CHECK(errors.Warned(
      averaged + " 1 cell has a fill value, or a value that is not finite; it is transparent."));
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), rest->GetNumberOfCells());
    scene.Draw();
    CHECK(errors.None());
    CHECK(bad->GetCellGhostArray() == nullptr);
    vtkNew<vtkVolumeRayCastFilter> filter;
    filter->SetInputData(bad);
    filter->SetVolumeProperty(scene.GetVolume()->GetProperty());
    filter->SetCamera(scene.GetCamera());
    filter->SetViewportSize(Width, Height);
    filter->IsoSurfacesOn();
    RelevoErrors cast(filter);
    const auto picture = Cast(filter);
    CHECK(cast.Warned("1 cell has a fill value, or a value that is not finite"));
    filter->SetInputData(rest);
    CHECK_LESS(FindLargestDifference(Cast(filter), picture), 1e-12);
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
  TestFillValues(check);
  TestAverages(check);
  TestChanges(check);
  TestBlocks(check);
  return check.GetResult();
}
