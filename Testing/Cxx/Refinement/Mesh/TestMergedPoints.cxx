// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that relevo::ComputeMergedPoints gives the lowest id of equal coordinates, compared with a
// map.
#include "RelevoCheck.h"

#include "Points/MergedPoints.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>

int TestMergedPoints(int, char*[])
{
  RelevoCheck check;
  CHECK(relevo::ComputeMergedPoints(nullptr).empty());
  vtkNew<vtkPoints> none;
  CHECK(relevo::ComputeMergedPoints(none).empty());

  for (int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    CHECK_CASE(type);
    vtkNew<vtkMinimalStandardRandomSequence> random;
    random->SetSeed(1);
    const auto next = [&random](double scale)
    {
      random->Next();
      return std::floor(scale * random->GetValue());
    };
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    std::map<std::array<double, 3>, vtkIdType> first;
    std::vector<vtkIdType> expected;
    for (vtkIdType id = 0; id < 20000; ++id)
    {
      const std::array<double, 3> x{ next(20), next(20) - 10, next(20) };
      points->InsertNextPoint(x.data());
      expected.push_back(first.emplace(x, id).first->second);
    }
    CHECK_EQUAL(relevo::ComputeMergedPoints(points), expected);
  }

  // Points that differ in the last bit are distinct, 0 equals -0, and NaN equals nothing.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(std::nextafter(1.0, 2.0), 0.0, 0.0);
  points->InsertNextPoint(nan, 0.0, 0.0);
  points->InsertNextPoint(nan, 0.0, 0.0);
  CHECK(relevo::ComputeMergedPoints(points).empty());
  points->InsertNextPoint(1.0, -0.0, 0.0);
  const std::vector<vtkIdType> expected{ 0, 1, 2, 3, 0 };
  CHECK_EQUAL(relevo::ComputeMergedPoints(points), expected);

  float tags[5] = { 1.0f, 2.0f, 3.0f, 4.0f, 5.0f };
  relevo::UniteTags(expected, tags);
  CHECK(tags[0] == 5.0f && tags[4] == 5.0f && tags[1] == 2.0f && tags[3] == 4.0f);
  return check.GetResult();
}
