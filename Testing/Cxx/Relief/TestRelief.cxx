// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves where the texels of a relief lie, where its surface is open, and which images are errors.
#include "Data/Relief.h"
#include "Data/ReliefSides.h"
#include "RelevoCheck.h"
#include "RelevoReliefs.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

namespace
{
using relevo::dmat4;
using relevo::dvec3;
using relevo::dvec4;
using relevo::Relief;
using relevo::ReliefProjection;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

dmat4 GetShear()
{
  dmat4 matrix(1.0);
  matrix[0] = dvec4(2.0, 0.5, 0.0, 0.0);
  matrix[2] = dvec4(0.25, 0.0, -3.0, 0.0);
  matrix[3] = dvec4(10.0, 20.0, 30.0, 1.0);
  return matrix;
}

void TestPlaces(RelevoCheck& check)
{
  const auto depth = [](int column, int row) { return 1.0 + column + 0.5 * row; };
  const dmat4 matrix = GetShear();
  for (ReliefProjection projection : { ReliefProjection::Parallel, ReliefProjection::Perspective })
  {
    Relief relief;
    CHECK(relief.Read(RelevoMakeRelief(4, 3, projection, matrix, depth)).empty());
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        const double d = depth(column, row);
        const dvec4 place =
          relief.IsPerspective() ? dvec4(column * d, row * d, d, 1.0) : dvec4(column, row, d, 1.0);
        const dvec3 expected(matrix * place);
        const double height = relief.GetTexelHeight(column, row);
        const dvec3 point = relief.GetWorldPoint(column, row, height);
        CHECK_LESS(distance(point, expected), 1e-12);
        const dvec4 back = relief.GetWorldToTexel() * dvec4(expected, 1.0);
        CHECK_LESS(distance(dvec3(back) / back.w, dvec3(column, row, height)), 1e-12);
      }
    }
    CHECK_EQUAL(relief.GetDepthRange(), relevo::dvec2(1.0, 5.0));
    CHECK_EQUAL(relief.GetPlane(), (relief.IsPerspective() ? 1.0 : 0.0));
  }
}

void TestSides(RelevoCheck& check)
{
  // Depth steps by 6 between columns 1 and 2, and texels are 2 wide, so the surface is open for a
  // limit of 3.5 texels.
  dmat4 matrix(1.0);
  matrix[0][0] = 2.0;
  matrix[1][1] = 2.0;
  const auto step = [](int column, int row)
  { return column == 0 && row == 0 ? NaN : (column < 2 ? 0.0 : 6.0); };
  Relief relief;
  CHECK(relief.Read(RelevoMakeRelief(4, 3, ReliefProjection::Parallel, matrix, step)).empty());
  const double stretch = std::sqrt(1.0 + 9.0);
  for (double factor : { 0.99, 1.01 })
  {
    CHECK_CASE(factor);
    const std::vector<unsigned char> sides = relevo::FindReliefSides(relief, factor * stretch);
    const unsigned char up = relevo::UpperSide;
    const unsigned char all = up | relevo::RightSide | relevo::Quad;
    CHECK_EQUAL(sides[0], 0);
    CHECK_EQUAL(sides[1], (factor > 1.0 ? all : up));
    CHECK_EQUAL(sides[2], all);
    CHECK_EQUAL(sides[3], up);
    CHECK_EQUAL(sides[4], all);
    CHECK_EQUAL(sides[5], (factor > 1.0 ? all : up));
    CHECK_EQUAL(sides[11], 0);
  }
}

// In perspective, a wall whose depth grows by a fixed share per texel is stretched equally
// everywhere.
void TestPerspectiveSides(RelevoCheck& check)
{
  const dmat4 pinhole = RelevoPinhole(64, 2, 0.01);
  for (double distance : { 1.0, 1000.0 })
  {
    const auto step = [=](int column, int) { return column < 32 ? distance : 1.05 * distance; };
    Relief relief;
    CHECK(
      relief.Read(RelevoMakeRelief(64, 2, ReliefProjection::Perspective, pinhole, step)).empty());
    // The step is 0.05 in depth and 0.01 sideways, about 5 texels.
    CHECK_EQUAL((relevo::FindReliefSides(relief, 4.9)[31] & relevo::RightSide), 0);
    CHECK_NOT_EQUAL((relevo::FindReliefSides(relief, 5.3)[31] & relevo::RightSide), 0);
  }
}

vtkSmartPointer<vtkImageData> MakeFlat(ReliefProjection projection = ReliefProjection::Parallel)
{
  return RelevoMakeRelief(3, 2, projection, dmat4(1.0), [](int, int) { return 1.0; });
}

void TestErrors(RelevoCheck& check)
{
  const auto isRefused = [](vtkImageData* image, const char* word)
  { return Relief().Read(image).find(word) != std::string::npos; };
  CHECK(isRefused(nullptr, "no image"));
  CHECK(isRefused(vtkNew<vtkImageData>(), "0 x 0 x 0"));
  for (const char* name : { "Color", "Depth" })
  {
    CHECK_CASE(name);
    const auto image = MakeFlat();
    image->GetPointData()->RemoveArray(name);
    CHECK(isRefused(image, name));
  }
  for (const char* name : { "ReliefProjection", "ReliefMatrix" })
  {
    CHECK_CASE(name);
    const auto image = MakeFlat();
    image->GetFieldData()->RemoveArray(name);
    CHECK(isRefused(image, name));
  }
  auto image = MakeFlat();
  image->GetPointData()->GetArray("Depth")->SetNumberOfTuples(5);
  CHECK(isRefused(image, "Depth"));
  image = MakeFlat();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  image->GetPointData()->AddArray(normals);
  CHECK(isRefused(image, "Normals"));
  image = MakeFlat();
  image->GetFieldData()->GetArray("ReliefMatrix")->SetComponent(0, 0, 0.0);
  CHECK(Relief().Read(MakeFlat()).empty());
  CHECK(isRefused(image, "singular"));
  image->GetFieldData()->GetArray("ReliefMatrix")->SetComponent(0, 0, 1e-12);
  CHECK(Relief().Read(image).empty()); // small, but not singular
  image = MakeFlat();
  image->GetPointData()->GetArray("Depth")->Fill(NaN);
  CHECK(isRefused(image, "finite"));
  image = MakeFlat(ReliefProjection::Perspective);
  image->GetPointData()->GetArray("Depth")->SetComponent(2, 0, 0.0);
  CHECK(isRefused(image, "more than 0"));
}
}

int TestRelief(int, char*[])
{
  RelevoCheck check;
  TestPlaces(check);
  TestSides(check);
  TestPerspectiveSides(check);
  TestErrors(check);
  return check.GetResult();
}
