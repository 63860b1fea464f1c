// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that new values on the same points and cells do not build the mesh again, and give the
// picture of a new mapper.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoRefinedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
constexpr int Width = 60;
constexpr int Height = 48;

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  return MakeVolumeProperty(0.0, 1.0, 0.5);
}

// A copy with other values between 0 and `high`, and no shared object, as from a reader.
vtkSmartPointer<vtkDataSet> MakeStep(
  vtkDataSet* mesh, int step, bool areOfCells = false, double high = 1.0, int components = 1)
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(mesh->NewInstance());
  copy->DeepCopy(mesh);
  vtkDataSetAttributes* attributes =
    areOfCells ? static_cast<vtkDataSetAttributes*>(copy->GetCellData()) : copy->GetPointData();
  copy->GetPointData()->SetScalars(nullptr);
  copy->GetCellData()->SetScalars(nullptr);
  vtkNew<vtkDoubleArray> values;
  values->SetName("step");
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(areOfCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints());
  RelevoDice dice(step);
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, high * dice.Share());
  }
  attributes->SetScalars(values);
  return copy;
}

// Return whether the mapper has built the mesh for this input. The picture must be that of a new
// mapper.
bool IsBuilt(RelevoCheck& check, RelevoVolumeScene& scene, vtkDataObject* input)
{
  const vtkIdType uploads = scene.GetMapper()->GetNumberOfBufferBuilds();
  const vtkIdType ofValues = scene.GetMapper()->GetNumberOfValueUploads();
  scene.GetMapper()->SetInputDataObject(input);
  const std::vector<RelevoColor> drawn = scene.Draw();
  RelevoVolumeScene other(input, scene.GetVolume()->GetProperty(), Width, Height);
  other.GetCamera()->DeepCopy(scene.GetCamera());
  CHECK_EQUAL(FindLargestDifference(drawn, other.Draw()), 0.0);
  CHECK_EQUAL(
    scene.GetMapper()->GetNumberOfDrawnCells(), other.GetMapper()->GetNumberOfDrawnCells());
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), uploads + 1);
  CHECK_EQUAL(other.GetMapper()->GetNumberOfValueUploads(), 0);
  return scene.GetMapper()->GetNumberOfValueUploads() == ofValues;
}

void TestSteps(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 5);
  const std::vector<vtkSmartPointer<vtkDataSet>> meshes = {
    MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves), MakeTetrahedra(3, GetLinearField),
    MakeBlocksOfCells(VTK_PENTAGONAL_PRISM, GetWaves), image.Get()
  };
  for (vtkDataSet* mesh : meshes)
  {
    CHECK_CASE(mesh->GetClassName());
    for (const bool areOfCells : { false, true })
    {
      for (int components : { 1, 3 })
      {
        CHECK_CASE(components);
        const auto property = MakeBusyProperty(0.5, components);
        RelevoVolumeScene scene(
          MakeStep(mesh, 1, areOfCells, 1.0, components), property, Width, Height);
        scene.Draw();
        for (int step = 2; step < 4; ++step)
        {
          // The range differs too.
          CHECK(!IsBuilt(check, scene, MakeStep(mesh, step, areOfCells, 0.3 * step, components)));
        }
      }
    }
  }
}

void TestInPlace(RelevoCheck& check)
{
  const auto mesh = MakeStep(MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves), 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  blocks->SetBlock(1, MakeStep(MakeTetrahedra(2, GetLinearField, 4.0), 2));
  RelevoVolumeScene scene(blocks, MakeProperty(), Width, Height);
  scene.Draw();
  mesh->GetPointData()->GetScalars()->SetComponent(5, 0, 0.1);
  mesh->GetPointData()->GetScalars()->Modified();
  CHECK(!IsBuilt(check, scene, blocks));
  // The other association
  blocks->SetBlock(0, MakeStep(mesh, 3, true));
  blocks->SetBlock(1, MakeStep(MakeTetrahedra(2, GetLinearField, 4.0), 2, true));
  CHECK(IsBuilt(check, scene, blocks));
}

