// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkIntegrationPoints promises the points of cells with their values, vtkIntegrationPointAverage
// the mean values of cells.
#include "RelevoCheck.h"

#include "vtkAppendFilter.h"
#include "vtkArrayQuantityFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationQuadratureSchemeDefinitionVectorKey.h"
#include "vtkInformationStringKey.h"
#include "vtkIntegrationPointAverage.h"
#include "vtkIntegrationPoints.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkQuadraturePointsGenerator.h"
#include "vtkQuadratureSchemeDefinition.h"
#include "vtkQuadratureSchemeDictionaryGenerator.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
// A function that rules with two points in each direction integrate exactly.
double Evaluate(const double x[3])
{
  return 1.0 + 2.0 * x[0] - x[1] + 3.0 * x[2];
}

vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 2);
  image->SetSpacing(1.0, 0.5, 2.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(Evaluate(image->GetPoint(i)));
  }
  image->GetPointData()->AddArray(heights);
  vtkNew<vtkDataSetTriangleFilter> divide;
  divide->SetInputData(image);
  divide->Update();
  return divide->GetOutput();
}

// The grid with VTK's quadrature scheme, and an array of 2 components at its points.
vtkSmartPointer<vtkUnstructuredGrid> MakeSchemeGrid()
{
  vtkNew<vtkQuadratureSchemeDictionaryGenerator> scheme;
  scheme->SetInputData(MakeTetrahedra());
  scheme->Update();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(scheme->GetOutput());
  vtkDataArray* offsets = grid->GetCellData()->GetArray("QuadratureOffset");
  vtkNew<vtkDoubleArray> values;
  values->SetName("S");
  values->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < 4 * grid->GetNumberOfCells(); ++i)
  {
    values->InsertNextTuple2(static_cast<double>(i % 4), static_cast<double>(i));
  }
  values->GetInformation()->Set(
    vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME(), offsets->GetName());
  grid->GetFieldData()->AddArray(values);
  return grid;
}

// Points and values are those of VTK's filter.
void TestScheme(RelevoCheck& check)
{
  const auto grid = MakeSchemeGrid();
  vtkNew<vtkQuadraturePointsGenerator> theirs;
  theirs->SetInputData(grid);
  theirs->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "QuadratureOffset");
  theirs->Update();
  vtkPolyData* expected = theirs->GetOutput();
  vtkNew<vtkIntegrationPoints> points;
  RelevoErrors errors(points);
  points->SetInputData(grid);
  points->SetArrayName("S");
  points->Update();
  CHECK(errors.None());
  vtkPolyData* output = points->GetOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 4 * grid->GetNumberOfCells());
  CHECK_EQUAL(output->GetNumberOfVerts(), output->GetNumberOfPoints());
  vtkDataArray* values = output->GetPointData()->GetArray("S");
  vtkDataArray* cells = output->GetPointData()->GetArray("vtkOriginalCellIds");
  CHECK(values && cells && expected->GetNumberOfPoints() == output->GetNumberOfPoints());
  for (vtkIdType i = 0; values && cells && i < output->GetNumberOfPoints(); ++i)
  {
    CHECK_CASE(i);
    CHECK_LESS(
      std::sqrt(vtkMath::Distance2BetweenPoints(output->GetPoint(i), expected->GetPoint(i))), 1e-6);
    CHECK_EQUAL(
      values->GetComponent(i, 1), expected->GetPointData()->GetArray("S")->GetComponent(i, 1));
    CHECK_EQUAL(cells->GetComponent(i, 0), static_cast<double>(i / 4));
  }

  vtkNew<vtkIntegrationPointAverage> average;
  RelevoErrors averageErrors(average);
  average->SetInputData(grid);
  average->Update();
  CHECK(averageErrors.None());
  vtkDataArray* means =
    vtkDataSet::SafeDownCast(average->GetOutput())->GetCellData()->GetArray("S");
  CHECK(means && means->GetNumberOfTuples() == grid->GetNumberOfCells());
  for (vtkIdType i = 0; means && i < grid->GetNumberOfCells(); ++i)
  {
    CHECK_NEAR(means->GetComponent(i, 0), 1.5, 1e-12);
    CHECK_NEAR(means->GetComponent(i, 1), 4.0 * i + 1.5, 1e-9);
  }
  CHECK(!grid->GetCellData()->HasArray("S")); // the input is as it was

  // A cell array of this name is kept.
  vtkNew<vtkDoubleArray> own;
  own->SetName("S");
  own->SetNumberOfTuples(grid->GetNumberOfCells());
  own->Fill(7.0);
  grid->GetCellData()->AddArray(own);
  average->Update();
  means = vtkDataSet::SafeDownCast(average->GetOutput())->GetCellData()->GetArray("S");
  CHECK_EQUAL(means->GetComponent(0, 0), 7.0);
}

