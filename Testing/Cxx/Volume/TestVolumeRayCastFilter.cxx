// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises exact pictures of tetrahedra whose scalars are linear in space.
// Colour and extinction are then linear along the ray inside the mesh, and closed forms exist.
#include "RelevoCheck.h"
#include "RelevoVolumes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

namespace
{
void CheckCube(
  RelevoCheck& check, vtkCamera* camera, int width, int height, double low, double tolerance)
{
  const auto property = MakeLinearProperty();
  const auto picture =
    Cast(MakeTetrahedra(3, GetLinearField, low), property, camera, width, height);
  CHECK_EQUAL(picture.size(), static_cast<size_t>(width) * height);
  CHECK_NEAR(
    FindLargestDifference(picture, MakeLinearPicture(camera, width, height, low)), 0.0, tolerance);
}

void TestViews(RelevoCheck& check)
{
  // Cameras include oblique views, wide and tall pictures, rays within faces, views from inside,
  // and a position in a face of the mesh.
  CheckCube(check, MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } }), 40, 30, 0.0, 1e-12);
  CheckCube(check, MakeCamera({ { -2.0, 0.3, 0.1 } }, { { 0.5, 0.4, 0.6 } }), 15, 40, 0.0, 1e-12);
  CheckCube(check, MakeCamera({ { 0.5, 0.5, 4.0 } }, { { 0.5, 0.5, 0.5 } }), 31, 31, 0.0, 1e-12);
  CheckCube(
    check, MakeCamera({ { 0.4, 0.5, 0.6 } }, { { 3.0, 1.0, 0.0 } }, 80.0), 30, 30, 0.0, 1e-5);
  const auto parallel = MakeCamera({ { 0.5, 0.5, 4.0 } }, { { 0.5, 0.5, 0.5 } });
  parallel->ParallelProjectionOn();
  // Rays are 1/30 apart. Some run within faces, none within the border.
  parallel->SetParallelScale(29.0 / 60.0);
  CheckCube(check, parallel, 29, 29, 0.0, 1e-12);
  parallel->SetPosition(2.0, 1.0, 3.0);
  CheckCube(check, parallel, 33, 20, 0.0, 1e-12);
  // Far from the origin the picture is the same, up to the rounding of coordinates.
  const double far = 1e7;
  CheckCube(check,
    MakeCamera({ { far + 3.0, far + 2.0, far + 1.5 } }, { { far + 0.5, far + 0.5, far + 0.5 } }),
    40, 30, far, 1e-7);
}

// Nothing in front of the near plane or behind the far plane is visible.
void TestClippingRange(RelevoCheck& check)
{
  const auto camera = MakeCamera({ { 0.5, 0.5, 3.0 } }, { { 0.5, 0.5, 0.0 } });
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.4);
  camera->SetClippingRange(2.25, 2.75);
  const auto picture = Cast(MakeTetrahedra(2, [](const RelevoPoint&) { return 0.0; }),
    MakeVolumeProperty(0.6, 0.6), camera, 5, 5);
  for (const RelevoColor& color : picture)
  {
    CHECK_NEAR(color[3], 1.0 - std::exp(-0.6 * 0.5), 1e-12);
  }
}

// In a cube of 5^3 cells, the middle and one corner are removed in every way that VTK offers. Rays
// leave and enter again.
void TestHoles(RelevoCheck& check)
{
  const auto camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  const auto property = MakeVolumeProperty(0.7, 0.7);
  std::vector<RelevoColor> expected;
  for (int i = 0; i < 900; ++i)
  {
    const RelevoRay ray(camera, i % 30, i / 30, 30, 30);
    double inside = 0.0;
    double begin;
    double end;
    const auto add = [&](double low, double high, double sign)
    { inside += ray.CutBox(low, high, begin, end) ? sign * (end - begin) : 0.0; };
    add(0.0, 1.0, 1.0);
    add(0.4, 0.6, -1.0);
    add(0.8, 1.0, -1.0);
    const double alpha = 1.0 - std::exp(-0.7 * inside);
    expected.push_back({ { alpha, 0.0, 0.0, alpha } });
  }
  const auto whole = MakeTetrahedra(5, [](const RelevoPoint&) { return 0.0; });
  const auto isLeftOut = [](vtkIdType cell) { return cell / 6 == 62 || cell / 6 == 124; };
  for (int way = 0; way < 4; ++way)
  {
    vtkNew<vtkUnstructuredGrid> mesh;
    mesh->DeepCopy(whole);
    vtkNew<vtkDoubleArray> scalars;
    scalars->SetName("cells");
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    vtkNew<vtkUnstructuredGrid> less;
    less->SetPoints(whole->GetPoints());
    less->GetPointData()->ShallowCopy(whole->GetPointData());
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      scalars->InsertNextValue(isLeftOut(i) ? std::numeric_limits<double>::quiet_NaN() : 0.0);
      ghosts->InsertNextValue(!isLeftOut(i) ? 0
          : way == 0                        ? vtkDataSetAttributes::DUPLICATECELL
                                            : vtkDataSetAttributes::HIDDENCELL);
      whole->GetCellPoints(i, ids);
      if (!isLeftOut(i))
      {
        less->InsertNextCell(VTK_TETRA, ids);
      }
    }
    if (way < 2)
    {
      mesh->GetCellData()->AddArray(ghosts);
    }
    else if (way == 2)
    {
      mesh->GetPointData()->Initialize();
      mesh->GetCellData()->SetScalars(scalars);
    }
    const auto picture = Cast(way == 3 ? less.Get() : mesh.Get(), property, camera, 30, 30);
    CHECK_LESS(FindLargestDifference(picture, expected), 1e-12);
  }
}

