// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md: both methods draw the same arrays and components as vtkVolumeRayCastFilter.
#include "RelevoBusyVolumes.h"
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeMapper.h"

#include <limits>

namespace
{
constexpr int Width = 100;
constexpr int Height = 80;
using Mapper = vtkGPUUnstructuredGridVolumeMapper;

void TestComponents(RelevoCheck& check)
{
  const auto mesh = MakeBall(200);
  for (int components = 1; components <= 4; ++components)
  {
    mesh->GetPointData()->SetScalars(MakeBusyArray(mesh, components));
    for (bool areIndependent : { true, false })
    {
      CHECK_CASE(areIndependent);
      if (!areIndependent && components == 3)
      {
        continue;
      }
      const auto property = MakeBusyProperty(0.3, components);
      property->SetIndependentComponents(areIndependent);
      RelevoVolumeScene scene(mesh, property, Width, Height);
      for (int mode = 0; mode < 6; ++mode)
      {
        scene.GetMapper()->SetBlendMode(mode);
        CHECK_NEAR(scene.Compare(mode == 5 ? 0.0005 : 0.0,
                     [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); }),
          0.0, 1.0);
      }
    }
  }
}

// A ray's colour changes from one component to the other where their extinctions cross, within one
// piece.
void TestMixture(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(1, [](const RelevoPoint&) { return 0.0; });
  vtkNew<vtkDoubleArray> both;
  both->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double z = mesh->GetPoint(i)[2];
    both->InsertNextTuple2(z, 1.0 - z);
  }
  mesh->GetPointData()->SetScalars(both);
  const auto property = MakeVolumeProperty(0.0, 0.3, 0.1);
  vtkNew<vtkColorTransferFunction> green;
  green->AddRGBPoint(0.0, 1.0, 1.0, 0.0);
  green->AddRGBPoint(1.0, 0.0, 1.0, 0.0);
  vtkNew<vtkPiecewiseFunction> rising;
  rising->AddPoint(0.0, 0.0);
  rising->AddPoint(1.0, 1.0);
  property->SetColor(1, green);
  property->SetScalarOpacity(1, rising);
  property->SetScalarOpacityUnitDistance(1, 0.1);
  RelevoVolumeScene scene(mesh, property, Width, Height);
  for (int mode : { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    CHECK_CASE(mode);
    scene.GetMapper()->SetBlendMode(mode);
    CHECK_NEAR(
      scene.Compare(0.0, [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); }), 0.0,
      1.0);
  }
}

// Bytes used as colours are scaled to [0, 1], other bytes are not.
void TestBytes(RelevoCheck& check)
{
  const auto mesh = MakeBall(200);
  const auto busy = MakeBusyArray(mesh, 4);
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double values[4];
    busy->GetTuple(i, values);
    bytes->InsertNextTuple4(
      255.0 * values[0], 255.0 * values[1], 255.0 * values[2], 255.0 * values[3]);
  }
  mesh->GetPointData()->SetScalars(bytes);
  const auto property = MakeBusyProperty(0.3, 4);
  property->IndependentComponentsOff();
  RelevoVolumeScene scene(mesh, property, Width, Height);
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  const auto colors = scene.Draw();
  property->IndependentComponentsOn();
  for (int c = 0; c < 4; ++c)
  {
    property->GetRGBTransferFunction(c)->AddRGBPoint(255.0, 0.5, 1.0, 0.2);
    property->GetScalarOpacity(c)->AddPoint(255.0, 0.7);
  }
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  property->IndependentComponentsOff();
  CHECK_EQUAL(FindLargestDifference(scene.Draw(), colors), 0.0);
}

