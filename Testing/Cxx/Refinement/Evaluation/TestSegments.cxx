// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinement promises the number of segments of an edge for both policies, with an
// offset, and for levels per point or per edge.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Evaluation/PatternSelection.h"
#include "Patterns/PatternLibrary.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDepthTagFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkRefinementPatternTable.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"

#include <cmath>

namespace
{
using namespace RelevoMeshes;

Mesh MakeTriangle(double tagA, double tagB, double tagC)
{
  Mesh triangle =
    FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }, { { { 0, 1, 2 } } });
  vtkNew<vtkFloatArray> tags;
  tags->SetName("DepthTag");
  for (double tag : { tagA, tagB, tagC })
  {
    tags->InsertNextValue(static_cast<float>(tag));
  }
  triangle->GetPointData()->AddArray(tags);
  return triangle;
}

// Segments of the edge from (0, 0) to (1, 0).
int CountSegments(vtkPolyData* refined)
{
  int points = 0;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    points += refined->GetPoint(i)[1] == 0.0 ? 1 : 0;
  }
  return points - 1;
}

double GetArea(vtkPolyData* mesh)
{
  double area = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const vtkIdType* ids;
    vtkIdType size;
    mesh->GetCellPoints(cell, size, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids[i], p[i]);
    }
    area +=
      0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
  }
  return area;
}

// 2^tag, rounded half up to the nearest number that the policy allows.
int GetWholeNumber(double tag)
{
  const double wanted = std::exp2(tag);
  int factor = 1;
  while (wanted > 16.0 * factor)
  {
    factor *= 2;
  }
  return factor * static_cast<int>(std::floor(wanted / factor + 0.5));
}

void TestWholeNumbers(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(7);
  recipe->SetSegmentPolicyToWholeNumbers();
  int last = 1;
  for (double tag = 0.003; tag < 7.2; tag += 0.0371)
  {
    Mesh refined = Refine(MakeTriangle(tag, tag, 0.0), recipe);
    const int segments = CountSegments(refined);
    CHECK_EQUAL(segments, GetWholeNumber(std::min(tag, 7.0)));
    CHECK_GREATER_EQUAL(segments, last);
    last = segments;
    CHECK_NEAR(GetArea(refined), 0.5, 1e-6);
  }
  CHECK_EQUAL(last, 128);
  // Both policies agree for whole levels.
  for (int level = 0; level <= 7; ++level)
  {
    CHECK(CountSegments(Refine(MakeTriangle(level, level, 1.0), recipe)) == 1 << level);
  }
  recipe->SetMaximumLevel(3);
  CHECK_EQUAL(CountSegments(Refine(MakeTriangle(9.0, 2.4, 0.0), recipe)), 8);
}

void TestOffset(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(6);
  for (double offset : { -16.0, -1.5, -0.25, 0.0, 0.25, 1.0, 3.75, 16.0 })
  {
    CHECK_CASE(offset);
    recipe->SetLevelOffset(offset);
    for (double tag : { 0.0, 1.25, 2.5, 4.75 })
    {
      CHECK_CASE(tag);
      const double level = std::floor(std::min(std::max(tag + offset, 0.0), 6.0) + 0.5);
      CHECK(
        CountSegments(Refine(MakeTriangle(tag, tag, 2.0), recipe)) == 1 << static_cast<int>(level));
    }
  }
}

