// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMeshVisibilitySort promises traversal in both directions and in portions. Changes of the input
// take effect, and invalid cells do not affect the order of the others.
#include "RelevoCheck.h"
#include "RelevoVisibility.h"
#include "vtkMeshVisibilitySort.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using Mesh = vtkSmartPointer<vtkUnstructuredGrid>;

vtkSmartPointer<vtkCamera> MakeView()
{
  return MakeCamera({ { 3.0, 4.0, 5.0 } }, { { 0.5, 0.5, 0.5 } });
}

// Whether the order is correct along the rays of MakeView().
bool IsRight(vtkDataSet* mesh, const std::vector<vtkIdType>& order)
{
  RelevoDice dice(1);
  return IsEachOnce(mesh, order) &&
    RelevoConvexCells(mesh).Compare(order, { { 3.0, 4.0, 5.0, 1.0 } }, 200, dice).Wrong == 0;
}

// Rotates the cube so that ids are not in visibility order.
void Turn(vtkUnstructuredGrid* cube)
{
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double x[3];
    cube->GetPoint(i, x);
    cube->GetPoints()->SetPoint(i, 1.0 - x[2], x[1], x[0]);
  }
  cube->GetPoints()->Modified();
}

void TestTraversals(RelevoCheck& check)
{
  const Mesh mesh = MakeTetrahedra(3, GetLinearField);
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  sort->SetCamera(MakeView());
  CHECK_EQUAL(sort->GetNextCells(), nullptr);
  const std::vector<vtkIdType> order = Traverse(sort);
  CHECK(IsRight(mesh, order));
  CHECK_EQUAL(sort->GetNextCells(), nullptr);

  for (int most : { 1, 7, 162, 163 })
  {
    CHECK_CASE(most);
    sort->SetMaxCellsReturned(most);
    CHECK_EQUAL(Traverse(sort), order);
    sort->InitTraversal();
    CHECK_EQUAL(sort->GetNextCells()->GetNumberOfTuples(), std::min(most, 162));
  }
  sort->SetDirectionToFrontToBack();
  std::vector<vtkIdType> reversed = Traverse(sort);
  std::reverse(reversed.begin(), reversed.end());
  CHECK_EQUAL(reversed, order);
  sort->SetDirectionToBackToFront();

  std::ostringstream text;
  sort->Print(text);
  CHECK_NOT_EQUAL(text.str().find("NumberOfCycles: 0"), std::string::npos);
}

// Changes the input in place, replaces it, and changes the camera.
void TestChanges(RelevoCheck& check)
{
  const Mesh mesh = MakeTetrahedra(2, GetLinearField);
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  sort->SetCamera(MakeCamera({ { -9.0, -4.0, -5.0 } }, { { 0.5, 0.5, 0.5 } }));
  CHECK(!IsRight(mesh, Traverse(sort)));
  sort->SetCamera(MakeView());
  CHECK(IsRight(mesh, Traverse(sort)));
  Turn(mesh);
  CHECK(IsRight(mesh, Traverse(sort)));
  const Mesh other = MakeTetrahedra(3, GetLinearField);
  sort->SetInput(other);
  CHECK(IsRight(other, Traverse(sort)));
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkMeshVisibilitySort> sort;
  RelevoErrors errors(sort);
  CHECK(Traverse(sort).empty());
  CHECK(errors.Said("no input"));
  const Mesh mesh = MakeTetrahedra(1, GetLinearField);
  sort->SetInput(mesh);
  CHECK(Traverse(sort).empty());
  CHECK(errors.Said("no camera"));
  CHECK_EQUAL(sort->GetNumberOfCycles(), 0);
  sort->SetCamera(MakeView());
  CHECK_EQUAL(Traverse(sort).size(), 6);

  const vtkIdType missing[4] = { 0, 1, 2, 8 };
  mesh->InsertNextCell(VTK_TETRA, 4, missing);
  mesh->Modified();
  CHECK_EQUAL(Traverse(sort).size(), 6);
  CHECK(errors.Said(
    "Cell 6 (vtkTetra, type 10) is left out: it refers to point 8, but there are 8 points."));
  mesh->InsertNextCell(VTK_TETRA, 0, missing);
  mesh->InsertNextCell(VTK_TETRA, 2, missing);
  mesh->Modified();
  CHECK_EQUAL(Traverse(sort).size(), 6);
  CHECK(errors.Said("a cell of this type cannot have 0 nodes. 1 more cell has the same fault."));
  mesh->SetPoints(nullptr);
  CHECK(Traverse(sort).empty());
  CHECK(errors.Said("left out"));
}

