// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on pre-integration, compared with the exact integrals of
// vtkVolumeRayCastFilter.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointDataToCellData.h"

#include <cmath>

namespace
{
double GetField(const RelevoPoint& at)
{
  return 5.0 + 3.0 * std::sin(4.0 * at[0]) * std::cos(5.0 * at[1] + at[2]);
}

// Opaque enough that colours depend on which scalar is in front.
vtkSmartPointer<vtkVolumeProperty> MakeSmoothProperty()
{
  auto property = MakeVolumeProperty(0.0, 1.0, 0.3);
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetRGBTransferFunction()->AddRGBPoint(2.0, 1.0, 0.0, 0.2);
  property->GetRGBTransferFunction()->AddRGBPoint(5.0, 0.3, 1.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(8.0, 0.0, 0.2, 1.0);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(2.0, 0.0);
  property->GetScalarOpacity()->AddPoint(8.0, 1.0);
  return property;
}

void TestTables(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(5, GetField), MakeSmoothProperty());
  scene.GetMapper()->SetTableSize(64);
  const auto exact = scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfTableBuilds(), 0);
  scene.GetMapper()->SetIntegrationToPreIntegrated();
  CHECK_LESS_EQUAL(scene.Compare(0.01), 1.0);
  CHECK_GREATER(FindLargestDifference(exact, scene.Draw()), 0.0); // differs from exact integration
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfTableBuilds(), 1);
  scene.GetMapper()->SetIntegrationToPreIntegrated2D();
  CHECK_LESS_EQUAL(scene.Compare(0.01), 2.0);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfTableBuilds(), 2);
  // Materials do not change the functions.
  scene.GetVolume()->GetProperty()->SetSpecular(0.7);
  scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfTableBuilds(), 2);
  // The mesh has not been uploaded again.
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), 1);
}

// The 2D table is correct for one length only. With a constant colour, opacity is correct for all
// lengths.
void TestOneColor(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(2, GetField), MakeSmoothProperty());
  vtkColorTransferFunction* color = scene.GetVolume()->GetProperty()->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.0, 1.0, 0.5, 0.25);
  scene.GetMapper()->SetIntegrationToPreIntegrated2D();
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  // A table with few texels misses a narrow peak.
  vtkPiecewiseFunction* opacity = scene.GetVolume()->GetProperty()->GetScalarOpacity();
  opacity->AddPoint(5.0, 0.0);
  opacity->AddPoint(5.1, 20.0);
  opacity->AddPoint(5.2, 0.0);
  scene.GetMapper()->SetTableSize(8);
  CHECK_GREATER(scene.Compare(0.01), 10.0);
  scene.GetMapper()->SetTableSize(256);
  CHECK_LESS_EQUAL(scene.Compare(0.01), 3.0);
}

// A matrix makes an edge long, and parts are longer than any edge.
void TestLengths(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetField), MakeSmoothProperty());
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  mapper->SetIntegrationToPreIntegrated();
  mapper->SetTableSize(48);
  scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 1);
  scene.GetCamera()->Azimuth(20.0);
  scene.GetVolume()->RotateX(25.0);
  scene.GetVolume()->SetPosition(0.1, 0.0, 0.2);
  scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 1);
  scene.GetVolume()->SetScale(2.0);
  scene.GetRenderer()->ResetCamera();
  const auto table = scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 2);
  mapper->SetIntegrationToExact();
  CHECK_LESS_EQUAL(FindLargestDifference(table, scene.Draw()), 2.0 / 255.0);
}

void TestEdits(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetField), MakeSmoothProperty());
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  mapper->SetIntegrationToPreIntegrated();
  mapper->SetTableSize(32);
  const auto before = scene.Draw();
  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  const vtkTypeInt64 memory = mapper->GetGraphicsMemorySize();
  CHECK_GREATER(memory, 32 * 32 * 32 * 16);
  scene.GetVolume()->GetProperty()->GetScalarOpacity()->AddPoint(8.0, 0.2);
  const auto after = scene.Draw();
  CHECK_GREATER(FindLargestDifference(before, after), 0.05);
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 2);
  scene.Draw();
  CHECK_EQUAL(mapper->GetNumberOfTableBuilds(), 2);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), 1);
  CHECK_EQUAL(mapper->GetGraphicsMemorySize(), memory);
}

void TestLimits(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetField);
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    pairs->InsertNextTuple2(0.1 * i, 8.0 - 0.1 * i);
  }
  mesh->GetPointData()->SetScalars(pairs);
  RelevoVolumeScene scene(mesh, MakeSmoothProperty());
  RelevoErrors errors(scene.GetMapper());
  scene.GetVolume()->GetProperty()->IndependentComponentsOff();
  const auto exact = scene.Draw();
  scene.GetMapper()->SetIntegrationToPreIntegrated();
  CHECK_EQUAL(FindLargestDifference(exact, scene.Draw()), 0.0);
  CHECK(errors.Warned("Pre-integration supports only one component"));
  scene.Draw();
  CHECK(errors.None()); // reported once
  scene.GetMapper()->SetTableSize(1);
  CHECK(errors.Said("TableSize must be in [2, 256], got 1."));
  scene.GetMapper()->SetTableSize(257);
  CHECK(errors.Said("got 257."));
  CHECK_EQUAL(scene.GetMapper()->GetTableSize(), 128);
  scene.GetMapper()->SetIntegration(3);
  CHECK(errors.Said("Integration must be one of EXACT (0)"));
  CHECK_EQUAL(scene.GetMapper()->GetIntegration(), 1);
}

// These cells have one scalar each.
void TestCellScalars(RelevoCheck& check)
{
  vtkNew<vtkPointDataToCellData> toCells;
  toCells->SetInputData(MakeTetrahedra(4, GetField));
  toCells->Update();
  RelevoVolumeScene scene(toCells->GetOutput(), MakeSmoothProperty());
  scene.GetMapper()->SetTableSize(64);
  for (int integration : { 1, 2 })
  {
    CHECK_CASE(integration);
    scene.GetMapper()->SetIntegration(integration);
    CHECK_LESS_EQUAL(scene.Compare(0.01), 1.0);
  }
}
}

int TestGPUUnstructuredGridVolumeMapperIntegration(int, char*[])
{
  RelevoCheck check;
  TestTables(check);
  TestOneColor(check);
  TestLengths(check);
  TestEdits(check);
  TestLimits(check);
  TestCellScalars(check);
  return check.GetResult();
}