// A single cell of a type, stretched, with a component for each integration point.
vtkSmartPointer<vtkUnstructuredGrid> MakeCell(int type, int corners, int components)
{
  const double places[8][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 }, { 0, 0, 3 },
    { 2, 0, 3 }, { 2, 1, 3 }, { 0, 1, 3 } };
  const std::vector<int> chosen = type == VTK_TETRA ? std::vector<int>{ 0, 1, 3, 4 }
    : type == VTK_WEDGE                             ? std::vector<int>{ 0, 1, 3, 4, 5, 7 }
    : type == VTK_PYRAMID                           ? std::vector<int>{ 0, 1, 2, 3, 4 }
    : type == VTK_TRIANGLE                          ? std::vector<int>{ 0, 1, 3 }
                                                    : std::vector<int>{ 0, 1, 2, 3, 4, 5, 6, 7 };
  vtkNew<vtkPoints> points;
  std::vector<vtkIdType> ids;
  for (int i = 0; i < corners; ++i)
  {
    ids.push_back(points->InsertNextPoint(places[chosen[i]]));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->InsertNextCell(type, corners, ids.data());
  vtkNew<vtkDoubleArray> values;
  values->SetName("V");
  values->SetNumberOfComponents(components);
  std::vector<double> tuple;
  for (int i = 0; i < components; ++i)
  {
    tuple.push_back(i);
  }
  values->InsertNextTuple(tuple.data());
  grid->GetCellData()->AddArray(values);
  return grid;
}

// The mean of a linear function at the points is its mean over the cell, which is its value at the
// centroid.
void TestRules(RelevoCheck& check)
{
  struct
  {
    int Type;
    int Corners;
    int Components;
    std::array<double, 3> Centroid;
  } cases[] = { { VTK_HEXAHEDRON, 8, 1, { { 1.0, 0.5, 1.5 } } },
    { VTK_HEXAHEDRON, 8, 8, { { 1.0, 0.5, 1.5 } } },
    { VTK_HEXAHEDRON, 8, 27, { { 1.0, 0.5, 1.5 } } }, { VTK_QUAD, 4, 1, { { 1.0, 0.5, 0.0 } } },
    { VTK_QUAD, 4, 4, { { 1.0, 0.5, 0.0 } } }, { VTK_QUAD, 4, 9, { { 1.0, 0.5, 0.0 } } },
    { VTK_TRIANGLE, 3, 1, { { 2.0 / 3, 1.0 / 3, 0.0 } } },
    { VTK_TRIANGLE, 3, 3, { { 2.0 / 3, 1.0 / 3, 0.0 } } },
    { VTK_TETRA, 4, 1, { { 0.5, 0.25, 0.75 } } }, { VTK_TETRA, 4, 4, { { 0.5, 0.25, 0.75 } } },
    { VTK_WEDGE, 6, 1, { { 2.0 / 3, 1.0 / 3, 1.5 } } },
    { VTK_WEDGE, 6, 2, { { 2.0 / 3, 1.0 / 3, 1.5 } } },
    { VTK_WEDGE, 6, 6, { { 2.0 / 3, 1.0 / 3, 1.5 } } },
    { VTK_WEDGE, 6, 9, { { 2.0 / 3, 1.0 / 3, 1.5 } } } };
  for (const auto& given : cases)
  {
    CHECK_CASE(std::to_string(given.Type) + " " + std::to_string(given.Components));
    vtkNew<vtkIntegrationPoints> points;
    RelevoErrors errors(points);
    points->SetInputData(MakeCell(given.Type, given.Corners, given.Components));
    points->SetArrayName("V");
    points->Update();
    CHECK(errors.None());
    vtkPolyData* output = points->GetOutput();
    CHECK_EQUAL(output->GetNumberOfPoints(), static_cast<vtkIdType>(given.Components));
    double mean = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      mean += Evaluate(output->GetPoint(i)) / given.Components;
      CHECK_EQUAL(
        output->GetPointData()->GetArray("V")->GetComponent(i, 0), static_cast<double>(i));
    }
    CHECK_NEAR(mean, Evaluate(given.Centroid.data()), 1e-12);
  }
  // The order of 8 points: x fastest, then y.
  vtkNew<vtkIntegrationPoints> points;
  points->SetInputData(MakeCell(VTK_HEXAHEDRON, 8, 8));
  points->SetArrayName("V");
  points->Update();
  const double a = 0.5 - 0.5 / std::sqrt(3.0);
  const double expected[3][3] = { { 2.0 * a, a, 3.0 * a }, { 2.0 - 2.0 * a, a, 3.0 * a },
    { 2.0 * a, 1.0 - a, 3.0 * a } };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    CHECK_LESS(
      std::sqrt(vtkMath::Distance2BetweenPoints(points->GetOutput()->GetPoint(i), expected[i])),
      1e-12);
  }
  // Points of triangles and tetrahedra are nearest to their corners.
  for (int type : { VTK_TRIANGLE, VTK_TETRA })
  {
    const int corners = type == VTK_TRIANGLE ? 3 : 4;
    const auto cell = MakeCell(type, corners, corners);
    points->SetInputData(cell);
    points->Update();
    for (vtkIdType i = 0; i < corners; ++i)
    {
      for (vtkIdType k = 0; k < corners; ++k)
      {
        double place[3];
        double own[3];
        double other[3];
        points->GetOutput()->GetPoint(i, place);
        cell->GetPoint(i, own);
        cell->GetPoint(k, other);
        CHECK(k == i ||
          vtkMath::Distance2BetweenPoints(place, own) <
            vtkMath::Distance2BetweenPoints(place, other));
      }
    }
  }
}

