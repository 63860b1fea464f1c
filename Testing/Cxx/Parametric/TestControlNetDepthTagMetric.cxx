// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkControlNetDepthTagMetric promises levels by the angles of control nets.
// vtkDistanceDepthTagMetric uses control points as well.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkControlNetDepthTagMetric.h"
#include "vtkDepthTagFilter.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <functional>
#include <vector>

namespace
{
std::vector<double> GetTags(vtkPolyData* mesh, vtkDepthTagMetric* metric, vtkCamera* camera)
{
  vtkNew<vtkDepthTagFilter> filter;
  RelevoErrors errors(filter);
  RelevoErrors ofExecutive(filter->GetExecutive());
  filter->SetInputData(mesh);
  filter->SetMetric(metric);
  filter->SetCamera(camera);
  filter->SetMaximumLevel(6);
  filter->Update();
  std::vector<double> tags;
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray("DepthTag");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    tags.push_back(array->GetComponent(i, 0));
  }
  return tags;
}

bool AreAll(const std::vector<double>& tags, double level)
{
  for (double tag : tags)
  {
    if (!(std::abs(tag - level) < 1e-4))
    {
      return false;
    }
  }
  return !tags.empty();
}

// One patch whose control points, evenly spaced in the unit square, have z = f(x, y).
vtkSmartPointer<vtkPolyData> MakePatch(
  int type, int degree, const std::function<double(double, double)>& f)
{
  auto mesh = RelevoMakePatches(RelevoNewCell(type, { { degree, degree, 1 } }, 0.0));
  vtkDataArray* points = mesh->GetFieldData()->GetArray("PatchPoints");
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    points->SetComponent(i, 2, f(points->GetComponent(i, 0), points->GetComponent(i, 1)));
  }
  return mesh;
}

void TestAngles(RelevoCheck& check)
{
  vtkNew<vtkControlNetDepthTagMetric> metric;
  CHECK(!metric->IsViewDependent() && !metric->IsAbsolute());
  const auto flat = [](double x, double y) { return x + y; };
  // A roof whose sides slope by 45 degrees and meet at a right angle.
  const auto roof = [](double x, double) { return std::abs(x - 0.5); };
  for (const int type : { VTK_BEZIER_QUADRILATERAL, VTK_BEZIER_TRIANGLE })
  {
    CHECK_CASE(type);
    const auto even = MakePatch(type, 4, flat);
    CHECK(AreAll(GetTags(even, metric, nullptr), 0.0));
    const auto bent = MakePatch(type, 4, roof);
    metric->SetMaximumAngle(180.0);
    CHECK(AreAll(GetTags(bent, metric, nullptr), 3.0));
    metric->SetMinimumAngle(60.0);
    CHECK(AreAll(GetTags(bent, metric, nullptr), 1.5));
    metric->SetMinimumAngle(100.0);
    CHECK(AreAll(GetTags(bent, metric, nullptr), 0.0));
    metric->SetMinimumAngle(0.0);
    metric->SetMaximumAngle(80.0);
    CHECK(AreAll(GetTags(bent, metric, nullptr), 6.0));
  }
  // Quads without area are ignored; the others still meet at a right angle.
  const auto worn = MakePatch(VTK_BEZIER_QUADRILATERAL, 4, roof);
  vtkDataArray* points = worn->GetFieldData()->GetArray("PatchPoints");
  for (const vtkIdType i : { 1, 5, 6 })
  {
    points->SetTuple(i, points->GetTuple4(0));
  }
  CHECK(AreAll(GetTags(worn, metric, nullptr), 6.0));
}

