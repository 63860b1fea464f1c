// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightMap promises heights from images of all types and layouts, updates after changes, and
// errors.
#include "RelevoCheck.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"

#include <iostream>
#include <limits>

namespace
{
vtkSmartPointer<vtkImageData> MakeImage(int type, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 6, -2, 0, 5, 5); // 4 x 3 x 1: the extent's origin has no effect
  image->AllocateScalars(type, components);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, j, j == 0 ? 100.0 + i : 1.0);
    }
  }
  return image;
}

bool HoldsTestImage(vtkHeightMap* map)
{
  bool same = map->Update() && map->GetDimensions()[0] == 4 && map->GetDimensions()[1] == 3;
  for (int j = 0; same && j < 3; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      same = same && map->GetSample(i, j) == 100.0 + 4 * j + i;
    }
  }
  return same && map->GetRange()[0] == 100.0 && map->GetRange()[1] == 111.0;
}

void TestTypes(RelevoCheck& check)
{
  for (int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    CHECK_CASE(type);
    for (int components : { 1, 3 })
    {
      CHECK_CASE(components);
      const auto image = MakeImage(type, components);
      vtkNew<vtkHeightMap> map;
      map->SetImageData(image);
      if (!CHECK(HoldsTestImage(map)))
      {
        std::cerr << "  for " << image->GetScalarTypeAsString() << "\n";
      }
    }
  }
}

// Heights come from the image and follow its changes.
void TestImage(RelevoCheck& check, vtkHeightMap* map)
{
  const auto image = MakeImage(VTK_DOUBLE, 1);
  map->SetImageData(image);
  CHECK(HoldsTestImage(map));
  CHECK_GREATER(map->GetSamplesMTime(), 0);
  CHECK_NEAR(map->GetHeight(0.5 / 4, 0.5 / 3), 100.0, 1e-3);
  CHECK_NEAR(map->GetHeight(0.5, 0.5), 105.5, 1e-3);

  const vtkMTimeType before = map->GetSamplesMTime();
  image->GetPointData()->GetScalars()->SetComponent(0, 0, -7.0);
  image->GetPointData()->GetScalars()->Modified();
  CHECK(map->Update() && map->GetSample(0, 0) == -7.0 && map->GetSamplesMTime() > before);

  // The array is a structure of arrays.
  vtkNew<vtkSOADataArrayTemplate<float>> soa;
  soa->SetNumberOfComponents(2);
  soa->SetNumberOfTuples(12);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    soa->SetTypedComponent(i, 0, 100.0f + i);
    soa->SetTypedComponent(i, 1, -1.0f);
  }
  image->GetPointData()->SetScalars(soa);
  CHECK(HoldsTestImage(map));
}

// Rows from the top give the same heights and validity as a copy with rows from the bottom. The
// last of two rows may have missing samples, the first or none.
void TestFlippedRows(RelevoCheck& check, bool isReduced)
{
  CHECK_CASE(isReduced);
  for (int missing : { -1, 2, 9 })
  {
    CHECK_CASE(missing);
    const auto given = MakeImage(VTK_FLOAT, 1);
    const auto copied = MakeImage(VTK_FLOAT, 1);
    if (missing >= 0)
    {
      given->GetPointData()->GetScalars()->SetComponent(missing, 0, -9999.0);
    }
    for (vtkIdType i = 0; i < 12; ++i)
    {
      copied->GetPointData()->GetScalars()->SetComponent(
        i, 0, given->GetPointData()->GetScalars()->GetComponent((2 - i / 4) * 4 + i % 4, 0));
    }
    vtkNew<vtkHeightMap> flipped;
    vtkNew<vtkHeightMap> expected;
    flipped->SetImageData(given);
    expected->SetImageData(copied);
    flipped->FlipRowsOn();
    for (vtkHeightMap* map : { flipped.Get(), expected.Get() })
    {
      map->SetNoDataValue(-9999.0);
      map->SetMaximumDimension(isReduced ? 2 : 0);
      CHECK(map->Update());
    }
    CHECK_EQUAL(flipped->HasNoData(), expected->HasNoData());
    CHECK_EQUAL(flipped->GetNumberOfSamples(), expected->GetNumberOfSamples());
    for (vtkIdType i = 0; i < expected->GetNumberOfSamples(); ++i)
    {
      CHECK_CASE(i);
      CHECK_EQUAL(flipped->GetSamples()[i], expected->GetSamples()[i]);
      if (expected->HasNoData() && flipped->HasNoData())
      {
        CHECK_EQUAL(flipped->GetValidity()[i], expected->GetValidity()[i]);
      }
    }
    flipped->FlipRowsOff();
    CHECK(flipped->Update());
    CHECK_EQUAL(flipped->GetSamples()[0] == expected->GetSamples()[0], false);
  }
}

