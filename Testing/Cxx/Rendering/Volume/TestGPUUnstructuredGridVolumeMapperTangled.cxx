// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Curved cells that are hard or wrong: rational and inside-out cells are drawn as the filter draws
// them; tangled and flat ones are reported once by both; pieces of a mixed mesh have no cracks.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
constexpr int Width = 40;
constexpr int Height = 30;

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  return MakeVolumeProperty(0.2, 1.0, 0.3);
}

void CheckPictures(RelevoCheck& check, vtkUnstructuredGrid* mesh)
{
  RelevoVolumeScene scene(mesh, MakeProperty(), Width, Height);
  const auto drawn = scene.Draw();
  CHECK_LESS(CompareInside(drawn, scene.Cast(), Width, 0.005), 1.5);
  const double most = (*std::max_element(drawn.begin(), drawn.end()))[0];
  CHECK_GREATER(most, 0.1);
}

// A quarter of a pipe, from radius 0.5 to 1, as a Bézier hexahedron of degrees 1, 2 and 1. The
// field is the x coordinate, which any rational basis reproduces.
vtkSmartPointer<vtkUnstructuredGrid> MakePipe()
{
  const int order[4] = { 1, 2, 1, 12 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(12);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  weights->SetNumberOfTuples(12);
  vtkNew<vtkDoubleArray> field;
  field->SetNumberOfTuples(12);
  const double arc[3][2] = { { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  for (int i = 0; i < 12; ++i)
  {
    const int steps[3] = { i % 2, i / 2 % 3, i / 6 };
    const int id = vtkHigherOrderHexahedron::PointIndexFromIJK(steps[0], steps[1], steps[2], order);
    const double radius = 0.5 + 0.5 * steps[0];
    points->SetPoint(id, radius * arc[steps[1]][0], radius * arc[steps[1]][1], steps[2]);
    weights->SetValue(id, steps[1] == 1 ? std::sqrt(0.5) : 1.0);
    field->SetValue(id, radius * arc[steps[1]][0]);
  }
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->SetPoints(points);
  const vtkIdType ids[12] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 };
  mesh->InsertNextCell(VTK_BEZIER_HEXAHEDRON, 12, ids);
  mesh->GetPointData()->SetScalars(field);
  mesh->GetPointData()->SetRationalWeights(weights);
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(1, 2, 1);
  mesh->GetCellData()->SetHigherOrderDegrees(degrees);
  return mesh;
}

void TestRational(RelevoCheck& check)
{
  const auto mesh = MakePipe();
  CheckPictures(check, mesh);
  // Along the axis, scalar and length are known.
  const auto camera = MakeCamera({ { 0.5, 0.5, 5.0 } }, { { 0.5, 0.5, 0.0 } });
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5);
  const int size = 20;
  const auto picture = Cast(mesh, MakeProperty(), camera, size, size);
  for (int i = 0; i < size * size; ++i)
  {
    const double x = (i % size + 0.5) / size;
    const double y = (i / size + 0.5) / size;
    const double radius = std::hypot(x, y);
    const bool isInside = radius > 0.5 && radius < 1.0;
    const double opacity = isInside ? 1.0 - std::exp(-(0.2 + 0.8 * x) / 0.3) : 0.0;
    CHECK_NEAR(picture[static_cast<size_t>(i)][3], opacity, 1e-6);
  }
}

void TestInsideOut(RelevoCheck& check)
{
  const auto mesh = RelevoCurvedCells(2).Make(VTK_TRIQUADRATIC_HEXAHEDRON, 1);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double at[3];
    mesh->GetPoint(i, at);
    mesh->GetPoints()->SetPoint(i, 1.0 - at[0], at[1], at[2]);
  }
  CheckPictures(check, mesh);
}

// The messages of mapper and filter.
void CheckWarning(RelevoCheck& check, vtkUnstructuredGrid* mesh, const std::string& text)
{
  RelevoVolumeScene scene(mesh, MakeProperty(), Width, Height);
  RelevoErrors drawn(scene.GetMapper());
  scene.Draw();
  CHECK(drawn.Warned(text));
  scene.Draw();
  CHECK(drawn.None());
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetVolumeProperty(MakeProperty());
  filter->SetCamera(scene.GetCamera());
  filter->SetViewportSize(4, 3);
  RelevoErrors cast(filter);
  filter->Update();
  CHECK(cast.Warned(text));
}

void TestTangled(RelevoCheck& check)
{
  auto mesh = RelevoCurvedCells(2).Make(VTK_TRIQUADRATIC_HEXAHEDRON, 1);
  mesh->GetPoints()->SetPoint(26, 3.0, 0.5, 0.5); // the centre
  CheckWarning(check, mesh, "1 of 1 cell is tangled");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double at[3];
    mesh->GetPoint(i, at);
    mesh->GetPoints()->SetPoint(i, at[0], at[1], 0.0);
  }
  CheckWarning(check, mesh, "1 of 1 cell has no volume");
}

// A few linear pieces of a valid cell are tangled. Rays do not stop in them.
void TestTangledPieces(RelevoCheck& check)
{
  const RelevoCurvedCells cells(8, true);
  const auto mesh = cells.Make(VTK_LAGRANGE_TETRAHEDRON, 1);
  RelevoVolumeScene scene(mesh, MakeProperty(), Width, Height);
  scene.GetMapper()->SetShapeTolerance(1.0);
  scene.GetMapper()->SetFieldTolerance(1.0);
  const auto expected = cells.MakePicture(scene.GetCamera(), Width, Height, 0.2, 1.0, 0.3);
  CHECK_LESS(CompareInside(scene.Draw(), expected, Width), 12.0);
}

// The curved types that vtkCellTypeSource makes are drawn in full.
void TestTypes(RelevoCheck& check)
{
  for (int type :
    { VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID,
      VTK_TRIQUADRATIC_PYRAMID, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE,
      VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE, VTK_BEZIER_TETRAHEDRON })
  {
    CHECK_CASE(type);
    vtkNew<vtkCellTypeSource> source;
    source->SetCellType(type);
    source->SetCellOrder(3);
    source->SetBlocksDimensions(1, 1, 1);
    source->Update();
    vtkUnstructuredGrid* mesh = source->GetOutput();
    vtkNew<vtkDoubleArray> field;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double at[3];
      mesh->GetPoint(i, at);
      field->InsertNextValue(GetLinearField({ { at[0], at[1], at[2] } }));
    }
    mesh->GetPointData()->SetScalars(field);
    RelevoVolumeScene scene(mesh, MakeLinearProperty(), Width, Height);
    RelevoErrors errors(scene.GetMapper());
    const auto drawn = scene.Draw();
    CHECK(errors.None());
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
    const auto expected = MakeLinearPicture(scene.GetCamera(), Width, Height);
    CHECK_LESS(CompareInside(drawn, expected, Width), 1.0);
    CHECK_LESS(CompareInside(scene.Cast(), expected, Width), 1e-3);
  }
}
}

int TestGPUUnstructuredGridVolumeMapperTangled(int, char*[])
{
  RelevoCheck check;
  TestRational(check);
  TestInsideOut(check);
  TestTangled(check);
  TestTangledPieces(check);
  TestTypes(check);
  return check.GetResult();
}