void TestDistances(RelevoCheck& check)
{
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(8.0);
  metric->SetMeasureToControlPoints();
  CHECK_EQUAL(std::string(metric->GetMeasureAsString()), "ControlPoints");
  // A single control point comes within 2 of the camera. The patch does not reach it.
  const auto peak = [](double x, double y) { return x == 0.5 && y == 0.5 ? 3.0 : 0.0; };
  const auto patch = MakePatch(VTK_BEZIER_QUADRILATERAL, 4, peak);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.5, 0.5, 5.0);
  camera->SetFocalPoint(0.5, 0.5, 0.0);
  CHECK(AreAll(GetTags(patch, metric, camera), 6.0 * (1.0 - 2.0 / 8.0)));
  metric->SetMeasureToVertices();
  CHECK_LESS(GetTags(patch, metric, camera)[0], 6.0 * (1.0 - 5.0 / 8.0));
  // The points of a line are control points.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 0.5, 3.0);
  points->InsertNextPoint(0.5, 0.5, 1.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  metric->SetMeasureToControlPoints();
  const std::vector<double> tags = GetTags(line, metric, camera);
  CHECK_NEAR(tags.at(0), 4.5, 1e-4);
  CHECK_NEAR(tags.at(1), 3.0, 1e-4);
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkCamera> camera;
  vtkNew<vtkControlNetDepthTagMetric> nets;
  RelevoErrors ofNets(nets);
  GetTags(sphere->GetOutput(), nets, camera);
  CHECK(ofNets.Said("Cannot measure the control nets: there is no array Patches"));
  nets->SetMinimumAngle(100.0);
  GetTags(sphere->GetOutput(), nets, camera);
  CHECK(ofNets.Said("MinimumAngle 100 is above MaximumAngle 90."));
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMeasureToControlPoints();
  RelevoErrors ofDistance(distance);
  GetTags(sphere->GetOutput(), distance, camera);
  CHECK(ofDistance.Said("Cannot measure distances to control points: there is no array Patches"));
}

// Arrays of wrong sizes are not read.
void TestArrays(RelevoCheck& check)
{
  vtkNew<vtkControlNetDepthTagMetric> metric;
  RelevoErrors errors(metric);
  const auto spoil =
    [&](const char* name, vtkIdType tuple, int component, double value, const char* words)
  {
    const auto mesh = MakePatch(VTK_BEZIER_QUADRILATERAL, 2, [](double, double) { return 0.0; });
    vtkDataArray* array = mesh->GetFieldData()->GetArray(name);
    array = array ? array : mesh->GetCellData()->GetArray(name);
    array->SetComponent(tuple, component, value);
    GetTags(mesh, metric, nullptr);
    if (!errors.Said(words))
    {
      check.Fail(__FILE__, __LINE__, std::string("no error with: ") + words);
    }
  };
  spoil("Patches", 0, 0, VTK_QUAD, "patch 0 is neither");
  spoil("Patches", 0, 1, 9, "patch 0 has a degree");
  spoil("Patches", 0, 2, 0, "patch 0 has a degree");
  spoil("Patches", 0, 3, 1, "patch 0 refers to control points that do not exist");
  spoil("Patches", 0, 3, -1, "patch 0 refers to control points that do not exist");
  spoil("PatchPoints", 8, 2, std::nan(""), "control point 8 is not finite");
  spoil("PatchPoints", 0, 3, -1.0, "control point 0 is not finite, or its weight");
  spoil("PatchIds", 1, 0, 1, "triangle 1 refers to a patch that does not exist");
  spoil("PatchIds", 1, 0, -1, "triangle 1 refers to a patch that does not exist");
  spoil("PatchCoordinates", 0, 3, 1.5, "triangle 0 has PatchCoordinates");
  spoil("PatchCoordinates", 0, 3, std::nan(""), "triangle 0 has PatchCoordinates");
  const auto mesh = MakePatch(VTK_BEZIER_QUADRILATERAL, 2, [](double, double) { return 0.0; });
  mesh->GetCellData()->GetArray("PatchIds")->SetNumberOfTuples(1);
  GetTags(mesh, metric, nullptr);
  CHECK(
    errors.Said("the array PatchIds has 1 tuples of 1 components, but 2 tuples of 1 are needed"));
  const auto other = MakePatch(VTK_BEZIER_QUADRILATERAL, 2, [](double, double) { return 0.0; });
  vtkNew<vtkIntArray> borders;
  borders->SetName("PatchInnerBorders");
  borders->SetNumberOfTuples(2);
  other->GetFieldData()->AddArray(borders);
  GetTags(other, metric, nullptr);
  CHECK(errors.Said(
    "the array PatchInnerBorders has 2 tuples of 1 components, but 1 tuples of 1 are needed"));
}
}

int TestControlNetDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestAngles(check);
  TestDistances(check);
  TestErrors(check);
  TestArrays(check);
  return check.GetResult();
}