void TestBlankedPoints(RelevoCheck& check, vtkHeightMap* map)
{
  const auto blanked = MakeImage(VTK_FLOAT, 1);
  blanked->AllocatePointGhostArray()->SetValue(5, vtkDataSetAttributes::HIDDENPOINT);
  map->SetImageData(blanked);
  CHECK(map->Update() && map->HasNoData() && !map->GetValidity()[5] && map->GetValidity()[4]);
  CHECK_NEAR(map->GetSample(1, 1), 105.0, 0.5);
}

// Images that cannot be height maps.
void TestUnfitImages(RelevoCheck& check, vtkHeightMap* map, RelevoErrors& errors)
{
  const auto hasNaN = MakeImage(VTK_DOUBLE, 1);
  hasNaN->GetPointData()->GetScalars()->SetComponent(
    6, 0, std::numeric_limits<double>::quiet_NaN());
  map->SetImageData(hasNaN);
  CHECK(!map->Update() &&
    errors.Said("1 of 12 heights are NaN or infinite, the first in column 2, row 1"));
  const auto tooLarge = MakeImage(VTK_DOUBLE, 1);
  tooLarge->GetPointData()->GetScalars()->SetComponent(6, 0, 1e300);
  map->SetImageData(tooLarge);
  CHECK(!map->Update() && errors.Said("infinite"));
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  map->SetImageData(volume);
  CHECK(!map->Update() && errors.Said("2 x 2 x 2 points, but n x m x 1 are needed"));
  vtkNew<vtkImageData> empty;
  map->SetImageData(empty);
  CHECK(!map->Update() && errors.Said("0 x 0 x 0"));
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(2, 2, 1);
  map->SetImageData(bare);
  CHECK(!map->Update() && errors.Said("no numeric point scalars"));
  vtkNew<vtkFloatArray> tooFew;
  tooFew->SetNumberOfTuples(3);
  bare->GetPointData()->SetScalars(tooFew);
  CHECK(!map->Update() && errors.Said("there are 3 tuples"));
}

// Without the image, the file is used again.
void TestFileInstead(RelevoCheck& check, vtkHeightMap* map, RelevoErrors& errors)
{
  map->SetImageData(nullptr);
  map->SetFileName("nowhere.tif");
  CHECK(!map->Update() && errors.Said("nowhere.tif"));
  CHECK(map->GetDimensions()[0] == 0 && map->GetRange()[1] == 0.0);
  CHECK_EQUAL(map->GetSample(0, 0), 0.0);
}
}

int TestHeightMapImage(int, char*[])
{
  RelevoCheck check;
  TestTypes(check);
  TestFlippedRows(check, false);
  TestFlippedRows(check, true);
  vtkNew<vtkHeightMap> map;
  RelevoErrors errors(map);
  CHECK(!map->Update());
  CHECK(errors.Said("neither a file name nor an image"));
  TestImage(check, map);
  TestBlankedPoints(check, map);
  TestUnfitImages(check, map, errors);
  TestFileInstead(check, map, errors);
  return check.GetResult();
}
