// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkArrayQuantityFilter promises numbers from vectors and tensors, by name, in all blocks.
#include "RelevoCheck.h"

#include "vtkArrayQuantityFilter.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{
const double Angle = 0.7;

// The tensor with the principal values 3, 1 and -2, turned about z and then about x.
void MakeTensor(double matrix[3][3])
{
  const double c = std::cos(Angle);
  const double s = std::sin(Angle);
  double aboutZ[3][3] = { { c, -s, 0.0 }, { s, c, 0.0 }, { 0.0, 0.0, 1.0 } };
  double aboutX[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, c, -s }, { 0.0, s, c } };
  double turned[3][3];
  vtkMath::Multiply3x3(aboutX, aboutZ, turned);
  double scaled[3][3];
  const double values[3] = { 1.0, -2.0, 3.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      scaled[i][k] = turned[i][k] * values[k];
    }
  }
  double back[3][3];
  vtkMath::Transpose3x3(turned, back);
  vtkMath::Multiply3x3(scaled, back, matrix);
}

void AddArray(
  vtkDataSetAttributes* data, const char* name, const std::vector<double>& tuple, vtkIdType number)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(tuple.size()));
  for (vtkIdType i = 0; i < number; ++i)
  {
    array->InsertNextTuple(tuple.data());
  }
  data->AddArray(array);
}

vtkSmartPointer<vtkImageData> MakeBlock()
{
  double m[3][3];
  MakeTensor(m);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 2, 2);
  AddArray(
    image->GetPointData(), "Stress", { m[0][0], m[1][1], m[2][2], m[0][1], m[1][2], m[0][2] }, 12);
  AddArray(image->GetPointData(), "Speed", { 3.0, -4.0, 12.0 }, 12);
  // An antisymmetric part does not matter.
  AddArray(image->GetCellData(), "Strain",
    { m[0][0], m[0][1] + 0.3, m[0][2], m[1][0] - 0.3, m[1][1], m[1][2], m[2][0], m[2][1], m[2][2] },
    2);
  return image;
}

void TestValues(RelevoCheck& check)
{
  double m[3][3];
  MakeTensor(m);
  const auto block = MakeBlock();
  vtkNew<vtkArrayQuantityFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(block);
  struct
  {
    const char* Name;
    double Value;
  } cases[] = { { "von Mises of Stress", std::sqrt(19.0) },
    { "VON-MISES of Stress", std::sqrt(19.0) }, { "Tresca of Stress", 5.0 },
    { "principal 1 of Stress", 3.0 }, { "principal 2 of Stress", 1.0 },
    { "principal 3 of Stress", -2.0 }, { "yz of Stress", m[1][2] }, { "xz of Stress", m[0][2] },
    { "component 3 of Stress", m[0][1] }, { "x of Speed", 3.0 }, { "Y of Speed", -4.0 },
    { "z of Speed", 12.0 }, { "magnitude of Speed", 13.0 },
    { "von Mises of Strain", std::sqrt(19.0) }, { "Tresca of Strain", 5.0 },
    { "principal 3 of Strain", -2.0 }, { "xy of Strain", m[0][1] + 0.3 },
    { "yx of Strain", m[1][0] - 0.3 } };
  for (const auto& given : cases)
  {
    CHECK_CASE(given.Name);
    filter->SetQuantity(given.Name);
    filter->Update();
    CHECK(errors.None());
    vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutput());
    vtkDataArray* ofPoints = output->GetPointData()->GetArray(filter->GetResultName());
    vtkDataArray* ofCells = output->GetCellData()->GetArray(filter->GetResultName());
    vtkDataArray* result = ofPoints ? ofPoints : ofCells;
    CHECK(result && result->GetNumberOfTuples() == (ofPoints ? 12 : 2));
    if (result)
    {
      CHECK_NEAR(result->GetComponent(1, 0), given.Value, 1e-12);
    }
    CHECK_EQUAL(block->GetPointData()->GetNumberOfArrays(), 2); // the input is as it was
  }
  filter->SetQuantity("VON-MISES of Stress");
  filter->Update();
  CHECK_EQUAL(std::string(filter->GetResultName()), "von Mises of Stress");
}

