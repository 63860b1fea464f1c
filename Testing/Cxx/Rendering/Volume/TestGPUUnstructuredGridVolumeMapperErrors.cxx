// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that vtkGPUUnstructuredGridVolumeMapper reports invalid input once and draws the rest.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCellType.h"
#include "vtkContourFilter.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkTriangle.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace
{
bool IsBlack(const std::vector<RelevoColor>& picture)
{
  return FindLargestDifference(picture, std::vector<RelevoColor>(picture.size())) == 0.0;
}

void TestNothing(RelevoCheck& check)
{
  vtkNew<vtkUnstructuredGrid> none;
  RelevoVolumeScene scene(none, MakeLinearProperty());
  RelevoErrors errors(scene.GetMapper());
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.None());
  vtkNew<vtkTable> table;
  scene.GetMapper()->SetInputDataObject(table);
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("The input is a vtkTable; a vtkDataSet or a vtkCompositeDataSet is needed."));
  scene.Draw();
  CHECK(errors.None()); // reported once
}

void TestArrays(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  RelevoVolumeScene scene(mesh, MakeLinearProperty());
  RelevoErrors errors(scene.GetMapper());
  scene.GetMapper()->SetScalarModeToUsePointFieldData();
  scene.GetMapper()->SelectScalarArray("missing");
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("has no array \"missing\"; select an array with SelectScalarArray()"));
  scene.Draw();
  CHECK(errors.None()); // reported once
  scene.GetMapper()->SelectScalarArray("field");
  CHECK(!IsBlack(scene.Draw()));
  CHECK(errors.None());
  scene.GetMapper()->SetScalarModeToUseCellFieldData();
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("The input has no cell array \"field\", but a point array of that name. Use "
                    "SetScalarModeToUsePointFieldData()."));
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("stress");
  ofCells->SetNumberOfTuples(mesh->GetNumberOfCells());
  ofCells->Fill(0.5);
  mesh->GetCellData()->AddArray(ofCells);
  scene.GetMapper()->SetScalarModeToUsePointFieldData();
  scene.GetMapper()->SelectScalarArray("stress");
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("The input has no point array \"stress\", but a cell array of that name. Use "
                    "SetScalarModeToUseCellFieldData()."));
  scene.Draw();
  CHECK(errors.None());
  scene.GetMapper()->SelectScalarArray("field");
  scene.GetMapper()->SetVectorMode(1);
  scene.GetMapper()->SetVectorComponent(2);
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("VectorComponent is 2"));

  vtkNew<vtkDoubleArray> shorter;
  shorter->SetNumberOfTuples(3);
  shorter->SetName("short");
  mesh->GetPointData()->AddArray(shorter);
  scene.GetMapper()->SetVectorMode(-1);
  scene.GetMapper()->SelectScalarArray("short");
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("3 tuples, but there are 27 points"));
}

void TestCells(RelevoCheck& check)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  RelevoVolumeScene surface(sphere->GetOutput(), MakeLinearProperty());
  surface.GetMapper()->SetScalarModeToUsePointFieldData();
  surface.GetMapper()->SelectScalarArray("Normals");
  surface.GetMapper()->SetVectorMode(0);
  RelevoErrors surfaceErrors(surface.GetMapper());
  CHECK(IsBlack(surface.Draw()));
  CHECK(surfaceErrors.Said("has no 3D cells"));

  const auto mesh = MakeTetrahedra(3, GetLinearField);
  mesh->GetPoints()->SetPoint(21, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  RelevoVolumeScene scene(mesh, MakeLinearProperty());
  scene.GetCamera()->SetFocalPoint(0.5, 0.5, 0.5);
  scene.GetCamera()->SetPosition(3.0, 2.0, 2.5);
  scene.GetCamera()->SetClippingRange(1.0, 10.0);
  RelevoErrors errors(scene.GetMapper());
  CHECK(!IsBlack(scene.Draw()));
  CHECK(errors.Warned("have no volume, or points that are not finite"));
  CHECK_LESS(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
  // Reported once, even if the mesh is built again.
  scene.GetVolume()->GetProperty()->ShadeOn();
  scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), 2);
  CHECK(errors.None());
  vtkObject::GlobalWarningDisplayOff();
  CHECK_LESS_EQUAL(scene.Compare(0.001), 1.0);
  vtkObject::GlobalWarningDisplayOn();
}