void TestVectorModes(RelevoCheck& check)
{
  const auto mesh = MakeBall(200);
  mesh->GetPointData()->SetScalars(MakeBusyArray(mesh, 3));
  const auto property = MakeBusyProperty(0.3, 3);
  RelevoVolumeScene scene(mesh, property, Width, Height);
  const auto compare = [&](int mode, int component)
  {
    scene.GetMapper()->SetVectorMode(mode);
    scene.GetMapper()->SetVectorComponent(component);
    return scene.Compare(0.0,
      [=](vtkVolumeRayCastFilter* filter)
      {
        filter->SetVectorMode(mode);
        filter->SetVectorComponent(component);
      });
  };
  CHECK_NEAR(compare(Mapper::DISABLED, 0), 0.0, 1.0);
  CHECK_NEAR(compare(Mapper::MAGNITUDE, 0), 0.0, 1.0);
  CHECK_NEAR(compare(Mapper::COMPONENT, 0), 0.0, 1.0);
  CHECK_NEAR(compare(Mapper::COMPONENT, 2), 0.0, 1.0);
  const auto component = scene.Draw();
  property->GetRGBTransferFunction()->SetVectorModeToMagnitude();
  CHECK_NEAR(compare(Mapper::DISABLED, 2), 0.0, 1.0);
  CHECK_GREATER(FindLargestDifference(scene.Draw(), component), 0.1);
}

// All of VTK's ways to select an array.
void TestSelection(RelevoCheck& check)
{
  const auto mesh = MakeBall(200);
  const auto other = MakeBusyArray(mesh, 2);
  mesh->GetPointData()->AddArray(other);
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(mesh);
  toCells->Update();
  mesh->GetCellData()->ShallowCopy(vtkDataSet::SafeDownCast(toCells->GetOutput())->GetCellData());
  RelevoVolumeScene scene(mesh, MakeBusyProperty(0.3, 2), Width, Height);
  Mapper* mapper = scene.GetMapper();
  const auto compare = [&](int association, const char* name)
  {
    return scene.Compare(0.0,
      [=](vtkVolumeRayCastFilter* filter)
      { filter->SetInputArrayToProcess(0, 0, 0, association, name); });
  };
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  mapper->SetScalarModeToUseCellData();
  CHECK_NEAR(compare(cells, "waves"), 0.0, 1.0);
  mapper->SetScalarModeToUsePointData();
  CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("busy");
  CHECK_NEAR(compare(points, "busy"), 0.0, 1.0);
  mapper->SetScalarModeToUseCellFieldData();
  CHECK_NEAR(compare(cells, "busy"), 0.0, 1.0);
  for (int i = 0; i < mesh->GetCellData()->GetNumberOfArrays(); ++i)
  {
    mapper->SelectScalarArray(i);
    CHECK_NEAR(compare(cells, mesh->GetCellData()->GetArrayName(i)), 0.0, 1.0);
  }
}

// NaN scalars are invisible. A block without the array is skipped.
void TestMissingScalars(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto mesh = MakeTetrahedra(4, GetWaves, i == 0 ? 0.0 : 1.0);
    mesh->GetPointData()->GetScalars()->SetComponent(
      31 + i, 0, std::numeric_limits<double>::quiet_NaN());
    blocks->SetBlock(2 * i, mesh);
  }
  RelevoVolumeScene scene(blocks, MakeBusyProperty(0.3), Width, Height);
  scene.GetMapper()->SetScalarModeToUsePointFieldData();
  scene.GetMapper()->SelectScalarArray("field");
  CHECK_NEAR(scene.Compare(0.001), 0.0, 1.0);
  CHECK_LESS(scene.GetMapper()->GetNumberOfDrawnCells(), 2 * 6 * 64);
  vtkDataSet::SafeDownCast(blocks->GetBlock(2))->GetPointData()->GetArray(0)->SetName("other");
  blocks->Modified();
  RelevoErrors errors(scene.GetMapper());
  scene.Draw();
  CHECK(errors.Warned("Block 3 has no array \"field\"; it is left out."));
  const auto byName = [](vtkVolumeRayCastFilter* filter)
  { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "field"); };
  vtkObject::GlobalWarningDisplayOff(); // warnings of the filter
  CHECK_NEAR(scene.Compare(0.001, byName), 0.0, 1.0);
  vtkObject::GlobalWarningDisplayOn();
  CHECK_GREATER(scene.GetMapper()->GetNumberOfDrawnCells(), 0);
  CHECK_LESS(scene.GetMapper()->GetNumberOfDrawnCells(), 6 * 64);
}
}

int TestGPUUnstructuredGridVolumeMapperArrays(int, char*[])
{
  RelevoCheck check;
  RelevoVolumeScene::ForBothMethods(
    [&]
    {
      TestComponents(check);
      TestMixture(check);
      TestBytes(check);
      TestVectorModes(check);
      TestSelection(check);
      TestMissingScalars(check);
    });
  return check.GetResult();
}