void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto first = MakeBlock();
  first->GetCellData()->RemoveArray("Strain");
  vtkNew<vtkImageData> second;
  second->SetDimensions(2, 2, 2);
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  vtkNew<vtkArrayQuantityFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(blocks);
  filter->SetQuantity("von Mises"); // of the only tensor
  filter->Update();
  CHECK(errors.None());
  CHECK_EQUAL(std::string(filter->GetResultName()), "von Mises of Stress");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  const auto count = [](vtkDataObject* block)
  { return vtkDataSet::SafeDownCast(block)->GetPointData()->GetNumberOfArrays(); };
  CHECK_EQUAL(count(output->GetBlock(0)), 3);
  CHECK_EQUAL(count(output->GetBlock(1)), 0);
  CHECK_EQUAL(count(blocks->GetBlock(0)), 2);
}

void TestOthers(RelevoCheck& check)
{
  vtkNew<vtkArrayQuantityFilter> filter;
  RelevoErrors errors(filter);
  const auto block = MakeBlock();
  AddArray(block->GetPointData(), "x of Speed", { 7.0 }, 12);
  filter->SetInputData(block);
  const auto getOutput = [&] { return vtkDataSet::SafeDownCast(filter->GetOutput()); };
  // Names that are no quantities, and an array with the name of one.
  for (const char* name : { "", "Speed", "speed of sound", "principal 4 of Stress", "x of Speed" })
  {
    filter->SetQuantity(name);
    filter->Update();
    CHECK(errors.None());
    CHECK_EQUAL(std::string(filter->GetResultName()), name);
    CHECK_EQUAL(getOutput()->GetPointData()->GetNumberOfArrays(), 3);
  }
  CHECK_EQUAL(getOutput()->GetPointData()->GetArray("x of Speed")->GetComponent(0, 0), 7.0);

  filter->SetQuantity("von Mises of Nothing");
  filter->Update();
  CHECK(errors.Said("there is no array 'Nothing'; arrays with 6 or 9 components are 'Stress'"));
  for (const char* name :
    { "von Mises of Speed", "z of Stress", "component 6 of Stress", "zx of Stress" })
  {
    CHECK_CASE(name);
    filter->SetQuantity(name);
    filter->Update();
    CHECK(errors.Said("needs an array with"));
  }
  filter->SetQuantity("von Mises"); // of Stress or of Strain
  filter->Update();
  CHECK(errors.Said("choose one, such as 'von Mises of Stress'"));

  vtkDataArray* stress = block->GetPointData()->GetArray("Stress");
  stress->SetComponent(4, 2, std::numeric_limits<double>::infinity());
  block->Modified();
  for (const char* name : { "von Mises of Stress", "Tresca of Stress", "principal 1 of Stress" })
  {
    filter->SetQuantity(name);
    filter->Update();
    vtkDataArray* result = getOutput()->GetPointData()->GetArray(name);
    CHECK(result && !std::isfinite(result->GetComponent(4, 0)));
    CHECK(result && std::isfinite(result->GetComponent(5, 0)));
  }
}

// Each listed quantity can be computed.
void TestList(RelevoCheck& check)
{
  for (const auto& expected :
    { std::pair<int, int>(1, 0), { 2, 3 }, { 3, 4 }, { 4, 6 }, { 6, 12 }, { 9, 15 } })
  {
    CHECK_CASE(expected.first);
    vtkNew<vtkStringArray> names;
    names->InsertNextValue("old");
    vtkArrayQuantityFilter::ListQuantities("U of V", expected.first, names);
    CHECK_EQUAL(names->GetNumberOfValues(), expected.second);
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 2);
    AddArray(image->GetPointData(), "U of V",
      std::vector<double>(static_cast<size_t>(expected.first), 1.0), 8);
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      vtkNew<vtkArrayQuantityFilter> filter;
      filter->SetInputData(image);
      filter->SetQuantity(names->GetValue(i).c_str());
      filter->Update();
      CHECK_EQUAL(std::string(filter->GetResultName()), std::string(names->GetValue(i)));
      CHECK(vtkDataSet::SafeDownCast(filter->GetOutput())
              ->GetPointData()
              ->HasArray(names->GetValue(i).c_str()));
    }
  }
}
}

int TestArrayQuantityFilter(int, char*[])
{
  RelevoCheck check;
  TestValues(check);
  TestBlocks(check);
  TestOthers(check);
  TestList(check);
  return check.GetResult();
}