// Whatever changes the mesh builds it.
void TestOtherMeshes(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves);
  RelevoVolumeScene scene(MakeStep(mesh, 1), MakeProperty(), Width, Height);
  scene.Draw();
  CHECK(!IsBuilt(check, scene, MakeStep(mesh, 2)));

  auto moved = MakeStep(mesh, 3);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(moved);
  grid->GetPoints()->SetPoint(21, 1.3, 1.4, 1.2);
  CHECK(IsBuilt(check, scene, moved));

  auto hidden = MakeStep(mesh, 3);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(hidden->GetNumberOfCells());
  ghosts->FillComponent(0, 0.0);
  ghosts->SetValue(4, vtkDataSetAttributes::HIDDENCELL);
  hidden->GetCellData()->AddArray(ghosts);
  CHECK(IsBuilt(check, scene, hidden));
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 3)));

  // The same points, with cells in another order.
  vtkNew<vtkUnstructuredGrid> turned;
  turned->DeepCopy(MakeStep(mesh, 3));
  vtkNew<vtkIdList> ids;
  turned->GetCellPoints(2, ids);
  vtkNew<vtkUnstructuredGrid> part;
  part->SetPoints(turned->GetPoints());
  part->InsertNextCell(VTK_HEXAHEDRON, ids);
  part->GetPointData()->ShallowCopy(turned->GetPointData());
  CHECK(IsBuilt(check, scene, part));
}

// Values that are not finite leave cells out, which the next values need again.
void TestNaN(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves);
  RelevoVolumeScene scene(MakeStep(mesh, 1), MakeProperty(), Width, Height);
  scene.Draw();
  const auto bad = MakeStep(mesh, 2);
  bad->GetPointData()->GetScalars()->SetComponent(21, 0, std::numeric_limits<double>::quiet_NaN());
  CHECK(IsBuilt(check, scene, bad));
  CHECK_LESS_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells() - 1);
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 3)));
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
  CHECK(!IsBuilt(check, scene, MakeStep(mesh, 4)));
}

// Coincident points are one point as long as their values are equal.
void TestCoincidentPoints(RelevoCheck& check)
{
  const auto mesh = MakeDiscontinuous(MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves), 0.0);
  RelevoVolumeScene scene(mesh, MakeProperty(), Width, Height);
  scene.Draw();
  vtkNew<vtkUnstructuredGrid> half;
  half->DeepCopy(mesh);
  vtkDataArray* values = half->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 0.5 * values->GetComponent(i, 0));
  }
  CHECK(!IsBuilt(check, scene, half));
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 2)));
  // Now they are different points, whatever their values.
  CHECK(!IsBuilt(check, scene, MakeStep(mesh, 3)));
}

// Return a step whose points are moved along x by up to `bend`.
vtkSmartPointer<vtkDataSet> MakeMoved(vtkUnstructuredGrid* mesh, int step, double bend)
{
  const auto moved = MakeStep(mesh, step);
  vtkPoints* points = vtkUnstructuredGrid::SafeDownCast(moved)->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    points->SetPoint(i, point[0] + bend * point[1] * point[1], 1.2 * point[1], point[2]);
  }
  return moved;
}

// Moved points keep the neighbours, unless they separate or join cells.
void TestMovedPoints(RelevoCheck& check)
{
  for (const int type : { VTK_TETRA, VTK_WEDGE })
  {
    CHECK_CASE(type);
    const auto mesh = MakeBlocksOfCells(type, GetWaves);
    RelevoVolumeScene scene(MakeStep(mesh, 1), MakeProperty(), Width, Height);
    scene.Draw();
    CHECK(IsBuilt(check, scene, MakeMoved(mesh, 2, 0.1)));
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfNeighborSearches(), 1);
    const auto apart = MakeDiscontinuous(mesh, 0.0);
    for (vtkIdType i = 0; i < 4; ++i)
    {
      double point[3];
      apart->GetPoint(i, point);
      apart->GetPoints()->SetPoint(i, point[0] - 1.0, point[1], point[2]);
    }
    CHECK(IsBuilt(check, scene, apart));
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfNeighborSearches(), 2);
  }
}