// Two cells at the same place do not hide each other.
void TestDuplicates(RelevoCheck& check)
{
  for (int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_QUADRATIC_TETRA })
  {
    CHECK_CASE(type);
    const auto mesh = MakeBlocksOfCells(type, GetWaves);
    vtkNew<vtkUnstructuredGrid> doubled;
    doubled->DeepCopy(mesh);
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); cell += 3)
    {
      mesh->GetCellPoints(cell, corners);
      doubled->InsertNextCell(type, corners);
    }
    RelevoVolumeScene single(mesh, MakeVolumeProperty(0.0, 1.0, 0.5), 60, 48);
    RelevoVolumeScene scene(doubled, MakeVolumeProperty(0.0, 1.0, 0.5), 60, 48);
    RelevoErrors errors(scene.GetMapper());
    CHECK_LESS_EQUAL(RelevoVolumeScene::Compare(scene.Draw(), single.Draw(), 0.01), 2.0);
    CHECK(errors.Warned("have several cells on the same side"));
    scene.Draw();
    CHECK(errors.None());
  }
}

// Cells with too few nodes are skipped, with one error.
void TestNodes(RelevoCheck& check)
{
  for (const auto& [type, nodes] : { std::make_pair(int(VTK_LAGRANGE_HEXAHEDRON), 63),
         std::make_pair(int(VTK_TRIQUADRATIC_HEXAHEDRON), 0),
         std::make_pair(int(VTK_LAGRANGE_TETRAHEDRON), 5) })
  {
    const auto mesh = MakeTetrahedra(3, GetLinearField);
    const vtkIdType good = mesh->GetNumberOfCells();
    std::vector<vtkIdType> ids(64);
    std::iota(ids.begin(), ids.end(), 0);
    mesh->InsertNextCell(type, nodes, ids.data());
    RelevoVolumeScene scene(mesh, MakeLinearProperty());
    RelevoErrors errors(scene.GetMapper());
    CHECK(!IsBlack(scene.Draw()));
    CHECK(errors.Said("Cell " + std::to_string(good) + " (vtk"));
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), good);
    scene.GetMapper()->SetMethodToCellProjection();
    CHECK(!IsBlack(scene.Draw()));
    CHECK(errors.None());

    vtkNew<vtkUnstructuredGrid> alone;
    alone->SetPoints(mesh->GetPoints());
    alone->GetPointData()->ShallowCopy(mesh->GetPointData());
    alone->InsertNextCell(type, nodes, ids.data());
    scene.GetMapper()->SetInputData(alone);
    CHECK(IsBlack(scene.Draw()));
    CHECK(errors.Said("cannot have " + std::to_string(nodes) + " nodes."));
    scene.GetMapper()->SetInputData(MakeTetrahedra(2, GetLinearField));
    CHECK(!IsBlack(scene.Draw()));
    CHECK(errors.None());
  }
}

void TestProperty(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(2, GetLinearField), MakeLinearProperty());
  RelevoErrors errors(scene.GetMapper());
  scene.GetVolume()->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("without nodes"));
  scene.GetVolume()->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 1.0);
  scene.GetVolume()->GetProperty()->SetScalarOpacityUnitDistance(0.0);
  CHECK(!IsBlack(scene.Draw()));
  CHECK(errors.Warned("ScalarOpacityUnitDistance of 0"));
}

