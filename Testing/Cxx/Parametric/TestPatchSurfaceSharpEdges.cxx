// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurface promises separate points for different normals at sharp edges, and shared points
// where normals agree.
#include "RelevoCheck.h"
#include "RelevoCurves.h"
#include "RelevoPatches.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkHeightField.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPatchSurface.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;
constexpr double Tolerance = 1e-3; // length of the difference of normals

// Heights of 0.1 with a hole.
class HoledHeights : public vtkHeightField
{
public:
  static HoledHeights* New() { VTK_STANDARD_NEW_BODY(HoledHeights); }
  vtkTypeMacro(HoledHeights, vtkHeightField);

  bool Update() override { return true; }
  void GetDimensions(int dimensions[2]) override { dimensions[0] = dimensions[1] = Size; }
  void GetRange(double range[2]) override { range[0] = range[1] = 0.1; }
  bool HasNoData() override { return true; }
  vtkMTimeType GetSamplesMTime() override { return this->GetMTime(); }
  const float* GetSamples() override { return this->Samples.data(); }
  const unsigned char* GetValidity() override { return this->Validity.data(); }

protected:
  HoledHeights()
  {
    for (int i = 0; i < Size * Size; ++i)
    {
      this->Samples[i] = 0.1f;
      this->Validity[i] = i % Size > Size / 3 && i % Size < Size / 2 ? 0 : 1;
    }
  }

private:
  static constexpr int Size = 32;
  std::array<float, Size * Size> Samples;
  std::array<unsigned char, Size * Size> Validity;
};

Mesh Refine(RelevoCheck& check, vtkPolyData* patches, int level, vtkDisplacement* displacement)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  recipe->SetMaximumLevel(level);
  recipe->SetDisplacement(displacement);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(recipe);
  filter->SetInputData(patches);
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.None());
  return filter->GetOutput();
}

RelevoPosition GetNormal(vtkPolyData* mesh, vtkIdType point)
{
  RelevoPosition normal;
  mesh->GetPointData()->GetNormals()->GetTuple(point, normal.data());
  return normal;
}

RelevoPosition GetPosition(vtkPolyData* mesh, vtkIdType point)
{
  RelevoPosition x;
  mesh->GetPoint(point, x.data());
  return x;
}

std::map<RelevoPosition, std::vector<vtkIdType>> GetMergedPoints(vtkPolyData* mesh)
{
  std::map<RelevoPosition, std::vector<vtkIdType>> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    places[GetPosition(mesh, i)].push_back(i);
  }
  return places;
}

// Coincident points differ only in their normals. Returns the number of merged points.
vtkIdType CheckCopies(RelevoCheck& check, vtkPolyData* refined)
{
  const auto places = GetMergedPoints(refined);
  vtkPointData* data = refined->GetPointData();
  for (const auto& place : places)
  {
    for (const vtkIdType point : place.second)
    {
      CHECK_NEAR(vtkMath::Norm(GetNormal(refined, point).data()), 1.0, 1e-5);
      for (const vtkIdType other : place.second)
      {
        CHECK(other == point ||
          RelevoGetDistance(GetNormal(refined, point), GetNormal(refined, other)) > Tolerance);
      }
      for (int a = 0; a < data->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* array = data->GetArray(a);
        for (int c = 0; array != data->GetNormals() && c < array->GetNumberOfComponents(); ++c)
        {
          CHECK_EQUAL(array->GetComponent(point, c), array->GetComponent(place.second[0], c));
        }
      }
    }
  }
  return static_cast<vtkIdType>(places.size());
}

// Deviation of the normals at a triangle's corners from its face normal.
double GetDeviation(vtkPolyData* mesh)
{
  double most = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    const std::vector<RelevoPosition> x = RelevoGetCellPoints(mesh, cell);
    RelevoPosition a;
    RelevoPosition b;
    vtkMath::Subtract(x[1].data(), x[0].data(), a.data());
    vtkMath::Subtract(x[2].data(), x[0].data(), b.data());
    RelevoPosition normal;
    vtkMath::Cross(a.data(), b.data(), normal.data());
    vtkMath::Normalize(normal.data());
    for (int k = 0; k < 3; ++k)
    {
      most = std::max(most, RelevoGetDistance(normal, GetNormal(mesh, ids->GetId(k))));
    }
  }
  return most;
}

void AddRandomTags(vtkPolyData* mesh, int seed)
{
  std::mt19937 random(static_cast<unsigned int>(seed));
  vtkNew<vtkDoubleArray> tags;
  tags->SetName("DepthTag");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    tags->InsertNextValue(static_cast<double>(random() % 6));
  }
  mesh->GetPointData()->AddArray(tags);
}

// The sides are flat, so all normals are those of the sides.
void TestBracket(RelevoCheck& check)
{
  auto patches = RelevoMakePatches(RelevoNewBracket());
  for (int level = 0; level < 5; ++level)
  {
    const Mesh refined = Refine(check, patches, level, nullptr);
    CHECK_LESS(GetDeviation(refined), 1e-5);
    CHECK_EQUAL(RelevoCountOpenEdges(refined), 0);
    // The sides are 14 squares: two in each of six planes, except for an L of three.
    const vtkIdType n = vtkIdType(1) << level;
    const vtkIdType square = (n + 1) * (n + 1);
    const vtkIdType two = (n + 1) * (2 * n + 1);
    const vtkIdType bent = two + n * (n + 1);
    CHECK_EQUAL(refined->GetNumberOfPoints(), 2 * bent + 2 * two + 4 * square);
    CHECK_EQUAL(CheckCopies(check, refined), refined->GetNumberOfCells() / 2 + 2);
  }
  for (int seed = 0; seed < 5; ++seed)
  {
    AddRandomTags(patches, seed);
    const Mesh refined = Refine(check, patches, 5, nullptr);
    CHECK_LESS(GetDeviation(refined), 1e-5);
    CHECK_EQUAL(RelevoCountOpenEdges(refined), 0);
    CheckCopies(check, refined);
  }
}