// A point without a finite scalar and a blanked point remove their cells.
void TestPoints(RelevoCheck& check)
{
  const auto camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  const auto property = MakeVolumeProperty(0.2, 1.0, 0.5);
  const auto whole = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkUnstructuredGrid> less;
  less->SetPoints(whole->GetPoints());
  less->GetPointData()->ShallowCopy(whole->GetPointData());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
  {
    whole->GetCellPoints(i, ids);
    if (ids->IsId(14) < 0)
    {
      less->InsertNextCell(VTK_TETRA, ids);
    }
  }
  const auto expected = Cast(less, property, camera, 30, 30);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(whole->GetNumberOfPoints());
  ghosts->Fill(0);
  ghosts->SetValue(14, vtkDataSetAttributes::HIDDENPOINT);
  vtkNew<vtkUnstructuredGrid> blanked;
  blanked->ShallowCopy(whole);
  blanked->GetPointData()->AddArray(ghosts);
  CHECK_LESS(FindLargestDifference(Cast(blanked, property, camera, 30, 30), expected), 1e-13);
  CHECK_GREATER(FindLargestDifference(Cast(whole, property, camera, 30, 30), expected), 0.05);
  whole->GetPointData()->GetScalars()->SetComponent(
    14, 0, std::numeric_limits<double>::quiet_NaN());
  CHECK_LESS(FindLargestDifference(Cast(whole, property, camera, 30, 30), expected), 1e-13);
}

// Blocks without shared points form one mesh in every order, and so does a block with duplicate
// cells.
void TestBlocks(RelevoCheck& check)
{
  const auto camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  const auto property = MakeVolumeProperty(0.2, 1.0, 0.5);
  const auto whole = MakeTetrahedra(3, GetLinearField);
  const auto expected = Cast(whole, property, camera, 30, 30);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkIdList> ids;
  for (int block = 0; block < 3; ++block)
  {
    vtkNew<vtkUnstructuredGrid> part;
    part->SetPoints(whole->GetPoints());
    part->GetPointData()->ShallowCopy(whole->GetPointData());
    for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
    {
      if ((i * 7) % 3 == block)
      {
        whole->GetCellPoints(i, ids);
        part->InsertNextCell(VTK_TETRA, ids);
      }
    }
    blocks->SetBlock(3 - block, part);
  }
  CHECK_LESS(FindLargestDifference(Cast(blocks, property, camera, 30, 30), expected), 1e-13);
  blocks->SetBlock(0, whole);
  CHECK_LESS(FindLargestDifference(Cast(blocks, property, camera, 30, 30), expected), 1e-12);
}

// Cell scalars are constant in each cell and selected by name.
void TestCellScalars(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(2, [](const RelevoPoint&) { return 0.3; });
  vtkNew<vtkDoubleArray> layers;
  layers->SetName("layer");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    layers->InsertNextValue(i / 6 / 4);
  }
  mesh->GetCellData()->AddArray(layers);
  const auto camera = MakeCamera({ { 0.5, 0.5, 3.0 } }, { { 0.5, 0.5, 0.0 } });
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.4);
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetCamera(camera);
  filter->SetVolumeProperty(MakeVolumeProperty(0.4, 1.5));
  filter->SetViewportSize(4, 4);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "layer");
  const double front = 1.0 - std::exp(-0.5 * 1.5); // blue in front of red
  const double back = 1.0 - std::exp(-0.5 * 0.4);
  for (const RelevoColor& color : Cast(filter))
  {
    CHECK_NEAR(color[0], (1.0 - front) * back, 1e-12);
    CHECK_NEAR(color[2], front, 1e-12);
    CHECK_NEAR(color[3], front + (1.0 - front) * back, 1e-12);
  }
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "field");
  CHECK_NEAR(Cast(filter)[5][3], 1.0 - std::exp(-0.4 - 0.3 * 1.1), 1e-12);
}

// The filter executes again only after changes.
void TestChanges(RelevoCheck& check)
{
  const auto camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  const auto property = MakeVolumeProperty(0.2, 1.0, 0.5);
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(MakeTetrahedra(2, GetLinearField));
  filter->SetCamera(camera);
  filter->SetVolumeProperty(property);
  filter->SetViewportSize(20, 20);
  const auto first = Cast(filter);
  property->SetScalarOpacityUnitDistance(1.0);
  const auto second = Cast(filter);
  CHECK_GREATER(FindLargestDifference(first, second), 0.1);
  camera->Azimuth(30.0);
  CHECK_GREATER(FindLargestDifference(Cast(filter), second), 0.1);
  filter->SetViewportSize(10, 20);
  CHECK_EQUAL(Cast(filter).size(), 200);
}
}

int TestVolumeRayCastFilter(int, char*[])
{
  RelevoCheck check;
  TestViews(check);
  TestClippingRange(check);
  TestHoles(check);
  TestPoints(check);
  TestBlocks(check);
  TestCellScalars(check);
  TestChanges(check);
  return check.GetResult();
}
