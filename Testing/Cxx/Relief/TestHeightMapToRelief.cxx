// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightMapToRelief promises texel positions, colours and normals of height maps from images,
// missing data and errors.
#include "Data/Relief.h"
#include "RelevoBlocks.h"
#include "RelevoCheck.h"
#include "RelevoReliefs.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHeightMap.h"
#include "vtkHeightMapToRelief.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{
using relevo::dvec3;
using relevo::Relief;

vtkSmartPointer<vtkHeightMap> MakeMap(int width, int height, const RelevoDepth& value)
{
  auto map = vtkSmartPointer<vtkHeightMap>::New();
  map->SetImageData(RelevoMakeImage(width, height, VTK_FLOAT, value));
  return map;
}

// A texel has the size of one unit, the centre of the map is at the origin, and z is the height.
void TestPlaces(RelevoCheck& check)
{
  const auto height = [](int column, int row) { return 100.0 + 7.0 * column - 3.0 * row; };
  vtkNew<vtkHeightMapToRelief> filter;
  const int sizes[][2] = { { 6, 4 }, { 5, 1 }, { 1, 5 } };
  for (const auto& size : sizes)
  {
    filter->SetHeightMap(MakeMap(size[0], size[1], height));
    for (double exaggeration : { 1.0, 2.5, 0.0, -1.0 })
    {
      CHECK_CASE(exaggeration);
      filter->SetExaggeration(exaggeration);
      const Relief relief = RelevoReadRelief(check, filter);
      CHECK(!relief.IsPerspective() && relief.GetDepthRange().x == 0.0);
      CHECK(relief.GetWidth() == size[0] && relief.GetHeight() == size[1]);
      for (int row = 0; row < size[1]; ++row)
      {
        for (int column = 0; column < size[0]; ++column)
        {
          const dvec3 expected(column + 0.5 - 0.5 * size[0], row + 0.5 - 0.5 * size[1],
            exaggeration * height(column, row));
          const dvec3 point = relief.GetWorldPoint(column, row, relief.GetTexelHeight(column, row));
          CHECK_LESS(distance(point, expected), 1e-4);
        }
      }
    }
  }
}

// Additional texels interpolate between samples, and finer imagery is used unchanged.
void TestTexels(RelevoCheck& check)
{
  const auto ramp = [](int column, int row) { return 8.0 * column + row; };
  vtkNew<vtkHeightMapToRelief> filter;
  const auto map = MakeMap(5, 4, [](int column, int) { return column == 4 ? -9999.0 : column; });
  map->SetNoDataValue(-9999.0);
  filter->SetHeightMap(map);
  filter->SetInputData(RelevoMakeImage(10, 8, VTK_UNSIGNED_CHAR, ramp));
  filter->SetTexelsPerSample(2);
  const Relief relief = RelevoReadRelief(check, filter);
  CHECK_EQUAL(relief.GetWidth(), 10);
  CHECK_EQUAL(relief.GetHeight(), 8);
  for (int column = 0; column < 10; ++column)
  {
    const dvec3 point = relief.GetWorldPoint(column, 3, relief.GetTexelHeight(column, 3));
    const dvec3 expected(0.5 * column + 0.25 - 2.5, -0.25, std::max(0.5 * column - 0.25, 0.0));
    CHECK(column > 7 ? point.z != point.z : column == 7 || distance(point, expected) < 1e-6);
    CHECK_EQUAL(relief.GetColors()[3 * (30 + column)], 8 * column + 3);
  }
  RelevoErrors errors(filter);
  filter->SetTexelsPerSample(65);
  CHECK(errors.Said("TexelsPerSample must be in [1, 64], got 65."));
  CHECK_EQUAL(filter->GetTexelsPerSample(), 2);

  // After an abort the output is empty, without an error.
  filter->AddObserver(
    vtkCommand::ProgressEvent, filter.Get(), &vtkHeightMapToRelief::AbortExecuteOn);
  filter->Modified();
  filter->Update();
  CHECK(errors.None() && filter->GetOutput()->GetNumberOfPoints() == 0);
}

void TestNormals(RelevoCheck& check)
{
  vtkNew<vtkHeightMapToRelief> filter;
  const auto map = MakeMap(7, 6,
    [](int column, int row)
    { return column == 3 && row == 3 ? -9999.0 : 0.5 * column - 0.25 * row; });
  map->SetNoDataValue(-9999.0);
  filter->SetHeightMap(map);
  const Relief relief = RelevoReadRelief(check, filter);
  const dvec3 up = normalize(dvec3(-0.5, 0.25, 1.0));
  for (vtkIdType i = 0; i < 42; ++i)
  {
    const float* n = relief.GetNormals() + 3 * i;
    const bool isHole = i == 24;
    CHECK_EQUAL(std::isnan(relief.GetDepths()[i]), isHole);
    CHECK_LESS(distance(dvec3(n[0], n[1], n[2]), isHole ? dvec3(0.0) : up), 1e-5);
  }
  filter->ComputeNormalsOff();
  CHECK(!RelevoReadRelief(check, filter).GetNormals());
}

