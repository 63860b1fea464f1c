// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the benchmark's coarse meshes have the expected number of faces, a consistent winding
// and no slivers, and that they are closed where expected.
#include "BenchmarkMeshes.h"
#include "RelevoCheck.h"

#include "Points/MergedPoints.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

namespace
{
void CheckMesh(RelevoCheck& check, vtkPolyData* mesh, int faces, int openEdges)
{
  CHECK_EQUAL(mesh->GetNumberOfPolys(), faces);
  CHECK_EQUAL(mesh->GetNumberOfCells(), faces);
  const auto places = relevo::ComputeMergedPoints(mesh->GetPoints());
  const auto getPlace = [&places](vtkIdType point)
  { return places.empty() ? point : static_cast<vtkIdType>(places[point]); };
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (!CHECK_NOT_EQUAL(normals, nullptr))
  {
    return;
  }

  std::map<std::pair<vtkIdType, vtkIdType>, int> sides;
  double volume = 0.0;
  double smallest = 180.0;
  bool normalsFollow = true;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    if (!CHECK_EQUAL(ids->GetNumberOfIds(), 3))
    {
      return;
    }
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids->GetId(i), p[i]);
      ++sides[{ getPlace(ids->GetId(i)), getPlace(ids->GetId((i + 1) % 3)) }];
    }
    volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6.0;
    double normal[3];
    for (int i = 0; i < 3; ++i)
    {
      double a[3], b[3];
      vtkMath::Subtract(p[(i + 1) % 3], p[i], a);
      vtkMath::Subtract(p[(i + 2) % 3], p[i], b);
      smallest =
        std::min(smallest, vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(a, b)));
      vtkMath::Cross(a, b, normal);
    }
    for (int i = 0; i < 3; ++i)
    {
      normalsFollow = normalsFollow && vtkMath::Dot(normals->GetTuple(ids->GetId(i)), normal) > 0.0;
    }
  }
  int open = 0;
  bool isOnce = true;
  for (const auto& side : sides)
  {
    isOnce = isOnce && side.second == 1;
    open += sides.count({ side.first.second, side.first.first }) ? 0 : 1;
  }
  CHECK(isOnce); // consistently oriented, with at most two faces per edge
  CHECK_EQUAL(open, openEdges);
  CHECK_GREATER(volume, 0.0);
  CHECK(normalsFollow);
  CHECK_GREATER(smallest, 3.0);
}
}

int TestBenchmarkMeshes(int, char*[])
{
  RelevoCheck check;
  CheckMesh(check, BenchmarkMeshes::MakeSphere(4, 2), 16, 0);
  CheckMesh(check, BenchmarkMeshes::MakeSphere(6, 4), 48, 0);
  CheckMesh(check, BenchmarkMeshes::MakePacMan(9, 5, 5), 110, 0);
  CheckMesh(check, BenchmarkMeshes::MakePacMan(16, 14, 7), 490, 0);
  CheckMesh(check, BenchmarkMeshes::MakeTorus(1.0, 0.4, 12, 8), 192, 0);
  // The roots of four wings have four edges each, that of the fin three.
  CheckMesh(check, BenchmarkMeshes::MakeJet(), 303, 19);
  for (const double faces : { 8.0, 140.0, 2345.0 })
  {
    CHECK_CASE(faces);
    const auto sphere = BenchmarkMeshes::MakeSphere(faces);
    CHECK_GREATER_EQUAL(sphere->GetNumberOfPolys(), faces);
    CHECK_LESS(sphere->GetNumberOfPolys(), 1.5 * faces + 4.0);
    CheckMesh(check, sphere, static_cast<int>(sphere->GetNumberOfPolys()), 0);
  }
  return check.GetResult();
}