// The filter creates as many triangles per cell as the patterns for the levels of vtkDepthTagFilter
// have.
void TestRules(RelevoCheck& check)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.9, 0.7, 1.4);
  vtkNew<vtkScreenEdgeDepthTagMetric> screen;
  vtkNew<vtkSilhouetteDepthTagMetric> contour;
  contour->SetCriterionToContour();
  vtkIdType counts[2] = { 0, 0 };
  for (Mesh mesh : { Sphere(9, 8), Explode(Sphere(7, 9)), NonManifold(), Moebius() })
  {
    for (vtkDepthTagMetric* metric :
      { static_cast<vtkDepthTagMetric*>(screen), static_cast<vtkDepthTagMetric*>(contour) })
    {
      for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
      {
        CHECK_CASE(rule);
        vtkNew<vtkDepthTagFilter> tags;
        tags->SetMaximumLevel(5);
        tags->SetInputData(mesh);
        tags->SetMetric(metric);
        tags->SetCamera(camera);
        tags->SetLevelRule(rule);
        tags->Update();
        auto* levels = vtkIntArray::SafeDownCast(
          tags->GetOutput()->GetCellData()->GetAbstractArray("EdgeLevels"));

        vtkNew<vtkAdaptiveRefinement> recipe;
        recipe->SetMaximumLevel(5);
        recipe->SetMetric(metric);
        recipe->SetLevelRule(rule);
        recipe->GeomorphingOff();
        vtkNew<vtkAdaptiveRefinementFilter> filter;
        filter->SetInputData(mesh);
        filter->SetRefinement(recipe);
        filter->SetCamera(camera);
        filter->Update();
        auto* cells = vtkIdTypeArray::SafeDownCast(
          filter->GetOutput()->GetCellData()->GetAbstractArray("vtkOriginalCellIds"));
        std::vector<vtkIdType> triangles(static_cast<size_t>(mesh->GetNumberOfCells()), 0);
        for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
        {
          ++triangles[static_cast<size_t>(cells->GetValue(i))];
        }
        vtkNew<vtkPolyData> pattern;
        for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
        {
          int l[3];
          levels->GetTypedTuple(cell, l);
          CHECK(recipe->GetPatternTable()->GetPattern(l[0], l[1], l[2], pattern));
          CHECK_EQUAL(triangles[static_cast<size_t>(cell)], pattern->GetNumberOfPolys());
        }
        counts[rule] += filter->GetOutput()->GetNumberOfPolys();
      }
    }
  }
  // A point takes the largest level of its edges, so levels per edge need fewer triangles.
  CHECK_LESS(counts[vtkDepthTagMetric::PER_EDGE], counts[vtkDepthTagMetric::PER_VERTEX]);
}

void TestSettings(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  RelevoErrors errors(recipe);
  recipe->SetLevelRule(2);
  CHECK(errors.Said("LevelRule must be one of PER_VERTEX (0), PER_EDGE (1)"));
  recipe->SetSegmentPolicy(-1);
  CHECK(errors.Said("SegmentPolicy must be one of POWERS_OF_TWO (0), WHOLE_NUMBERS (1)"));
  recipe->SetGeomorphing(3);
  CHECK(errors.Said(", GEOMORPHING_AUTOMATIC (2), got"));
  recipe->SetLevelOffset(vtkMath::Nan());
  CHECK(errors.Said("LevelOffset must be in [-16, 16]"));
  CHECK_EQUAL(recipe->GetLevelRule(), vtkDepthTagMetric::PER_VERTEX);
  CHECK_EQUAL(recipe->GetSegmentPolicy(), vtkAdaptiveRefinement::POWERS_OF_TWO);
  CHECK_EQUAL(recipe->GetGeomorphing(), vtkAdaptiveRefinement::GEOMORPHING_AUTOMATIC);
  CHECK_EQUAL(recipe->GetLevelOffset(), 0.0);
}

// A face's pattern has the segments of its sorted edges, for every order of its corners.
void TestFacePatterns(RelevoCheck& check)
{
  vtkNew<vtkRefinementPatternTable> table;
  using Library = relevo::PatternLibrary;
  for (const auto kind : { Library::POWERS_OF_TWO, Library::NESTED, Library::WHOLE_NUMBERS })
  {
    const auto family = table->GetLibrary()->GetFamily(kind);
    size_t wrong = 0;
    for (int i = 0; i < 6 * 4 * 4 * 4; ++i)
    {
      const int steps[3] = { i % 4, i / 4 % 4, i / 16 % 4 };
      const unsigned int entry = family->GetEntry(i / 64, steps[0], steps[1], steps[2]);
      const int key = static_cast<int>(entry >> 3);
      const auto kept = family->GetPattern(key);
      const relevo::FacePattern pattern = { kept.get(), static_cast<int>(entry & 7u),
        relevo::PatternFamily::IsMirrored(key), nullptr };
      int segments[3];
      pattern.GetEdgeSegments(segments);
      for (int e = 0; e < 3; ++e)
      {
        wrong += segments[e] != family->GetSegmentSteps().GetSegments(steps[e]) ? 1 : 0;
      }
    }
    CHECK_EQUAL(wrong, 0);
  }
}
}

int TestSegments(int, char*[])
{
  RelevoCheck check;
  TestWholeNumbers(check);
  TestOffset(check);
  TestRules(check);
  TestSettings(check);
  TestFacePatterns(check);
  return check.GetResult();
}
