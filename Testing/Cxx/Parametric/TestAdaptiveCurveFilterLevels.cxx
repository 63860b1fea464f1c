// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveFilter promises the number of segments of each curve, from arrays, from metrics
// at the control points, and from the recipe.
#include "RelevoCheck.h"
#include "RelevoCurves.h"

#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCellType.h"
#include "vtkDepthTagMetric.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
// The tag is the x coordinate, in half levels.
class TagsOfPlaces : public vtkDepthTagMetric
{
public:
  static TagsOfPlaces* New();
  vtkTypeMacro(TagsOfPlaces, vtkDepthTagMetric);
  bool IsViewDependent() override { return false; }
  bool ComputeTags(
    vtkPolyData* mesh, const relevo::RefinementView&, int, vtkFloatArray* tags) override
  {
    this->NumberOfPoints = mesh->GetNumberOfPoints();
    this->NumberOfLines = mesh->GetNumberOfLines();
    this->HasWeights = mesh->GetPointData()->GetRationalWeights() != nullptr;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      tags->InsertNextValue(static_cast<float>(0.5 * mesh->GetPoint(i)[0]));
    }
    return true;
  }

  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfLines = 0;
  bool HasWeights = false;
};
vtkStandardNewMacro(TagsOfPlaces);

// Two Bézier curves and a line, whose largest x are 5, 8 and 3.
vtkSmartPointer<vtkUnstructuredGrid> MakeCurves()
{
  auto grid = RelevoNewGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 5, 1, 0 } }, { { 8, 2, 0 } },
    { { 2, 3, 1 } }, { { 3, 3, 3 } } });
  const std::array<vtkIdType, 3> first{ 0, 1, 2 };
  const std::array<vtkIdType, 4> second{ 1, 4, 3, 2 };
  const std::array<vtkIdType, 2> line{ 4, 5 };
  grid->InsertNextCell(VTK_BEZIER_CURVE, 3, first.data());
  grid->InsertNextCell(VTK_BEZIER_CURVE, 4, second.data());
  grid->InsertNextCell(VTK_LINE, 2, line.data());
  return grid;
}

std::array<int, 3> CountSegments(vtkAdaptiveCurveFilter* filter)
{
  filter->Update();
  std::array<int, 3> segments{};
  for (int i = 0; i < 3 && i < filter->GetOutput()->GetNumberOfCells(); ++i)
  {
    segments[i] = static_cast<int>(RelevoGetCellPoints(filter->GetOutput(), i).size()) - 1;
  }
  return segments;
}

void TestMetric(RelevoCheck& check)
{
  auto grid = MakeCurves();
  auto filter = RelevoNewCurveFilter(grid, 3);
  vtkAdaptiveRefinement* recipe = filter->GetRefinement();
  CHECK((CountSegments(filter) == std::array<int, 3>{ 8, 8, 8 }));
  vtkNew<TagsOfPlaces> metric;
  recipe->SetMetric(metric);
  // The tags 2.5, 4 and 1.5 are rounded half up and limited to 3.
  CHECK((CountSegments(filter) == std::array<int, 3>{ 8, 8, 4 }));
  CHECK(metric->NumberOfPoints == 9 && metric->NumberOfLines == 3 && !metric->HasWeights);
  recipe->SetMaximumLevel(7);
  CHECK((CountSegments(filter) == std::array<int, 3>{ 8, 16, 4 }));
  recipe->SetLevelOffset(-1.25);
  CHECK((CountSegments(filter) == std::array<int, 3>{ 2, 8, 1 }));
  // 2^1.25 = 2.38, 2^2.75 = 6.73, 2^0.25 = 1.19.
  recipe->SetSegmentPolicyToWholeNumbers();
  CHECK((CountSegments(filter) == std::array<int, 3>{ 2, 7, 1 }));
  // 2^4.7 = 26.0, 2^6.2 = 73.5 (rounded to a multiple of 8), 2^3.7 = 13.0.
  recipe->SetLevelOffset(2.2);
  CHECK((CountSegments(filter) == std::array<int, 3>{ 26, 72, 13 }));
}

void TestArray(RelevoCheck& check)
{
  auto grid = MakeCurves();
  vtkNew<vtkFloatArray> tags;
  tags->SetName("Tags");
  for (float tag : { 0.0f, 3.0f, 2.0f, 7.0f, 1.0f, 4.0f })
  {
    tags->InsertNextValue(tag);
  }
  grid->GetPointData()->AddArray(tags);
  auto filter = RelevoNewCurveFilter(grid, 4);
  vtkNew<TagsOfPlaces> metric;
  filter->GetRefinement()->SetMetric(metric);
  filter->GetRefinement()->SetDepthTagArrayName("Tags");
  // The means of both ends, which VTK stores first: 1.5, 2 and 2.5.
  const std::array<int, 3> segments = CountSegments(filter);
  CHECK((segments == std::array<int, 3>{ 4, 4, 8 }));
  CHECK_EQUAL(metric->NumberOfPoints, 0);

  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  tags->SetValue(4, std::numeric_limits<float>::quiet_NaN());
  tags->Modified();
  grid->Modified();
  filter->Update();
  CHECK(errors.Said("point array \"Tags\" of depth-tags is NaN at point 4"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// The camera is in the input's coordinates.
void TestTimes(RelevoCheck& check)
{
  auto filter = RelevoNewCurveFilter(MakeCurves(), 2);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkMatrix4x4> matrix;
  filter->SetCamera(camera);
  filter->SetModelToWorld(matrix);
  const vtkMTimeType time = filter->GetMTime();
  camera->SetPosition(1.0, 2.0, 3.0);
  matrix->SetElement(0, 3, 2.0);
  CHECK_EQUAL(filter->GetMTime(), time);
  filter->SetRepresentationToRibbons();
  const vtkMTimeType later = filter->GetMTime();
  camera->SetPosition(3.0, 2.0, 1.0);
  CHECK_GREATER(filter->GetMTime(), later);
  filter->GetRefinement()->SetMaximumLevel(1);
  CHECK_EQUAL(filter->GetMTime(), filter->GetRefinement()->GetMTime());
}
}

int TestAdaptiveCurveFilterLevels(int, char*[])
{
  RelevoCheck check;
  TestMetric(check);
  TestArray(check);
  TestTimes(check);
  return check.GetResult();
}