// Reported once, not in every frame. A volume with such a function is not drawn.
void TestNotFinite(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(2, GetLinearField), MakeLinearProperty());
  RelevoErrors errors(scene.GetMapper());
  vtkPiecewiseFunction* opacity = scene.GetVolume()->GetProperty()->GetScalarOpacity();
  double node[4] = { 1.0, std::numeric_limits<double>::quiet_NaN(), 0.5, 0.0 };
  opacity->SetNodeValue(1, node);
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("scalar opacity function with a number that is not finite at node 1"));
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.None());
  // Other changes, of the material or of the data and their range, do not draw it either.
  scene.GetVolume()->GetProperty()->SetSpecular(0.3);
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.None());
  scene.GetMapper()->SetInputData(
    MakeTetrahedra(2, [](const std::array<double, 3>& x) { return 5.0 * x[0]; }));
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.None());
  opacity->Modified();
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("not finite"));
  node[1] = 1.0;
  opacity->SetNodeValue(1, node);
  CHECK(!IsBlack(scene.Draw()));
  CHECK(errors.None());
}

void TestBlocks(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  const auto blocks = MakeBlocksToLeaveOut(mesh);
  RelevoVolumeScene scene(blocks, MakeLinearProperty());
  scene.GetMapper()->SetScalarModeToUsePointFieldData();
  scene.GetMapper()->SelectScalarArray("field");
  RelevoErrors errors(scene.GetMapper());
  const auto drawn = scene.Draw();
  CHECK(errors.Warned(
    "Block 1 (\"skin\") has no 3D cells; it is left out. Block 3 (\"air\") has no array "
    "\"field\"; it is left out."));
  scene.GetVolume()->GetProperty()->ShadeOn(); // builds the mesh again
  scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), 2);
  CHECK(errors.None());
  scene.GetVolume()->GetProperty()->ShadeOff();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
  scene.GetMapper()->SetInputDataObject(mesh);
  CHECK_LESS_EQUAL(FindLargestDifference(scene.Draw(), drawn), 1.0 / 255.0);

  vtkNew<vtkMultiBlockDataSet> others;
  vtkNew<vtkTable> table;
  others->SetBlock(0, table);
  others->SetBlock(1, mesh);
  scene.GetMapper()->SetInputDataObject(others);
  CHECK_LESS_EQUAL(FindLargestDifference(scene.Draw(), drawn), 1.0 / 255.0);
  CHECK(errors.Said("Block 1 is a vtkTable; a vtkDataSet is needed; it is left out."));
  scene.GetVolume()->GetProperty()->ShadeOn(); // builds the mesh again
  scene.Draw();
  CHECK(errors.None());
  others->SetBlock(1, table);
  CHECK(IsBlack(scene.Draw()));
  CHECK(errors.Said("Block 1 is a vtkTable; a vtkDataSet is needed; it is left out. Block 2"));
}

void TestSurfaces(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("cells");
  ofCells->SetNumberOfTuples(mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < ofCells->GetNumberOfTuples(); ++i)
  {
    ofCells->SetValue(i, 0.2 + 0.6 * static_cast<double>(i % 6) / 5.0);
  }
  mesh->GetCellData()->AddArray(ofCells);
  RelevoVolumeScene scene(mesh, MakeLinearProperty());
  RelevoErrors errors(scene.GetMapper());
  scene.GetMapper()->IsoSurfacesOn();
  vtkContourValues* values = scene.GetVolume()->GetProperty()->GetIsoSurfaceValues();
  values->SetValue(0, -2.0);
  scene.Draw();
  CHECK(errors.Warned("There is no isosurface at -2: the array's values range from 0 to 1."));
  scene.Draw();
  CHECK(errors.None());
  values->SetValue(0, 0.5);
  scene.Draw();
  CHECK(errors.None());
  scene.GetMapper()->SetScalarModeToUseCellFieldData();
  scene.GetMapper()->SelectScalarArray("cells");
  const auto drawn = scene.Draw();
  CHECK(errors.Warned(
    "Isosurfaces need point values, so the cell array \"cells\" is averaged at the points."));
  scene.Draw();
  CHECK(errors.None());
  // As with the array of vtkCellDataToPointData.
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(mesh);
  toPoints->Update();
  scene.GetMapper()->SetInputData(vtkDataSet::SafeDownCast(toPoints->GetOutput()));
  scene.GetMapper()->SetScalarModeToUsePointFieldData();
  CHECK_LESS_EQUAL(FindLargestDifference(scene.Draw(), drawn), 1.0 / 255.0);
  // Without isosurfaces, cells are constant again.
  scene.GetMapper()->SetInputData(mesh);
  scene.GetMapper()->SetScalarModeToUseCellFieldData();
  scene.GetMapper()->IsoSurfacesOff();
  const auto select = [](vtkVolumeRayCastFilter* filter)
  { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells"); };
  CHECK_LESS_EQUAL(scene.Compare(0.01, select), 1.0);
  CHECK(errors.None());
  CHECK_GREATER(FindLargestDifference(scene.Draw(), drawn), 10.0 / 255.0);
  scene.GetMapper()->IsoSurfacesOn();
  CHECK_LESS_EQUAL(FindLargestDifference(scene.Draw(), drawn), 1.0 / 255.0);
  CHECK(errors.Warned("is averaged at the points."));
}

// VTK 9.6 returns triangles without area where the surface is a point.
bool HasArea(vtkPolyData* surface)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType id = 0; id < surface->GetNumberOfCells(); ++id)
  {
    surface->GetCellPoints(id, points);
    double corners[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(points->GetId(i), corners[i]);
    }
    if (vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]) > 0.0)
    {
      return true;
    }
  }
  return false;
}