void TestNoCells(RelevoCheck& check)
{
  vtkNew<vtkMeshVisibilitySort> sort;
  RelevoErrors errors(sort);
  sort->SetCamera(MakeView());
  auto mesh = Mesh::New();
  sort->SetInput(mesh);
  CHECK(Traverse(sort).empty());
  mesh->SetPoints(MakeTetrahedra(1, GetLinearField)->GetPoints());
  CHECK(Traverse(sort).empty());
  const vtkIdType ids[4] = { 0, 1, 2, 4 };
  mesh->InsertNextCell(VTK_TRIANGLE, 3, ids);
  mesh->Modified();
  CHECK(Traverse(sort).empty());
  mesh->InsertNextCell(VTK_TETRA, 4, ids);
  mesh->InsertNextCell(VTK_VERTEX, 1, ids);
  mesh->InsertNextCell(VTK_EMPTY_CELL, 0, ids);
  mesh->Modified();
  CHECK_EQUAL(Traverse(sort), std::vector<vtkIdType>({ 1 }));
  CHECK(errors.None());
}

// Cells without volume and with points that are not finite are included, and the others are in
// order.
void TestBadCells(RelevoCheck& check)
{
  const Mesh mesh = MakeTetrahedra(3, GetLinearField);
  Turn(mesh);
  auto good = Mesh::New();
  good->DeepCopy(mesh);
  const vtkIdType numberOfGood = mesh->GetNumberOfCells();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const vtkIdType bad = mesh->GetPoints()->InsertNextPoint(nan, 0.0, 0.0);
  mesh->GetPoints()->InsertNextPoint(infinity, -infinity, nan);
  mesh->GetPoints()->InsertNextPoint(1e300, 1e300, -1e300);
  const vtkIdType cells[][4] = { { 0, 1, 2, bad }, { 5, 6, 7, bad + 1 }, { 0, 1, 5, bad + 2 },
    { bad, bad, bad, bad }, { 3, 3, 3, 3 }, { 0, 1, 2, 3 } };
  for (const auto& cell : cells)
  {
    mesh->InsertNextCell(VTK_TETRA, 4, cell);
  }
  vtkNew<vtkMeshVisibilitySort> sort;
  RelevoErrors errors(sort);
  sort->SetInput(mesh);
  sort->SetCamera(MakeView());
  std::vector<vtkIdType> order = Traverse(sort);
  CHECK(IsEachOnce(mesh, order));
  order.erase(std::remove_if(
                order.begin(), order.end(), [=](vtkIdType cell) { return cell >= numberOfGood; }),
    order.end());
  CHECK(IsRight(good, order));

  // Cameras that cannot be used.
  const auto camera = MakeView();
  sort->SetCamera(camera);
  camera->SetPosition(nan, infinity, 1e300);
  CHECK(IsEachOnce(mesh, Traverse(sort)));
  camera->SetPosition(0.5, 0.5, 0.5);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  CHECK(IsEachOnce(mesh, Traverse(sort)));
  CHECK(errors.None());
}

