// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshFilter promises its tolerance on meshes of real data: the fandisk with its sharp
// edges, and the bunny, a scan with an open border.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkMicroMeshFilter.h"
#include "vtkPLYReader.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace RelevoMicroMeshes;

namespace
{
Mesh ReadFandisk(const std::string& name)
{
  std::ifstream file(name);
  std::string word;
  int numbers[3] = { 0, 0, 0 };
  file >> word >> numbers[0] >> numbers[1] >> numbers[2];
  std::vector<std::array<double, 3>> points(static_cast<size_t>(numbers[0]));
  for (std::array<double, 3>& point : points)
  {
    file >> point[0] >> point[1] >> point[2];
  }
  std::vector<RelevoMeshes::Triangle> triangles(static_cast<size_t>(numbers[1]));
  for (RelevoMeshes::Triangle& triangle : triangles)
  {
    int size;
    file >> size >> triangle[0] >> triangle[1] >> triangle[2];
  }
  return RelevoMeshes::FromTriangles(points, triangles);
}

void CheckScan(
  RelevoCheck& check, const std::string& name, vtkPolyData* dense, double share, double most)
{
  CHECK_CASE(name);
  const double tolerance = share * dense->GetLength();
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(dense);
  filter->SetTolerance(tolerance);
  filter->SetMaximumLevel(3);
  filter->Update();
  CHECK(errors.None());
  vtkPolyData* micro = filter->GetOutput();
  CHECK_GREATER(micro->GetNumberOfPolys(), 100);
  CHECK_LESS(micro->GetNumberOfPolys(), most * dense->GetNumberOfPolys());
  const Mesh result = Decode(micro, 3);
  const double rounding = 1e-6 * dense->GetLength();
  CHECK_LESS_EQUAL(GetDistance(dense, result), tolerance + rounding);
  CHECK_LESS_EQUAL(GetDistance(result, dense), tolerance + rounding);
}
}

int TestMicroMeshFilterScans(int, char*[])
{
  RelevoCheck check;
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string folder = std::string(data ? data : "") + "/mesh/";
  if (!std::ifstream(folder + "fandisk.off") || !std::ifstream(folder + "bunny.ply"))
  {
    std::cerr << "RELEVO_TEST_DATA has no mesh/fandisk.off and mesh/bunny.ply: skipped\n";
    return 125;
  }
  CheckScan(check, "fandisk", ReadFandisk(folder + "fandisk.off"), 0.002, 0.035);
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((folder + "bunny.ply").c_str());
  reader->Update();
  CheckScan(check, "bunny", reader->GetOutput(), 0.005, 0.02);
  return check.GetResult();
}