// At the ends of the range, isosurfaces have the area of vtkContourFilter's.
void TestExtremes(RelevoCheck& check)
{
  const auto alongX = [](const RelevoPoint& at) { return at[0]; };
  const auto diagonal = [](const RelevoPoint& at) { return at[0] + at[1] + at[2]; };
  for (const RelevoField& field : { RelevoField(alongX), RelevoField(diagonal) })
  {
    const auto mesh = MakeTetrahedra(2, field);
    double range[2];
    mesh->GetPointData()->GetScalars()->GetRange(range);
    RelevoVolumeScene scene(mesh, MakeLinearProperty());
    RelevoErrors errors(scene.GetMapper());
    scene.GetMapper()->SetBlendMode(5); // only isosurfaces
    vtkContourValues* values = scene.GetVolume()->GetProperty()->GetIsoSurfaceValues();
    for (const double share : { 0.0, 0.5, 1.0 })
    {
      CHECK_CASE(share);
      const double value = range[0] + share * (range[1] - range[0]);
      vtkNew<vtkContourFilter> contour;
      contour->SetInputData(mesh);
      contour->SetValue(0, value);
      contour->Update();
      values->SetValue(0, value);
      const std::vector<RelevoColor> drawn = scene.Draw();
      CHECK_EQUAL(IsBlack(drawn), !HasArea(contour->GetOutput()));
      CHECK_LESS_EQUAL(
        scene.Compare(0.01, [](vtkVolumeRayCastFilter* filter) { filter->SetBlendMode(5); }), 1.0);
      CHECK(share > 0.0 ||
        errors.Warned(
          "There is no isosurface at 0, the array's lowest value: no value is below it."));
      CHECK(share < 1.0 ||
        errors.Warned(
          "the array's highest value, consists only of faces whose points all have this value."));
      scene.Draw();
      CHECK(errors.None());
    }
  }
}

void TestWindows(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(2, GetLinearField), MakeLinearProperty(), 1, 1);
  RelevoErrors errors(scene.GetMapper());
  CHECK_LESS_EQUAL(scene.Compare(), 1.0);
  CHECK(errors.None());
}
}

int TestGPUUnstructuredGridVolumeMapperErrors(int, char*[])
{
  RelevoCheck check;
  TestNothing(check);
  TestArrays(check);
  TestCells(check);
  TestDuplicates(check);
  TestNodes(check);
  TestProperty(check);
  TestNotFinite(check);
  TestBlocks(check);
  TestSurfaces(check);
  TestExtremes(check);
  TestWindows(check);
  return check.GetResult();
}