// Tetrahedra with coincident points between others do not change the order of their neighbours.
void TestCollapsedCells(RelevoCheck& check)
{
  const Mesh cube = MakeTetrahedra(2, GetLinearField);
  auto mesh = Mesh::New();
  mesh->SetPoints(cube->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < cube->GetNumberOfCells(); ++i)
  {
    cube->GetCellPoints(i, ids);
    mesh->InsertNextCell(VTK_TETRA, ids);
  }
  const vtkIdType numberOfGood = mesh->GetNumberOfCells();
  for (vtkIdType i = 0; i < numberOfGood; ++i)
  {
    // Places a flat tetrahedron on each of its faces.
    cube->GetCellPoints(i, ids);
    for (vtkIdType corner = 0; corner < 4; ++corner)
    {
      vtkIdType flat[4];
      std::copy(ids->begin(), ids->end(), flat);
      flat[corner] = flat[(corner + 1) % 4];
      mesh->InsertNextCell(VTK_TETRA, 4, flat);
    }
  }
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  for (int view = 0; view < 20; ++view)
  {
    // The camera is close to one corner, so that distances of faces do not order the cells.
    const double x = 1.02 + 0.02 * view;
    sort->SetCamera(MakeCamera({ { x, x, 1.1 } }, { { 0.5, 0.5, 0.5 } }));
    std::vector<vtkIdType> order = Traverse(sort);
    CHECK(IsEachOnce(mesh, order));
    CHECK_EQUAL(sort->GetNumberOfCycles(), 0);
    order.erase(std::remove_if(
                  order.begin(), order.end(), [=](vtkIdType cell) { return cell >= numberOfGood; }),
      order.end());
    RelevoDice dice(1);
    const RelevoPairs pairs =
      RelevoConvexCells(cube).Compare(order, { { x, x, 1.1, 1.0 } }, 300, dice);
    CHECK_GREATER(pairs.All, 300);
    CHECK_EQUAL(pairs.Wrong, 0);
  }
}

// A pentagon that is split differently from below and from above. Two stacked flat tetrahedra lie
// between, whose orientation follows only from the order of their corners.
void TestFlatCells(RelevoCheck& check)
{
  const double fifth = 0.4 * std::acos(-1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(std::cos(i * fifth), std::sin(i * fifth), 0.0);
  }
  points->InsertNextPoint(0.0, 0.0, -0.1);
  points->InsertNextPoint(0.0, 0.0, 0.1);
  const std::vector<std::array<vtkIdType, 4>> cells = { { { 0, 2, 1, 5 } }, { { 0, 3, 2, 5 } },
    { { 0, 4, 3, 5 } }, { { 0, 1, 4, 6 } }, { { 1, 3, 4, 6 } }, { { 1, 2, 3, 6 } },
    // The flat cells lead from the diagonal 0 2 to 1 3, and from 0 3 to 1 4.
    { { 2, 0, 1, 3 } }, { { 3, 0, 1, 4 } } };
  for (bool isInsideOut : { false, true })
  {
    CHECK_CASE(isInsideOut);
    auto mesh = Mesh::New();
    auto solid = Mesh::New();
    mesh->SetPoints(points);
    solid->SetPoints(points);
    for (size_t i = 0; i < cells.size(); ++i)
    {
      std::array<vtkIdType, 4> ids = cells[i];
      if (isInsideOut)
      {
        std::swap(ids[0], ids[1]);
      }
      mesh->InsertNextCell(VTK_TETRA, 4, ids.data());
      if (i < 6)
      {
        solid->InsertNextCell(VTK_TETRA, 4, ids.data());
      }
    }
    RelevoDice dice(1);
    const RelevoConvexCells convex(solid);
    vtkNew<vtkMeshVisibilitySort> sort;
    sort->SetInput(mesh);
    for (int view = 0; view < 40; ++view)
    {
      const std::array<double, 4> eye = { { 2.0 * dice.Signed(), 2.0 * dice.Signed(),
        view % 2 ? 0.3 : -0.3, 1.0 } };
      sort->SetCamera(MakeCamera({ { eye[0], eye[1], eye[2] } }, { { 0.0, 0.0, 0.0 } }));
      std::vector<vtkIdType> order = Traverse(sort);
      CHECK(IsEachOnce(mesh, order));
      CHECK_EQUAL(sort->GetNumberOfCycles(), 0);
      order.erase(
        std::remove_if(order.begin(), order.end(), [](vtkIdType cell) { return cell > 5; }),
        order.end());
      const RelevoPairs pairs = convex.Compare(order, eye, 100, dice);
      CHECK_GREATER(pairs.All, 30);
      CHECK_EQUAL(pairs.Wrong, 0);
    }
  }
}
}

int TestMeshVisibilitySortSettings(int, char*[])
{
  RelevoCheck check;
  TestTraversals(check);
  TestChanges(check);
  TestErrors(check);
  TestNoCells(check);
  TestBadCells(check);
  TestCollapsedCells(check);
  TestFlatCells(check);
  return check.GetResult();
}
