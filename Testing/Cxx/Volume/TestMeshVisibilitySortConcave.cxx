// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves limits.md on cell projection: the order across gaps may be wrong, which this test counts
// in meshes with holes, and cells may form a cycle.
#include "RelevoCheck.h"
#include "RelevoVisibility.h"
#include "vtkMeshVisibilitySort.h"

#include "vtkCellType.h"
#include "vtkDelaunay3D.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <functional>
#include <string>

namespace
{
using Mesh = vtkSmartPointer<vtkUnstructuredGrid>;

// The cells whose centres are not in a hole.
Mesh CutHoles(vtkUnstructuredGrid* mesh, const std::function<bool(const RelevoPoint&)>& isInHole)
{
  auto rest = Mesh::New();
  rest->SetPoints(mesh->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    RelevoPoint center = { { 0.0, 0.0, 0.0 } };
    mesh->GetCellPoints(i, ids);
    for (vtkIdType id : *ids)
    {
      for (int c = 0; c < 3; ++c)
      {
        center[c] += mesh->GetPoint(id)[c] / ids->GetNumberOfIds();
      }
    }
    if (mesh->GetCellType(i) == VTK_TETRA && !isInHole(center))
    {
      rest->InsertNextCell(VTK_TETRA, ids);
    }
  }
  return rest;
}

Mesh MakeDelaunay(int numberOfPoints, RelevoDice& dice)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < numberOfPoints; ++i)
  {
    points->InsertNextPoint(dice.Share(), dice.Share(), dice.Share());
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  Mesh mesh = delaunay->GetOutput();
  return mesh;
}

void TestHoles(RelevoCheck& check, RelevoDice& dice)
{
  const auto isBall = [](const RelevoPoint& x)
  { return std::hypot(x[0] - 0.5, x[1] - 0.5, x[2] - 0.5) < 0.35; };
  const auto isTrench = [](const RelevoPoint& x) { return x[0] > 0.3 && x[1] > 0.3 && x[1] < 0.7; };
  const auto isAnywhere = [&](const RelevoPoint&) { return dice.Once(3); };
  const auto isNowhere = [](const RelevoPoint&) { return false; };
  const auto cube = MakeTetrahedra(8, GetLinearField);
  const Mesh delaunay = MakeDelaunay(600, dice);
  const auto count = [&](const std::string& name, vtkUnstructuredGrid* mesh)
  { return CountPairs(check, name, mesh, dice, 300); };

  CHECK_EQUAL(count("hollow cube", CutHoles(cube, isBall)).Wrong, 0);
  CHECK_EQUAL(count("trench", CutHoles(cube, isTrench)).Wrong, 0);
  CHECK_EQUAL(count("Delaunay", CutHoles(delaunay, isNowhere)).Wrong, 0);
  // Gaps lie between cells of all sizes and shapes.
  const RelevoPairs hollow = count("hollow Delaunay", CutHoles(delaunay, isBall));
  CHECK_LESS(500 * hollow.Wrong, hollow.All);
  const RelevoPairs sponge = count("sponge", CutHoles(cube, isAnywhere));
  CHECK_LESS(200 * sponge.Wrong, sponge.All);
  const RelevoPairs uneven = count("Delaunay sponge", CutHoles(delaunay, isAnywhere));
  CHECK_LESS(30 * uneven.Wrong, uneven.All);
}

// Hexahedra around an axis, each twisted like a propeller blade.
void TestCircle(RelevoCheck& check)
{
  auto mesh = Mesh::New();
  vtkNew<vtkPoints> points;
  mesh->SetPoints(points);
  const double third = 2.0 * std::acos(-1.0) / 3.0;
  for (int blade = 0; blade < 3; ++blade)
  {
    vtkIdType ids[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      const bool isTop = corner > 3;
      const bool isOuter = corner % 4 == 1 || corner % 4 == 2;
      const bool isNext = corner % 4 > 1;
      const double angle = (blade + isNext) % 3 * third + (isTop ? 0.3 : 0.0);
      const double radius = isOuter ? 1.0 : 0.2;
      ids[corner] = points->InsertNextPoint(
        radius * std::cos(angle), radius * std::sin(angle), isTop ? 0.5 : 0.0);
    }
    mesh->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  const auto camera = MakeCamera({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } });
  sort->SetCamera(camera);
  for (bool isParallel : { true, false })
  {
    CHECK_CASE(isParallel);
    camera->SetParallelProjection(isParallel);
    CHECK(IsEachOnce(mesh, Traverse(sort)));
    CHECK_EQUAL(sort->GetNumberOfCycles(), 1);
  }
  camera->SetPosition(9.0, 0.5, 0.2);
  camera->SetViewUp(0.0, 0.0, 1.0);
  CHECK(IsEachOnce(mesh, Traverse(sort)));
  CHECK_EQUAL(sort->GetNumberOfCycles(), 0);
}
}

int TestMeshVisibilitySortConcave(int, char*[])
{
  RelevoCheck check;
  RelevoDice dice(1);
  TestHoles(check, dice);
  TestCircle(check);
  return check.GetResult();
}