// Hanging points depend on positions.
void TestHangingPoints(RelevoCheck& check)
{
  RelevoRefinedCells cells;
  cells.Levels = 1;
  cells.Field = GetWaves;
  const auto mesh = cells.Make(VTK_HEXAHEDRON);
  RelevoVolumeScene scene(MakeMoved(mesh, 1, 0.5), MakeProperty(), Width, Height);
  scene.Draw();
  for (const double bend : { 0.0, 0.5 })
  {
    CHECK(IsBuilt(check, scene, MakeMoved(mesh, 2, bend)));
  }
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfNeighborSearches(), 3);
}

// New values for cell projection keep the mesh too, but not those of the other method.
void TestProjection(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves);
  RelevoVolumeScene scene(MakeStep(mesh, 1), MakeProperty(), Width, Height);
  scene.Draw();
  RelevoVolumeScene::SetMethod(vtkGPUUnstructuredGridVolumeMapper::CELL_PROJECTION);
  scene.GetMapper()->SetMethodToCellProjection();
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 2)));
  CHECK(!IsBuilt(check, scene, MakeStep(mesh, 3)));
  RelevoVolumeScene::SetMethod(vtkGPUUnstructuredGridVolumeMapper::RAY_CASTING);
  scene.GetMapper()->SetMethodToRayCasting();
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 4)));
  CHECK(!IsBuilt(check, scene, MakeStep(mesh, 5)));
}

// Without host data, new values build the mesh.
void TestHostData(RelevoCheck& check)
{
  const auto mesh = MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves);
  RelevoVolumeScene scene(MakeStep(mesh, 1), MakeProperty(), Width, Height);
  scene.GetMapper()->KeepHostDataOff();
  scene.Draw();
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 2)));
  scene.GetMapper()->KeepHostDataOn();
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 3)));
  CHECK(!IsBuilt(check, scene, MakeStep(mesh, 4)));
  scene.GetMapper()->KeepHostDataOff();
  CHECK(IsBuilt(check, scene, MakeStep(mesh, 5)));
}

// Gradients are those of the new values, also if points at one place have equal values again.
void TestShading(RelevoCheck& check)
{
  const auto property = MakeProperty();
  const auto tetrahedra = MakeBlocksOfCells(VTK_TETRA, GetWaves);
  const auto apart = MakeDiscontinuous(MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves), 0.3);
  RelevoVolumeScene scene(MakeStep(tetrahedra, 1), property, Width, Height);
  scene.Draw();
  property->ShadeOn();
  CHECK(IsBuilt(check, scene, MakeStep(tetrahedra, 2)));
  CHECK(!IsBuilt(check, scene, MakeStep(tetrahedra, 3)));
  CHECK(IsBuilt(check, scene, apart));
  CHECK(
    !IsBuilt(check, scene, MakeDiscontinuous(MakeBlocksOfCells(VTK_HEXAHEDRON, GetWaves), 0.0)));
  property->ShadeOff();
  CHECK(!IsBuilt(check, scene, MakeStep(apart, 4)));
  property->ShadeOn();
  CHECK(!IsBuilt(check, scene, MakeStep(apart, 5)));
}
}

int TestGPUUnstructuredGridVolumeMapperValues(int, char*[])
{
  RelevoCheck check;
  TestSteps(check);
  TestInPlace(check);
  TestOtherMeshes(check);
  TestNaN(check);
  TestCoincidentPoints(check);
  TestMovedPoints(check);
  TestHangingPoints(check);
  TestProjection(check);
  TestHostData(check);
  TestShading(check);
  return check.GetResult();
}
