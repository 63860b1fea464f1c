// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises an error that names the cause and an empty output for input that
// it cannot draw, and one warning for cells that it skips.
#include "RelevoCheck.h"
#include "RelevoVolumes.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
struct Scene
{
  vtkSmartPointer<vtkUnstructuredGrid> Mesh =
    MakeTetrahedra(1, [](const RelevoPoint& p) { return p[0]; });
  vtkSmartPointer<vtkVolumeProperty> Property = MakeVolumeProperty(0.5, 1.0);
  vtkNew<vtkVolumeRayCastFilter> Filter;

  Scene()
  {
    this->Filter->SetInputData(this->Mesh);
    this->Filter->SetVolumeProperty(this->Property);
    this->Filter->SetCamera(MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } }));
    this->Filter->SetViewportSize(10, 10);
  }
  bool Fails(const std::string& words)
  {
    RelevoErrors errors(this->Filter);
    RelevoErrors executiveErrors(this->Filter->GetExecutive());
    this->Filter->Modified();
    this->Filter->Update();
    return errors.Said(words) && this->Filter->GetOutput()->GetNumberOfPoints() == 0;
  }
  // Draws the rest with an error.
  bool DrawsRest(const std::string& words)
  {
    RelevoErrors errors(this->Filter);
    const std::vector<RelevoColor> picture = Cast(this->Filter);
    return errors.Said(words) && picture.size() == 100 &&
      std::any_of(picture.begin(), picture.end(), [](const RelevoColor& c) { return c[3] > 0.01; });
  }
  // Draws with one warning, or with none if the text is empty.
  bool Draws(const std::string& warning)
  {
    RelevoErrors errors(this->Filter);
    const std::vector<RelevoColor> picture = Cast(this->Filter);
    bool isFinite = picture.size() == 100;
    bool isSeen = false;
    for (const RelevoColor& color : picture)
    {
      isFinite = isFinite && std::isfinite(color[0]) && std::isfinite(color[3]);
      isSeen = isSeen || color[3] > 0.01;
    }
    return isFinite && isSeen && (warning.empty() ? errors.None() : errors.Warned(warning));
  }
};

// Invalid cells that once crashed or were ignored silently. Nothing remains to draw.
void TestCells(RelevoCheck& check)
{
  const auto fails = [](int type, int points, const std::string& words, double degree = 0.0)
  {
    Scene scene;
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(scene.Mesh->GetPoints());
    grid->GetPointData()->ShallowCopy(scene.Mesh->GetPointData());
    std::vector<vtkIdType> ids(points);
    for (int i = 0; i < points; ++i)
    {
      ids[i] = i % 8;
    }
    grid->InsertNextCell(type, points, ids.data());
    if (degree != 0.0)
    {
      vtkNew<vtkDoubleArray> degrees;
      degrees->SetNumberOfComponents(3);
      degrees->InsertNextTuple3(degree, degree, degree);
      grid->GetCellData()->SetHigherOrderDegrees(degrees);
    }
    scene.Filter->SetInputData(grid);
    return scene.Fails(words);
  };
  CHECK(fails(VTK_LAGRANGE_TETRAHEDRON, 5, "a cell of this type cannot have 5 nodes."));
  CHECK(fails(VTK_LAGRANGE_HEXAHEDRON, 63, "a cell of this type cannot have 63 nodes."));
  CHECK(fails(VTK_TRIQUADRATIC_HEXAHEDRON, 0, "a cell of this type cannot have 0 nodes."));
  CHECK(fails(VTK_TRIQUADRATIC_PYRAMID, 13, "a cell of this type cannot have 13 nodes."));
  CHECK(fails(VTK_QUADRATIC_WEDGE, 6, "a cell of this type cannot have 6 nodes."));
  CHECK(fails(VTK_LAGRANGE_PYRAMID, 5, "cells of this type are not supported."));
  for (double degree : { -1.0, 9.0, 1e6, 1.5, std::numeric_limits<double>::quiet_NaN() })
  {
    CHECK_CASE(degree);
    CHECK(
      fails(VTK_BEZIER_HEXAHEDRON, 8, ", but degrees must be whole numbers from 1 to 8.", degree));
    CHECK(fails(VTK_LAGRANGE_TETRAHEDRON, 4, "but its 4 nodes need degree 1.", degree));
  }
}

void TestMissing(RelevoCheck& check)
{
  Scene scene;
  CHECK(scene.Draws(""));
  scene.Filter->SetCamera(nullptr);
  CHECK(scene.Fails("call SetCamera()"));
  Scene second;
  second.Filter->SetVolumeProperty(nullptr);
  CHECK(second.Fails("call SetVolumeProperty()"));
  Scene third;
  third.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "heat");
  CHECK(third.Fails("has no array \"heat\""));
  third.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "field");
  CHECK(third.Draws(""));
  third.Mesh->GetPointData()->Initialize();
  CHECK(third.Fails("has no array \"field\""));
  Scene fourth;
  fourth.Mesh->GetPointData()->Initialize();
  CHECK(fourth.Fails("has no active scalars"));
}

