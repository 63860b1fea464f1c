// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on cells: cells of every kind, drawn directly or split, equal
// vtkVolumeRayCastFilter, which uses VTK's shape functions.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumeScene.h"

#include "vtkAMRBox.h"
#include "vtkAMRUtilities.h"
#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkOverlappingAMR.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStructuredData.h"
#include "vtkUniformGrid.h"
#include "vtkVersionMacros.h"

#include <cmath>
#include <vector>

namespace
{
double GetWaves(const RelevoPoint& at)
{
  return 0.5 + 0.25 * std::sin(2.5 * at[0]) + 0.25 * std::cos(1.7 * at[1] + at[2]);
}

// Blocks of cells of one kind whose points are moved by up to `distortion`.
vtkSmartPointer<vtkUnstructuredGrid> MakeCells(int type, double distortion, double x = 0.0)
{
  return MakeBlocksOfCells(type, GetWaves, distortion, x);
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  return MakeVolumeProperty(0.0, 1.0, 0.5);
}

void TestKinds(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_TETRA, VTK_QUADRATIC_TETRA,
         VTK_PENTAGONAL_PRISM, VTK_QUADRATIC_HEXAHEDRON })
  {
    CHECK_CASE(type);
    const auto mesh = MakeCells(type, 0.0);
    RelevoVolumeScene scene(mesh, MakeProperty(), 100, 80);
    const std::vector<RelevoColor> drawn = scene.Draw();
    const std::vector<RelevoColor> cast = scene.Cast();
    CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast), 3.0);
    CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(drawn, cast, 0.01), 1.0);
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
    scene.GetCamera()->ParallelProjectionOn();
    scene.GetCamera()->Azimuth(130.0);
    scene.GetRenderer()->ResetCameraClippingRange();
    CHECK_LESS_EQUAL(scene.Compare(), 3.0);
  }
}

// Faces that are not plane.
void TestDistortedKinds(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    CHECK_CASE(type);
    RelevoVolumeScene scene(MakeCells(type, 0.12), MakeProperty());
    CHECK_LESS_EQUAL(scene.Compare(), 3.0);
  }
  // A ray that only touches a curved face is treated as if it missed it.
  RelevoVolumeScene scene(MakeCells(VTK_QUADRATIC_TETRA, 0.03), MakeProperty());
  CHECK_LESS_EQUAL(scene.Compare(0.01), 3.0);
}

// Images are meshes of voxels.
void TestVoxels(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 6);
  image->SetSpacing(0.5, 0.7, 0.4);
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    image->GetPoint(i, at.data());
    values->InsertNextValue(GetWaves(at));
  }
  image->GetPointData()->SetScalars(values);
  RelevoVolumeScene scene(image, MakeProperty(), 100, 80);
  CHECK_LESS_EQUAL(scene.Compare(), 3.0);
}

// The camera is inside the mesh.
void TestInside(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeCells(VTK_HEXAHEDRON, 0.1), MakeProperty());
  vtkCamera* camera = scene.GetCamera();
  camera->SetPosition(1.4, 1.6, 1.3);
  camera->SetFocalPoint(3.0, 2.0, 2.2);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(0.01, 10.0);
  CHECK_LESS_EQUAL(scene.Compare(), 3.0);
}

// A mesh of several kinds: rays pass between curved cells and tetrahedra.
void TestMixed(RelevoCheck& check)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(MakeCells(VTK_TETRA, 0.0));
  append->AddInputData(MakeCells(VTK_WEDGE, 0.0, 3.0));
  append->AddInputData(MakeCells(VTK_HEXAHEDRON, 0.0, 6.0));
  append->AddInputData(MakeCells(VTK_PYRAMID, 0.0, 9.0));
  append->MergePointsOn();
  append->Update();
  RelevoVolumeScene scene(append->GetOutput(), MakeProperty());
  CHECK_LESS_EQUAL(scene.Compare(), 3.0);
  scene.GetCamera()->SetPosition(20.0, 2.1, 1.2);
  scene.GetRenderer()->ResetCamera();
  CHECK_LESS_EQUAL(scene.Compare(), 3.0);
  scene.GetCamera()->Azimuth(180.0);
  scene.GetRenderer()->ResetCameraClippingRange();
  CHECK_LESS_EQUAL(scene.Compare(), 3.0);
}

// Inverted cells give the same picture.
void TestMirrored(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_QUADRATIC_TETRA })
  {
    CHECK_CASE(type);
    const auto mesh = MakeCells(type, 0.0);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double x[3];
      mesh->GetPoint(i, x);
      mesh->GetPoints()->SetPoint(i, -x[0], x[1], x[2]);
    }
    RelevoVolumeScene scene(mesh, MakeProperty(), 100, 80);
    CHECK_LESS_EQUAL(scene.Compare(), 3.0);
  }
}

