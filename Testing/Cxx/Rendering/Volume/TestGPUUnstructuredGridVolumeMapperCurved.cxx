// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on curved cells: from outside, along their axes and from inside, the picture
// equals vtkVolumeRayCastFilter. Rays pass a bulging face twice and reach the apex of pyramids.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkDoubleArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <cmath>
#include <utility>

namespace
{
// Share of pixels whose rays graze the apex of a distorted pyramid.
constexpr double Top = 0.001;

// Blocks of cells with random scalars, whose points are moved by up to `distortion`.
vtkSmartPointer<vtkUnstructuredGrid> MakeCells(
  int type, int blocks, double distortion, unsigned int seed, bool areOfCells = false)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(blocks, blocks, blocks);
  source->Update();
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->DeepCopy(source->GetOutput());
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  RelevoDice dice(seed);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    for (double& coordinate : at)
    {
      coordinate += distortion * dice.Signed();
    }
    points->InsertNextPoint(at.data());
  }
  mesh->SetPoints(points);
  vtkNew<vtkDoubleArray> values;
  const vtkIdType count = areOfCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->InsertNextValue(0.5 + 0.5 * dice.Signed());
  }
  areOfCells ? mesh->GetCellData()->SetScalars(values) : mesh->GetPointData()->SetScalars(values);
  return mesh;
}

// A quadratic tetrahedron whose edge midpoints are moved outwards by `bulge`.
vtkSmartPointer<vtkUnstructuredGrid> MakeBulging(double bulge)
{
  const double corners[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  for (const auto& edge : edges)
  {
    double at[3];
    double out[3];
    double size = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      at[c] = 0.5 * (corners[edge[0]][c] + corners[edge[1]][c]);
      out[c] = at[c] - 0.25;
      size += out[c] * out[c];
    }
    for (int c = 0; c < 3; ++c)
    {
      at[c] += bulge * out[c] / std::sqrt(size);
    }
    points->InsertNextPoint(at);
  }
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->SetPoints(points);
  const vtkIdType ids[10] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  mesh->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids);
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < 10; ++i)
  {
    values->InsertNextValue(0.1 * i);
  }
  mesh->GetPointData()->SetScalars(values);
  return mesh;
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  return MakeVolumeProperty(0.3, 1.0, 0.3);
}

// All pixels, from three sides.
void CheckAround(RelevoCheck& check, vtkUnstructuredGrid* mesh)
{
  RelevoVolumeScene scene(mesh, MakeProperty(), 72, 54);
  for (int i = 0; i < 3; ++i)
  {
    scene.GetCamera()->Azimuth(77.0);
    scene.GetRenderer()->ResetCamera();
    CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  }
}

void TestBulging(RelevoCheck& check)
{
  CheckAround(check, MakeBulging(0.05));
  CheckAround(check, MakeBulging(-0.05));
}

void TestBentFaces(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    CHECK_CASE(type);
    for (unsigned int seed = 1; seed <= 1; ++seed)
    {
      CheckAround(check, MakeCells(type, 1, 0.1, seed));
    }
  }
  CheckAround(check, MakeCells(VTK_QUADRATIC_TETRA, 2, 0.03, 1));
}

// A ray enters a mesh that is almost a cube only once.
void TestLayers(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_QUADRATIC_TETRA })
  {
    CHECK_CASE(type);
    RelevoVolumeScene scene(MakeCells(type, 1, 0.01, 2), MakeProperty(), 72, 54);
    scene.Draw();
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
  }
}

// Functions so steep that they need small steps along the ray.
vtkSmartPointer<vtkVolumeProperty> MakeSteepProperty()
{
  auto property = MakeProperty();
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  for (const auto& [value, height] : { std::make_pair(0.0, 0.0), std::make_pair(0.3, 0.0),
         std::make_pair(0.35, 0.9), std::make_pair(0.4, 0.0), std::make_pair(0.6, 0.0),
         std::make_pair(0.65, 1.0), std::make_pair(0.7, 0.0), std::make_pair(1.0, 0.2) })
  {
    opacity->AddPoint(value, height);
  }
  property->SetScalarOpacityUnitDistance(0.1);
  return property;
}

void TestSteepFunctions(RelevoCheck& check)
{
  for (const auto& [type, bend] :
    { std::make_pair(VTK_HEXAHEDRON, 0.0), std::make_pair(VTK_HEXAHEDRON, 0.15),
      std::make_pair(VTK_QUADRATIC_TETRA, 0.0), std::make_pair(VTK_QUADRATIC_TETRA, 0.03) })
  {
    const int blocks = type == VTK_HEXAHEDRON ? 2 : 1;
    RelevoVolumeScene scene(MakeCells(type, blocks, bend, 2), MakeSteepProperty(), 72, 54);
    CHECK_NEAR(scene.Compare(bend == 0.0 ? 0.0 : 0.005), 0.0, 1.0);
  }
}

// Along the axes, rays pass the apex of pyramids.
void TestAxes(RelevoCheck& check)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    RelevoVolumeScene scene(MakeCells(VTK_PYRAMID, 2, 0.0, 3), MakeProperty(), 72, 54);
    double position[3] = { 1.0, 1.0, 1.0 };
    position[axis] = 6.0;
    double up[3] = { 0.0, 0.0, 0.0 };
    up[(axis + 1) % 3] = 1.0;
    scene.GetCamera()->SetPosition(position);
    scene.GetCamera()->SetFocalPoint(1.0, 1.0, 1.0);
    scene.GetCamera()->SetViewUp(up);
    scene.GetCamera()->ParallelProjectionOn();
    scene.GetCamera()->SetParallelScale(1.1);
    scene.GetRenderer()->ResetCameraClippingRange();
    CHECK_NEAR(scene.Compare(), 0.0, 1.0);
  }
}

// The eye is in a cell and looks around.
void TestInside(RelevoCheck& check)
{
  for (int type : { VTK_HEXAHEDRON, VTK_PYRAMID, VTK_QUADRATIC_TETRA })
  {
    CHECK_CASE(type);
    for (bool areOfCells : { true, false })
    {
      CHECK_CASE(areOfCells);
      const double distortion = type == VTK_QUADRATIC_TETRA ? 0.03 : 0.12;
      RelevoVolumeScene scene(
        MakeCells(type, 2, distortion, 7, areOfCells), MakeProperty(), 80, 60);
      scene.GetCamera()->SetPosition(0.8, 1.1, 1.3);
      scene.GetCamera()->SetFocalPoint(2.0, 1.2, 1.0);
      scene.GetCamera()->SetViewAngle(60.0);
      for (int i = 0; i < 3; ++i)
      {
        scene.GetCamera()->Yaw(110.0);
        scene.GetRenderer()->ResetCameraClippingRange();
        CHECK_NEAR(scene.Compare(Top), 0.0, 1.0);
      }
    }
  }
}
}

int TestGPUUnstructuredGridVolumeMapperCurved(int, char*[])
{
  RelevoCheck check;
  TestBulging(check);
  TestBentFaces(check);
  TestLayers(check);
  TestSteepFunctions(check);
  TestAxes(check);
  TestInside(check);
  return check.GetResult();
}