// Curved sides, displaced sides, and holes.
void TestBent(RelevoCheck& check)
{
  auto patches = RelevoMakePatches(RelevoNewBracket(0.15));
  CheckCopies(check, Refine(check, patches, 3, nullptr));
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.1);
  const Mesh displaced = Refine(check, patches, 3, displacement);
  CHECK_EQUAL(RelevoCountOpenEdges(displaced), 0);
  CHECK_LESS(CheckCopies(check, displaced), displaced->GetNumberOfPoints());

  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < patches->GetNumberOfPoints(); ++i)
  {
    const RelevoPosition x = GetPosition(patches, i);
    coordinates->InsertNextTuple2(0.5 * x[0], 0.5 * x[2]);
  }
  coordinates->SetName("TCoords");
  patches->GetPointData()->SetTCoords(coordinates);
  vtkNew<HoledHeights> heights;
  displacement->SetHeightMap(heights);
  for (int seed = 0; seed < 5; ++seed)
  {
    AddRandomTags(patches, seed);
    const Mesh holed = Refine(check, patches, 5, displacement);
    CHECK_GREATER(RelevoCountOpenEdges(holed), 0);
    CHECK_LESS(CheckCopies(check, holed), holed->GetNumberOfPoints());
    std::set<vtkIdType> used;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < holed->GetNumberOfCells(); ++cell)
    {
      holed->GetCellPoints(cell, ids);
      used.insert(ids->begin(), ids->end());
    }
    CHECK_EQUAL(static_cast<vtkIdType>(used.size()), holed->GetNumberOfPoints());
  }
}

// Where patches join smoothly, points are shared.
void TestSmooth(RelevoCheck& check)
{
  auto source = RelevoMakeTorus(3.0, 1.0).NewSource();
  source->Update();
  for (bool split : { false, true })
  {
    CHECK_CASE(split);
    auto patches = RelevoMakePatches(source->GetOutput(), split);
    for (int level = 0; level < 5; ++level)
    {
      const Mesh refined = Refine(check, patches, level, nullptr);
      CHECK_EQUAL(CheckCopies(check, refined), refined->GetNumberOfPoints());
    }
  }
}

// The same patches with their triangles in the opposite order.
Mesh Reverse(vtkPolyData* patches)
{
  auto reversed = Mesh::New();
  reversed->ShallowCopy(patches);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> order;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = patches->GetNumberOfCells(); cell-- > 0;)
  {
    patches->GetCellPoints(cell, ids);
    polys->InsertNextCell(ids);
    order->InsertNextId(cell);
  }
  reversed->SetPolys(polys);
  vtkNew<vtkCellData> data;
  data->CopyAllOn();
  data->CopyAllocate(patches->GetCellData());
  vtkNew<vtkIdList> places;
  for (vtkIdType i = 0; i < order->GetNumberOfIds(); ++i)
  {
    places->InsertNextId(i);
  }
  data->CopyData(patches->GetCellData(), order, places);
  reversed->GetCellData()->ShallowCopy(data);
  return reversed;
}

// Normals that agree up to rounding are shared, independent of the order.
void TestOrder(RelevoCheck& check)
{
  auto source = RelevoMakeTorus(3.0, 1.0).NewSource();
  source->Update();
  const auto getPoints = [](vtkPolyData* mesh)
  {
    std::multiset<std::pair<RelevoPosition, RelevoPosition>> points;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      points.insert({ GetPosition(mesh, i), GetNormal(mesh, i) });
    }
    return points;
  };
  const vtkSmartPointer<vtkUnstructuredGrid> grids[] = { RelevoNewBracket(0.1), source->GetOutput(),
    RelevoNewCell(VTK_LAGRANGE_HEXAHEDRON, { { 3, 3, 3 } }, 0.05) };
  for (const auto& grid : grids)
  {
    auto patches = RelevoMakePatches(grid);
    for (int level = 0; level < 5; ++level)
    {
      CHECK_EQUAL(getPoints(Refine(check, patches, level, nullptr)),
        getPoints(Refine(check, Reverse(patches), level, nullptr)));
    }
  }
}

void TestNotch(RelevoCheck& check)
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string name = std::string(data ? data : "") + "/result/notch_disp.vtu";
  if (!std::ifstream(name))
  {
    std::cerr << "RELEVO_TEST_DATA has no result/notch_disp.vtu\n";
    return;
  }
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  const Mesh refined = Refine(check, RelevoMakePatches(reader->GetOutput()), 2, nullptr);
  const vtkIdType places = CheckCopies(check, refined);
  CHECK_EQUAL(places, refined->GetNumberOfCells() / 2 + 2);
  CHECK_GREATER(refined->GetNumberOfPoints(), places);
  CHECK_LESS(refined->GetNumberOfPoints(), 1.05 * places);
  CHECK_LESS(GetDeviation(refined), 0.2);
}
}

int TestPatchSurfaceSharpEdges(int, char*[])
{
  RelevoCheck check;
  TestBracket(check);
  TestBent(check);
  TestSmooth(check);
  TestOrder(check);
  TestNotch(check);
  return check.GetResult();
}
