// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves surfaces.md on missing values: values interpolated from a missing one are missing too, and
// all other values are unaffected.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace
{
using namespace RelevoMeshes;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr vtkIdType Marked = 7; // the point with missing data

// Unit vectors around the z axis, except at the marked point.
template <typename Array>
vtkSmartPointer<Array> AddVectors(
  vtkPolyData* mesh, const char* name, const std::array<double, 3>& marker, double length = 1.0)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  FillVectors(
    mesh,
    [length](const std::array<double, 3>& p)
    {
      const double r = std::max(std::hypot(p[0], p[1]), 1e-6);
      return std::array<double, 3>{ { -length * p[1] / r, length * p[0] / r, 0.0 } };
    },
    array);
  array->SetTuple(Marked, marker.data());
  mesh->GetPointData()->AddArray(array);
  return array;
}

// Counts tuples that equal the marker, that are NaN, or that are no longer than `longest`.
struct Counts
{
  vtkIdType Markers = 0;
  vtkIdType None = 0;
  vtkIdType False = 0;
  Counts(vtkDataArray* array, const std::array<double, 3>& marker, double longest)
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      double v[3];
      array->GetTuple(i, v);
      const bool isMarker = std::equal(v, v + 3, marker.begin(),
        [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
      const bool isNone = std::isnan(v[0]) && std::isnan(v[1]) && std::isnan(v[2]);
      this->Markers += isMarker && !isNone ? 1 : 0;
      this->None += isNone ? 1 : 0;
      this->False += !isMarker && !isNone && !(vtkMath::Norm(v) <= longest) ? 1 : 0;
    }
  }
};

// Output points in faces around the marked point, without that point.
vtkIdType CountAround(vtkPolyData* input, vtkPolyData* output)
{
  std::set<vtkIdType> points;
  vtkNew<vtkIdList> ids;
  vtkDataArray* cells = output->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkDataArray* share = output->GetPointData()->GetArray("Share"); // weight of the marked point
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(static_cast<vtkIdType>(cells->GetTuple1(cell)), ids);
    if (ids->IsId(Marked) >= 0)
    {
      output->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        const double w = share->GetTuple1(ids->GetId(i));
        if (w > 0.0 && w < 1.0)
        {
          points.insert(ids->GetId(i));
        }
      }
    }
  }
  return static_cast<vtkIdType>(points.size());
}

Mesh MakeMesh()
{
  Mesh mesh = Sphere(12, 9);
  vtkNew<vtkFloatArray> share;
  share->SetName("Share");
  share->SetNumberOfTuples(mesh->GetNumberOfPoints());
  share->Fill(0.0);
  share->SetValue(Marked, 1.0f);
  mesh->GetPointData()->AddArray(share);
  return mesh;
}

void TestVectors(RelevoCheck& check)
{
  const std::array<double, 3> markers[] = { { { -1e9, -1e9, -1e9 } }, { { 0.0, -1e9, 0.0 } },
    { { NaN, 0.0, 0.0 } }, { { 0.0, 0.0, Infinity } }, { { 1e8, 0.0, 0.0 } } };
  for (const auto& marker : markers)
  {
    Mesh mesh = MakeMesh();
    AddVectors<vtkFloatArray>(mesh, "Float", marker);
    AddVectors<vtkDoubleArray>(mesh, "Double", marker);
    AddVectors<vtkSOADataArrayTemplate<float>>(mesh, "Apart", marker);
    Mesh output = Refine(mesh, MakeRecipe(5));
    const vtkIdType around = CountAround(mesh, output);
    CHECK_GREATER(around, 2000);
    for (const char* name : { "Float", "Double", "Apart" })
    {
      const Counts counts(output->GetPointData()->GetArray(name), marker, 1.0 + 1e-6);
      CHECK_EQUAL(counts.Markers, 1); // the input's point
      CHECK_EQUAL(counts.None, around);
      CHECK_EQUAL(counts.False, 0);
    }
  }
}

// Integers have no NaN, so the marker also appears at points between.
void TestWholeNumbers(RelevoCheck& check)
{
  const std::array<double, 3> marker = { { -999999999.0, 0.0, 0.0 } };
  Mesh mesh = MakeMesh();
  AddVectors<vtkIntArray>(mesh, "Int", marker, 1000.0);
  AddVectors<vtkSOADataArrayTemplate<int>>(mesh, "Apart", marker, 1000.0);
  Mesh output = Refine(mesh, MakeRecipe(4));
  for (const char* name : { "Int", "Apart" })
  {
    CHECK_CASE(name);
    const Counts counts(output->GetPointData()->GetArray(name), marker, 1001.0);
    CHECK_EQUAL(counts.Markers, 1 + CountAround(mesh, output));
    CHECK_EQUAL(counts.False, 0);
  }
}

