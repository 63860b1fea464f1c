// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshSurface promises the grid points of the documented arrays, a watertight surface at
// all combinations of levels, and an error for a mesh without valid arrays.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"
#include "RelevoWatertight.h"

#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkMicroMeshSurface.h"
#include "vtkPointData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace RelevoMicroMeshes;

namespace
{
// Reads a micro-mesh by the documentation of vtkMicroMeshFilter.
struct Grids
{
  explicit Grids(vtkPolyData* mesh)
    : Mesh(mesh)
    , Directions(mesh->GetPointData()->GetArray("MicroMeshDirections"))
    , Faces(mesh->GetCellData()->GetArray("MicroMeshFaces"))
    , Edges(mesh->GetFieldData()->GetArray("MicroMeshEdges"))
    , Samples(mesh->GetFieldData()->GetArray("MicroMeshDisplacements"))
  {
  }

  void Displace(vtkIdType cell, const double weights[3], double sample, double x[3]) const
  {
    vtkIdType size;
    const vtkIdType* ids;
    this->Mesh->GetCellPoints(cell, size, ids);
    std::fill_n(x, 3, 0.0);
    for (int corner = 0; corner < 3; ++corner)
    {
      double point[3];
      this->Mesh->GetPoint(ids[corner], point);
      for (int c = 0; c < 3; ++c)
      {
        x[c] +=
          weights[corner] * (point[c] + sample * this->Directions->GetComponent(ids[corner], c));
      }
    }
  }

  // Calls f(x) for the samples of a face.
  template <typename Function>
  void ForEachSample(vtkIdType cell, const Function& f) const
  {
    double x[3];
    for (int e = 0; e < 3; ++e)
    {
      const int reference = static_cast<int>(this->Faces->GetComponent(cell, e));
      const int first = static_cast<int>(this->Edges->GetComponent(reference / 2, 0));
      const int segments = 1 << static_cast<int>(this->Edges->GetComponent(reference / 2, 1));
      for (int i = 1; i < segments; ++i)
      {
        const double share = static_cast<double>(i) / segments;
        double weights[3] = { 0.0, 0.0, 0.0 };
        weights[e] = reference % 2 == 1 ? share : 1.0 - share;
        weights[(e + 1) % 3] = 1.0 - weights[e];
        this->Displace(cell, weights, this->Samples->GetComponent(first + i - 1, 0), x);
        f(x);
      }
    }
    int sample = static_cast<int>(this->Faces->GetComponent(cell, 3));
    const int n = 1 << static_cast<int>(this->Faces->GetComponent(cell, 4));
    for (int k = 1; k < n; ++k)
    {
      for (int j = 1; j + k < n; ++j)
      {
        const double weights[3] = { static_cast<double>(n - j - k) / n, static_cast<double>(j) / n,
          static_cast<double>(k) / n };
        this->Displace(cell, weights, this->Samples->GetComponent(sample++, 0), x);
        f(x);
      }
    }
  }

  vtkPolyData* Mesh;
  vtkDataArray* Directions;
  vtkDataArray* Faces;
  vtkDataArray* Edges;
  vtkDataArray* Samples;
};

void CheckGrids(RelevoCheck& check, vtkPolyData* micro)
{
  const Grids grids(micro);
  const Mesh result = Decode(micro, 4);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(result);
  locator->BuildLocator();
  double largest = 0.0;
  int number = 0;
  for (vtkIdType cell = 0; cell < micro->GetNumberOfCells(); ++cell)
  {
    grids.ForEachSample(cell,
      [&](const double x[3])
      {
        double nearest[3];
        result->GetPoint(locator->FindClosestPoint(x), nearest);
        largest = std::max(largest, vtkMath::Distance2BetweenPoints(x, nearest));
        ++number;
      });
  }
  CHECK_GREATER(number, 500);
  CHECK_LESS(std::sqrt(largest), 1e-6 * micro->GetLength());
}

void CheckError(RelevoCheck& check, vtkPolyData* micro, const char* name,
  const std::function<void(vtkPolyData*)>& edit)
{
  CHECK_CASE(std::string(name));
  vtkNew<vtkPolyData> edited;
  edited->DeepCopy(micro);
  edit(edited);
  vtkNew<vtkMicroMeshSurface> surface;
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(edited);
  filter->SetRefinement(RelevoMeshes::MakeRecipe(2, surface));
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.Said(name));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
}

void CheckErrors(RelevoCheck& check, vtkPolyData* micro)
{
  const auto set = [](vtkDataArray* array, int component, double value)
  { array->SetComponent(0, component, value); };
  CheckError(check, micro, "MicroMeshDirections",
    [](vtkPolyData* mesh) { mesh->GetPointData()->RemoveArray("MicroMeshDirections"); });
  CheckError(check, micro, "MicroMeshDirections",
    [&](vtkPolyData* mesh)
    { set(mesh->GetPointData()->GetArray("MicroMeshDirections"), 1, std::nan("")); });
  for (const char* name : { "MicroMeshEdges", "MicroMeshDisplacements" })
  {
    CheckError(
      check, micro, name, [name](vtkPolyData* mesh) { mesh->GetFieldData()->RemoveArray(name); });
  }
  for (double bad : { -1.0, 1e9 })
  {
    CheckError(check, micro, "MicroMeshEdges",
      [&](vtkPolyData* mesh) { set(mesh->GetFieldData()->GetArray("MicroMeshEdges"), 1, bad); });
    for (int component : { 0, 4 })
    {
      CheckError(check, micro, "MicroMeshFaces",
        [&](vtkPolyData* mesh)
        { set(mesh->GetCellData()->GetArray("MicroMeshFaces"), component, bad); });
    }
  }
  CheckError(check, micro, "MicroMeshFaces",
    [](vtkPolyData* mesh) { mesh->GetCellData()->RemoveArray("MicroMeshFaces"); });
}
}

int TestMicroMeshSurface(int, char*[])
{
  RelevoCheck check;
  const Mesh micro = Encode(ReliefSphere(48, 30), 0.005);
  CheckGrids(check, micro);
  CheckErrors(check, micro);
  vtkNew<vtkMicroMeshSurface> surface;
  for (int level : { 0, 1, 3, 5 })
  {
    CHECK_CASE(level);
    for (const Mesh& mesh : { micro, RelevoMeshes::Tagged(micro, level) })
    {
      const Mesh refined = RelevoMeshes::Refine(mesh, RelevoMeshes::MakeRecipe(level, surface));
      CHECK_EQUAL(RelevoWatertight::FindError(mesh, refined, level), "");
    }
  }
  // Sharp edges, borders and split points.
  const Mesh plate = Encode(Plate(40), 0.01, 4, 0.98, "Material");
  for (int level : { 0, 2, 4 })
  {
    CHECK_CASE(level);
    const Mesh tagged = RelevoMeshes::Tagged(plate, level);
    const Mesh refined = RelevoMeshes::Refine(tagged, RelevoMeshes::MakeRecipe(level, surface));
    CHECK_EQUAL(RelevoWatertight::FindError(tagged, refined, level), "");
  }
  return check.GetResult();
}