void TestArrays(RelevoCheck& check)
{
  Scene scene;
  vtkDataArray* scalars = scene.Mesh->GetPointData()->GetScalars();
  scalars->SetNumberOfTuples(5);
  CHECK(scene.Fails("\"field\" with 5 tuples, but there are 8 points"));
  vtkNew<vtkDoubleArray> five;
  five->SetName("five");
  five->SetNumberOfComponents(5);
  five->SetNumberOfTuples(8);
  five->Fill(0.5);
  scene.Mesh->GetPointData()->SetScalars(five);
  CHECK(scene.Fails("\"five\" with 5 components, but the limit is 4"));
  vtkNew<vtkDoubleArray> three;
  three->SetName("five");
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(8);
  three->Fill(0.5);
  scene.Mesh->GetPointData()->SetScalars(three);
  CHECK(scene.Draws(""));
  scene.Property->IndependentComponentsOff();
  CHECK(scene.Fails("2 or 4, but the array has 3"));
  scene.Property->IndependentComponentsOn();
  scene.Property->GetScalarOpacity(2)->RemoveAllPoints();
  CHECK(scene.Fails("scalar opacity function without nodes for component 2"));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, scene.Mesh);
  blocks->SetBlock(1, MakeTetrahedra(1, [](const RelevoPoint&) { return 0.0; }));
  scene.Filter->SetInputDataObject(blocks);
  CHECK(scene.Fails("in Block 2 with 1 components, but with 3 in Block 1"));
}

// Cells with invalid point ids are skipped with an error, and the rest is drawn.
void TestBroken(RelevoCheck& check)
{
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(8), vtkIdType(1) << 40 })
  {
    CHECK_CASE(id);
    Scene scene;
    const vtkIdType ids[4] = { 0, 1, 2, id };
    scene.Mesh->InsertNextCell(VTK_TETRA, 4, ids);
    const std::string words = "Cell 6 (vtkTetra, type 10) is left out: it refers to point " +
      std::to_string(id) + ", but there are 8 points.";
    CHECK(scene.DrawsRest(words));
    const vtkIdType flat[3] = { 0, 1, id };
    scene.Mesh->InsertNextCell(VTK_TRIANGLE, 3, flat);
    scene.Mesh->Modified();
    CHECK(scene.DrawsRest("1 more cell has the same fault."));
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(2, scene.Mesh);
    blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "left wing");
    scene.Filter->SetInputDataObject(blocks);
    CHECK(scene.DrawsRest("Block 3 (\"left wing\"): Cell 6 (vtkTetra"));
  }
  for (const vtkIdType id : { 3, 9 })
  {
    CHECK_CASE(id);
    Scene scene;
    const vtkIdType ids[4] = { 0, 1, 2, 3 };
    const vtkIdType faces[] = { 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, id };
    scene.Mesh->InsertNextCell(VTK_POLYHEDRON, 4, ids, 4, faces);
    CHECK(id == 9 ? scene.DrawsRest("it refers to point 9, but there are 8 points.")
                  : !scene.Fails("left out"));
  }
}

// A surface and a block without the array do not affect a solid block beside them.
void TestBlocks(RelevoCheck& check)
{
  Scene scene;
  const std::vector<RelevoColor> alone = Cast(scene.Filter);
  const auto blocks = MakeBlocksToLeaveOut(scene.Mesh);
  scene.Filter->SetInputDataObject(blocks);
  scene.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "field");
  CHECK(scene.Draws(
    "Block 1 (\"skin\") has no 3D cells; it is left out. Block 3 (\"air\") has no array "
    "\"field\"; it is left out."));
  CHECK_LESS(FindLargestDifference(Cast(scene.Filter), alone), 1e-12);
  // The array is point data in one block and cell data in another.
  auto* air = vtkDataSet::SafeDownCast(blocks->GetBlock(2));
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("field");
  ofCells->SetNumberOfTuples(air->GetNumberOfCells());
  ofCells->Fill(1.0);
  air->GetCellData()->AddArray(ofCells);
  scene.Filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, "field");
  CHECK(scene.Draws("Block 3 (\"air\") has no point array \"field\", but a cell array of that "
                    "name; it is left out."));
  CHECK_LESS(FindLargestDifference(Cast(scene.Filter), alone), 1e-12);
  scene.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "heat");
  CHECK(scene.Fails("has no array \"heat\"; select an array"));
  scene.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "heat");
  CHECK(scene.Fails("has no array \"heat\"; select an array"));
  ofCells->SetName("heat");
  scene.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "heat");
  CHECK(scene.Fails("The input has no point array \"heat\", but a cell array of that name. Use "
                    "SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "
                    "\"heat\")."));
  blocks->RemoveBlock(2);
  blocks->RemoveBlock(1);
  CHECK(scene.Fails("has no 3D cells"));
}

