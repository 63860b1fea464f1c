// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshFilter promises that borders, sharp edges, borders between materials and seams stay
// within the tolerance of edges of the coarse mesh, and cell data of each side.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLine.h"
#include "vtkMicroMeshFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace RelevoMicroMeshes;

namespace
{
using Point = std::array<double, 3>;
using Segments = std::set<std::pair<Point, Point>>;

struct Lines
{
  Segments Borders;
  Segments Materials;
  Segments Ridge; // at x = 0
};

// Finds lines by coordinates.
Lines FindLines(vtkPolyData* mesh)
{
  std::map<std::pair<Point, Point>, std::vector<double>> sides; // materials
  vtkDataArray* materials = mesh->GetCellData()->GetArray("Material");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetCellPoints(cell, size, ids);
    for (int e = 0; e < 3; ++e)
    {
      Point a;
      Point b;
      mesh->GetPoint(ids[e], a.data());
      mesh->GetPoint(ids[(e + 1) % 3], b.data());
      sides[std::minmax(a, b)].push_back(materials->GetTuple1(cell));
    }
  }
  Lines lines;
  for (const auto& side : sides)
  {
    const std::vector<double>& found = side.second;
    if (found.size() == 1)
    {
      lines.Borders.insert(side.first);
    }
    else if (found[0] != found[1])
    {
      lines.Materials.insert(side.first);
    }
    if (side.first.first[0] == 0.0 && side.first.second[0] == 0.0)
    {
      lines.Ridge.insert(side.first);
    }
  }
  return lines;
}

// The largest distance from ends and middles of segments to other segments.
double GetLineDistance(const Segments& from, const Segments& to)
{
  double largest = 0.0;
  for (const auto& segment : from)
  {
    for (double share : { 0.0, 0.5, 1.0 })
    {
      double x[3];
      for (int c = 0; c < 3; ++c)
      {
        x[c] = (1.0 - share) * segment.first[c] + share * segment.second[c];
      }
      double nearest = 1e300;
      for (const auto& other : to)
      {
        double t;
        double closest[3];
        nearest = std::min(
          nearest, vtkLine::DistanceToLine(x, other.first.data(), other.second.data(), t, closest));
      }
      largest = std::max(largest, nearest);
    }
  }
  return std::sqrt(largest);
}

void CheckLines(RelevoCheck& check, const Segments& dense, const Segments& coarse, double tolerance)
{
  CHECK_GREATER(coarse.size(), 0);
  CHECK_LESS(coarse.size(), 0.75 * dense.size());
  CHECK_LESS_EQUAL(GetLineDistance(dense, coarse), tolerance);
  CHECK_LESS_EQUAL(GetLineDistance(coarse, dense), tolerance);
}
}

int TestMicroMeshFilterLines(int, char*[])
{
  RelevoCheck check;
  const Mesh plate = Plate(48);
  for (double tolerance : { 0.04, 0.08 })
  {
    CHECK_CASE(tolerance);
    const Mesh micro = Encode(plate, tolerance, 4, 0.98, "Material");
    const Lines dense = FindLines(plate);
    const Lines coarse = FindLines(micro);
    CheckLines(check, dense.Borders, coarse.Borders, tolerance);
    CheckLines(check, dense.Materials, coarse.Materials, tolerance);
    CheckLines(check, dense.Ridge, coarse.Ridge, 1e-6);

    // Each triangle has the data of a triangle of the same material below it.
    vtkNew<vtkMicroMeshFilter> withIds;
    withIds->SetInputData(plate);
    withIds->SetTolerance(tolerance);
    withIds->SetMaximumLevel(4);
    withIds->SetTargetReduction(0.98);
    withIds->SetMaterialArrayName("Material");
    withIds->PassThroughCellIdsOn();
    withIds->Update();
    CHECK(!micro->GetCellData()->HasArray("vtkOriginalCellIds"));
    vtkCellData* data = withIds->GetOutput()->GetCellData();
    vtkDataArray* originals = data->GetArray("vtkOriginalCellIds");
    vtkDataArray* materials = data->GetArray("Material");
    if (!CHECK(originals != nullptr))
    {
      continue;
    }
    for (vtkIdType i = 0; i < micro->GetNumberOfCells(); ++i)
    {
      const auto cell = static_cast<vtkIdType>(originals->GetTuple1(i));
      CHECK_EQUAL(
        plate->GetCellData()->GetArray("Material")->GetTuple1(cell), materials->GetTuple1(i));
    }

    // Normals differ on both sides of the ridge.
    std::map<Point, std::set<float>> normals;
    for (vtkIdType i = 0; i < micro->GetNumberOfPoints(); ++i)
    {
      Point x;
      micro->GetPoint(i, x.data());
      normals[x].insert(
        static_cast<float>(micro->GetPointData()->GetNormals()->GetComponent(i, 0)));
    }
    for (const auto& point : normals)
    {
      CHECK_EQUAL(point.second.size(), point.first[0] == 0.0 ? 2 : 1);
    }
  }

  // If all triangles have separate points, all edges are seams.
  const Mesh small = Plate(6);
  const Mesh exploded = Encode(RelevoMeshes::Explode(small), 0.05);
  CHECK_EQUAL(exploded->GetNumberOfCells(), small->GetNumberOfCells());
  CHECK_EQUAL(exploded->GetNumberOfPoints(), 3 * small->GetNumberOfCells());
  return check.GetResult();
}