// A single number is missing only if it is not finite. Tuples of six components have no
// missing values.
void TestNumbers(RelevoCheck& check)
{
  Mesh mesh = MakeMesh();
  for (double value : { 1e12, Infinity, NaN })
  {
    vtkNew<vtkFloatArray> numbers;
    numbers->SetName(std::to_string(value).c_str());
    numbers->SetNumberOfTuples(mesh->GetNumberOfPoints());
    numbers->Fill(2.0);
    numbers->SetValue(Marked, static_cast<float>(value));
    mesh->GetPointData()->AddArray(numbers);
  }
  vtkNew<vtkFloatArray> stress;
  stress->SetName("Stress");
  stress->SetNumberOfComponents(6);
  stress->SetNumberOfTuples(mesh->GetNumberOfPoints());
  stress->Fill(3e8);
  mesh->GetPointData()->AddArray(stress);
  Mesh output = Refine(mesh, MakeRecipe(3));
  const vtkIdType around = CountAround(mesh, output);
  vtkPointData* data = output->GetPointData();
  vtkIdType none[3] = { 0, 0, 0 };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    int k = 0;
    for (double value : { 1e12, Infinity, NaN })
    {
      CHECK_CASE(value);
      const double x = data->GetArray(std::to_string(value).c_str())->GetTuple1(i);
      none[k] += std::isnan(x) ? 1 : 0;
      CHECK(std::isnan(x) || x >= 2.0);
      ++k;
    }
    CHECK_EQUAL(data->GetArray("Stress")->GetComponent(i, 4), stress->GetValue(0));
  }
  CHECK(none[0] == 0 && none[1] == around && none[2] == around + 1);
}

bool IsSame(vtkDataArray* a, vtkDataArray* b)
{
  const size_t size = static_cast<size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize();
  return a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0;
}

// Without missing values, and for texture coordinates, nothing changes. NoDataMagnitude decides.
void TestUnchanged(RelevoCheck& check)
{
  Mesh mesh = Torus();
  mesh->GetPointData()->GetTCoords()->SetTuple2(Marked, 2e8, 0.0);
  AddVectors<vtkFloatArray>(mesh, "Good", { { 0.1, 0.2, 0.3 } });
  AddVectors<vtkFloatArray>(mesh, "Large", { { 0.0, 2e8, 0.0 } });
  auto with = MakeRecipe(3);
  auto without = MakeRecipe(3);
  CHECK_EQUAL(with->GetNoDataMagnitude(), 1e8);
  without->SetNoDataMagnitude(Infinity);
  Mesh a = Refine(mesh, with);
  Mesh b = Refine(mesh, without);
  for (const char* name : { "Good", "Normals" })
  {
    CHECK_CASE(name);
    CHECK(IsSame(a->GetPointData()->GetArray(name), b->GetPointData()->GetArray(name)));
  }
  CHECK(IsSame(a->GetPointData()->GetTCoords(), b->GetPointData()->GetTCoords()));
  CHECK(IsSame(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  CHECK_GREATER(Counts(a->GetPointData()->GetArray("Large"), { { 0.0, 2e8, 0.0 } }, 2.0).None, 50);
  const Counts all(b->GetPointData()->GetArray("Large"), { { 0.0, 2e8, 0.0 } }, 2e8);
  CHECK_EQUAL(all.None, 0);
  CHECK_EQUAL(all.False, 0);

  RelevoErrors errors(with);
  for (double bad : { 0.0, -1.0, NaN })
  {
    CHECK_CASE(bad);
    with->SetNoDataMagnitude(bad);
    CHECK(errors.Said("NoDataMagnitude must be more than 0"));
    CHECK_EQUAL(with->GetNoDataMagnitude(), 1e8);
  }
}
}

int TestAdaptiveRefinementFilterNoData(int, char*[])
{
  RelevoCheck check;
  TestVectors(check);
  TestWholeNumbers(check);
  TestNumbers(check);
  TestUnchanged(check);
  return check.GetResult();
}