// Functions with numbers that are not finite are an error.
void TestNotFinite(RelevoCheck& check)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity })
  {
    CHECK_CASE(bad);
    Scene opacity;
    double node[4] = { 0.5, bad, 0.5, 0.0 };
    opacity.Property->GetScalarOpacity()->AddPoint(0.5, 0.5);
    opacity.Property->GetScalarOpacity()->SetNodeValue(1, node);
    CHECK(opacity.Fails("scalar opacity function with a number that is not finite at node 1"));
    Scene color;
    double rgb[6] = { 1.0, 0.5, bad, 0.5, 0.5, 0.0 };
    color.Property->GetRGBTransferFunction()->SetNodeValue(1, rgb);
    CHECK(color.Fails("colour function with a number that is not finite at node 1"));
    Scene gradient;
    gradient.Property->GetGradientOpacity()->AddPoint(0.0, 1.0);
    gradient.Property->GetGradientOpacity()->AddPoint(0.5, 1.0);
    gradient.Property->GetGradientOpacity()->SetNodeValue(1, node);
    CHECK(gradient.Fails("gradient opacity function with a number that is not finite at node 1"));
  }
}

// Isosurface settings that cannot be used.
void TestSurfaces(RelevoCheck& check)
{
  Scene scene;
  scene.Filter->IsoSurfacesOn();
  scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.5);
  CHECK(scene.Draws(""));
  scene.Property->GetIsoSurfaceValues()->SetValue(1, 7.0);
  scene.Property->GetIsoSurfaceValues()->SetValue(2, std::numeric_limits<double>::quiet_NaN());
  CHECK(scene.Draws("There are no isosurfaces at 7, nan: the array's values range from 0 to 1."));
  scene.Filter->SetBlendModeToMaximumIntensity();
  CHECK(scene.Draws(""));
  scene.Filter->SetBlendModeToComposite();
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("cells");
  ofCells->SetNumberOfTuples(scene.Mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < ofCells->GetNumberOfTuples(); ++i)
  {
    ofCells->SetValue(i, 0.2 * static_cast<double>(i));
  }
  scene.Mesh->GetCellData()->AddArray(ofCells);
  scene.Property->GetIsoSurfaceValues()->SetNumberOfContours(1);
  scene.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells");
  CHECK(scene.Draws(
    "Isosurfaces need point values, so the cell array \"cells\" is averaged at the points."));
  scene.Filter->IsoSurfacesOff();
  CHECK(scene.Draws(""));
}

void TestMeshes(RelevoCheck& check)
{
  Scene flat;
  vtkNew<vtkUnstructuredGrid> triangle;
  triangle->SetPoints(flat.Mesh->GetPoints());
  triangle->GetPointData()->ShallowCopy(flat.Mesh->GetPointData());
  const vtkIdType ids[4] = { 0, 1, 2, 2 };
  triangle->InsertNextCell(VTK_TRIANGLE, 3, ids);
  flat.Filter->SetInputData(triangle);
  CHECK(flat.Fails("has no 3D cells"));

  Scene empty;
  vtkNew<vtkUnstructuredGrid> nothing;
  empty.Filter->SetInputData(nothing);
  RelevoErrors errors(empty.Filter);
  const auto picture = Cast(empty.Filter);
  CHECK(picture.size() == 100 && picture[50][3] == 0.0);
  CHECK(errors.None());

  Scene spoilt;
  spoilt.Mesh->InsertNextCell(VTK_TETRA, 4, ids);
  spoilt.Mesh->GetPoints()->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  spoilt.Mesh->GetPointData()->GetScalars()->InsertTuple1(8, 0.5);
  const vtkIdType nan[4] = { 0, 1, 2, 8 };
  spoilt.Mesh->InsertNextCell(VTK_TETRA, 4, nan);
  CHECK(spoilt.Draws("2 of 8 cells have no volume"));

  Scene unit;
  unit.Property->SetScalarOpacityUnitDistance(0.0);
  const auto expected = Cast(Scene().Filter);
  CHECK(unit.Draws("ScalarOpacityUnitDistance of 0"));
  CHECK_EQUAL(FindLargestDifference(Cast(unit.Filter), expected), 0.0);

  Scene size;
  RelevoErrors sizeErrors(size.Filter);
  size.Filter->SetViewportSize(0, 10);
  CHECK(sizeErrors.Said("ViewportSize must be at least 1 x 1"));
  CHECK_EQUAL(size.Filter->GetViewportSize()[0], 10);
  size.Filter->SetViewportSize(1, 1);
  CHECK(Cast(size.Filter).size() == 1 && Cast(size.Filter)[0][3] > 0.1);
}
}

int TestVolumeRayCastFilterErrors(int, char*[])
{
  RelevoCheck check;
  TestMissing(check);
  TestArrays(check);
  TestBroken(check);
  TestCells(check);
  TestBlocks(check);
  TestNotFinite(check);
  TestSurfaces(check);
  TestMeshes(check);
  return check.GetResult();
}