void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeCell(VTK_HEXAHEDRON, 8, 8));
  blocks->SetBlock(1, MakeTetrahedra()); // without the array
  blocks->SetBlock(2, MakeCell(VTK_PYRAMID, 5, 8));
  blocks->SetBlock(3, MakeCell(VTK_HEXAHEDRON, 8, 8));
  vtkNew<vtkIntegrationPoints> points;
  RelevoErrors errors(points);
  points->SetInputData(blocks);
  points->SetArrayName("V");
  points->Update();
  CHECK(errors.Warned("no integration points in 1 vtkPyramid"));
  CHECK_EQUAL(points->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(16));

  vtkNew<vtkArrayQuantityFilter> mean;
  mean->SetInputData(MakeCell(VTK_HEXAHEDRON, 8, 8));
  mean->SetQuantity("Mean of V");
  mean->Update();
  vtkDataArray* means =
    vtkDataSet::SafeDownCast(mean->GetOutput())->GetCellData()->GetArray("mean of V");
  CHECK(means && std::abs(means->GetComponent(0, 0) - 3.5) < 1e-12);
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkIntegrationPoints> points;
  RelevoErrors errors(points);
  const auto expect = [&](vtkDataSet* data, const char* name, const char* words)
  {
    CHECK_CASE(words);
    points->SetInputData(data);
    points->SetArrayName(name);
    points->Update();
    CHECK(errors.Said(words));
    CHECK_EQUAL(points->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(0));
  };
  const auto grid = MakeSchemeGrid();
  expect(grid, "", "call SetArrayName()");
  expect(grid, "Nothing", "There is no array 'Nothing'");
  expect(MakeCell(VTK_HEXAHEDRON, 8, 5), "V", "there is no rule for 1 vtkHexahedron");
  vtkDataArray* values = vtkDataArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("S"));
  values->SetNumberOfTuples(values->GetNumberOfTuples() - 1);
  grid->Modified();
  expect(grid, "S", "the values of cell 19 are beyond the 79 tuples");
  vtkNew<vtkIntegrationPointAverage> average;
  RelevoErrors averageErrors(average);
  average->SetInputData(grid);
  average->Update();
  CHECK(averageErrors.Warned("'S' of values at integration points is left out: the values"));
  CHECK(!vtkDataSet::SafeDownCast(average->GetOutput())->GetCellData()->HasArray("S"));

  vtkDataArray* offsets = grid->GetCellData()->GetArray("QuadratureOffset");
  vtkNew<vtkQuadratureSchemeDefinition> other;
  double weights[2] = { 0.5, 0.5 };
  other->Initialize(VTK_TETRA, 2, 1, weights);
  vtkQuadratureSchemeDefinition::DICTIONARY()->Set(offsets->GetInformation(), other, VTK_TETRA);
  expect(grid, "S", "cell 0 has 4 nodes, but its quadrature scheme 2");
  offsets->SetComponent(2, 0, -1.0);
  expect(grid, "S", "the values of cell 2 are beyond");
  offsets->GetInformation()->Remove(vtkQuadratureSchemeDefinition::DICTIONARY());
  expect(grid, "S", "'QuadratureOffset' has no quadrature schemes");
  grid->GetCellData()->RemoveArray("QuadratureOffset");
  expect(grid, "S", "there is no cell array 'QuadratureOffset' of offsets");
}
}

int TestIntegrationPoints(int, char*[])
{
  RelevoCheck check;
  TestScheme(check);
  TestRules(check);
  TestBlocks(check);
  TestErrors(check);
  return check.GetResult();
}