void TestCellData(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_TETRA, VTK_QUADRATIC_TETRA })
  {
    CHECK_CASE(type);
    const auto mesh = MakeCells(type, 0.0);
    mesh->GetPointData()->Initialize();
    vtkNew<vtkDoubleArray> values;
    RelevoDice dice(9);
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      values->InsertNextValue(dice.Share());
    }
    mesh->GetCellData()->SetScalars(values);
    RelevoVolumeScene scene(mesh, MakeProperty(), 100, 80);
    CHECK_LESS_EQUAL(scene.Compare(0.001), 1.0);
  }
}

// Gradients and isosurfaces in each kind of cell.
void TestFeatures(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_QUADRATIC_TETRA })
  {
    const auto property = MakeProperty();
    RelevoVolumeScene scene(MakeCells(type, 0.0), property, 60, 48);
    vtkNew<vtkPiecewiseFunction> gradientOpacity;
    gradientOpacity->AddPoint(0.1, 0.0);
    gradientOpacity->AddPoint(0.6, 1.0);
    property->SetGradientOpacity(gradientOpacity);
    // Near the apex of a pyramid, results may differ.
    CHECK_NEAR(scene.Compare(0.02), 0.0, 6.0);
    property->SetDisableGradientOpacity(1);
    property->ShadeOn();
    property->SetAmbient(0.2);
    property->SetDiffuse(0.8);
    property->SetSpecular(0.4);
    CHECK_NEAR(scene.Compare(0.01), 0.0, 3.0);
    property->GetIsoSurfaceValues()->SetNumberOfContours(2);
    property->GetIsoSurfaceValues()->SetValue(0, 0.4);
    property->GetIsoSurfaceValues()->SetValue(1, 0.7);
    scene.GetMapper()->IsoSurfacesOn();
    CHECK_NEAR(scene.Compare(0.01, [](vtkVolumeRayCastFilter* filter) { filter->IsoSurfacesOn(); }),
      0.0, 3.0);
    scene.GetMapper()->IsoSurfacesOff();
    for (int mode = 1; mode <= 5; ++mode)
    {
      scene.GetMapper()->SetBlendMode(mode);
      CHECK_NEAR(
        scene.Compare(0.01, [=](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(mode); }),
        0.0, 3.0);
    }
  }
}

// The finer of two levels covers eight cells of the coarser one.
void TestAMR(RelevoCheck& check)
{
  vtkNew<vtkOverlappingAMR> amr;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  const int description = vtkStructuredData::VTK_STRUCTURED_XYZ_GRID;
  amr->Initialize({ 1, 1 });
#else
  const int description = VTK_XYZ_GRID;
  const int numberOfBlocks[2] = { 1, 1 };
  amr->Initialize(2, numberOfBlocks);
#endif
  double origin[3] = { 0.0, 0.0, 0.0 };
  amr->SetOrigin(origin);
  for (unsigned int level = 0; level < 2; ++level)
  {
    const double size = level == 0 ? 1.0 : 0.5;
    double low[3] = { 1.0 * level, 1.0 * level, 1.0 * level };
    double spacing[3] = { size, size, size };
    vtkNew<vtkUniformGrid> grid;
    grid->SetOrigin(low);
    grid->SetSpacing(spacing);
    grid->SetDimensions(5, 5, 5);
    vtkNew<vtkDoubleArray> values;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      values->InsertNextValue(0.2 + 0.01 * static_cast<double>(i % 7) + 0.5 * level);
    }
    grid->GetCellData()->SetScalars(values);
    amr->SetGridDescription(description);
    amr->SetSpacing(level, spacing);
    amr->SetAMRBox(level, 0, vtkAMRBox(low, grid->GetDimensions(), spacing, origin, description));
    amr->SetRefinementRatio(level, 2);
    amr->SetDataSet(level, 0, grid);
  }
  amr->GenerateParentChildInformation();
  vtkAMRUtilities::BlankCells(amr);
  RelevoVolumeScene scene(amr, MakeProperty(), 60, 48);
  CHECK_LESS_EQUAL(scene.Compare(0.01), 1.0);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), 64 - 8 + 64);
}
}

int TestGPUUnstructuredGridVolumeMapperCells(int, char*[])
{
  RelevoCheck check;
  TestKinds(check);
  TestDistortedKinds(check);
  TestVoxels(check);
  TestInside(check);
  TestMixed(check);
  TestMirrored(check);
  TestCellData(check);
  TestFeatures(check);
  TestAMR(check);
  return check.GetResult();
}