// Without imagery the relief is grey. Imagery of the same size is unchanged, larger imagery
// averaged, smaller imagery interpolated.
void TestColors(RelevoCheck& check)
{
  vtkNew<vtkHeightMapToRelief> filter;
  filter->SetHeightMap(MakeMap(4, 2, [](int column, int) { return 10.0 * column; }));
  Relief relief = RelevoReadRelief(check, filter);
  const auto color = [&](int texel, int component) -> int
  { return relief.GetColors()[texel * relief.GetNumberOfColorComponents() + component]; };
  CHECK_EQUAL(color(0, 0), 64);
  CHECK_EQUAL(color(3, 1), 255);
  CHECK_EQUAL(color(7, 2), 255);

  const auto ramp = [](int column, int row) { return 10.0 * column + row; };
  filter->SetInputData(RelevoMakeImage(4, 2, VTK_UNSIGNED_CHAR, ramp, 3));
  relief = RelevoReadRelief(check, filter);
  CHECK_EQUAL(color(0, 0), 0);
  CHECK_EQUAL(color(3, 1), 30);
  CHECK_EQUAL(color(6, 2), 21);

  filter->SetInputData(RelevoMakeImage(16, 8, VTK_UNSIGNED_CHAR, ramp, 4));
  relief = RelevoReadRelief(check, filter);
  CHECK_EQUAL(relief.GetNumberOfColorComponents(), 4);
  CHECK_NEAR(color(0, 0), 15.0 + 1.5, 1.0); // the mean of columns 0 to 3 and rows 0 to 3
  CHECK_NEAR(color(7, 3), 135.0 + 5.5, 1.0);

  filter->SetInputData(RelevoMakeImage(2, 1, VTK_UNSIGNED_CHAR, ramp, 1));
  relief = RelevoReadRelief(check, filter);
  CHECK_EQUAL(color(0, 0), 0);
  CHECK_EQUAL(color(1, 0), 3);
  CHECK_EQUAL(color(2, 0), 8);
  CHECK_EQUAL(color(7, 0), 10);
}

void ExpectError(RelevoCheck& check, vtkHeightMapToRelief* filter, const char* words)
{
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  CHECK_EQUAL(filter->GetExecutive()->Update(), 0);
  CHECK(errors.Said(words));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetHeightMap(MakeMap(4, 2, [](int column, int) { return column; }));
  filter->SetInputConnection(nullptr);
  CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
  CHECK(errors.None() && filter->GetOutput()->GetNumberOfPoints() == 8);
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkHeightMapToRelief> filter;
  ExpectError(check, filter, "There is no height map: call SetHeightMap().");
  vtkNew<vtkHeightMap> none;
  {
    RelevoErrors errors(none);
    filter->SetHeightMap(none);
    ExpectError(check, filter, "The height map could not be read: There is neither a file name");
    none->SetFileName("nowhere.tif");
    filter->SetHeightMap(none);
    ExpectError(check, filter, "The height map could not be read: Cannot read nowhere.tif");
  }
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 3, 1);
  filter->SetInputData(bare);
  ExpectError(check, filter, "The imagery must have n x m x 1 points");
  vtkNew<vtkImageData> thick;
  thick->SetDimensions(4, 3, 2);
  thick->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  filter->SetInputData(thick);
  ExpectError(check, filter, "The imagery must have n x m x 1 points");
  filter->SetInputData(RelevoMakeImage(4, 3, VTK_INT, [](int, int) { return 0.0; }));
  ExpectError(check, filter, "Colours must have 1 to 4 components");
  CHECK(RelevoRefusesBlock(
    filter, 0, vtkNew<vtkPolyData>(), "The input is a vtkPolyData; a vtkImageData is needed."));
  RelevoErrors errors(filter);
  filter->SetExaggeration(1e39);
  CHECK(errors.Said("Exaggeration must be in") && filter->GetExaggeration() == 1.0);
}
}

int TestHeightMapToRelief(int, char*[])
{
  RelevoCheck check;
  TestPlaces(check);
  TestTexels(check);
  TestNormals(check);
  TestColors(check);
  TestErrors(check);
  return check.GetResult();
}
