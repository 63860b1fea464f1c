// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthTagFilter promises arrays of depth-tags and edge levels (compared with values computed by
// hand), unchanged other data, updates after changes only, and errors.
#include "RelevoCheck.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDepthTagFilter.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

namespace
{
vtkSmartPointer<vtkPolyData> MakeMesh(std::initializer_list<std::vector<double>> coordinates,
  std::initializer_list<std::vector<vtkIdType>> polygons)
{
  vtkNew<vtkPoints> points;
  for (const auto& x : coordinates)
  {
    points->InsertNextPoint(x.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeTriangle()
{
  return MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
}

void SetTags(vtkPolyData* mesh, std::initializer_list<float> values)
{
  vtkNew<vtkFloatArray> tags;
  tags->SetName("DepthTag");
  for (float value : values)
  {
    tags->InsertNextValue(value);
  }
  mesh->GetPointData()->AddArray(tags);
}

vtkFloatArray* Tags(vtkDepthTagFilter* filter)
{
  return vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("DepthTag"));
}

vtkIntArray* Levels(vtkDepthTagFilter* filter)
{
  return vtkIntArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("EdgeLevels"));
}

bool IsEmpty(vtkDepthTagFilter* filter)
{
  return filter->GetOutput()->GetNumberOfPoints() == 0 &&
    filter->GetOutput()->GetNumberOfCells() == 0 &&
    filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0;
}

bool HasLevels(vtkDepthTagFilter* filter, vtkIdType cell, int first, int second, int third)
{
  const int* levels = Levels(filter)->GetPointer(3 * cell);
  return levels[0] == first && levels[1] == second && levels[2] == third;
}

void TestEdgeRule(RelevoCheck& check)
{
  // The means 0.5, 1.5 and 1 are rounded half up to 1, 2 and 1. The edges are P1P2, P2P3 and P3P1.
  auto mesh =
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 2, 1, 3 } });
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetInputData(mesh);
  filter->SetMaximumLevel(7);
  SetTags(mesh, { 0.0f, 1.0f, 2.0f, 7.0f });
  filter->Update();
  CHECK(HasLevels(filter, 0, 1, 2, 1));
  CHECK(HasLevels(filter, 1, 2, 4, 5)); // means 1.5, 4 and 4.5
  // Both triangles give the shared edge the same level.
  CHECK_EQUAL(Levels(filter)->GetValue(1), Levels(filter)->GetValue(3));

  // The largest float below 0.5 is rounded down.
  const float below = std::nextafter(0.5f, 0.0f);
  SetTags(mesh, { below, below, below, 3.0f });
  filter->Update();
  CHECK(HasLevels(filter, 0, 0, 0, 0));
  CHECK(HasLevels(filter, 1, 0, 2, 2));

  // Only the mean is clamped to [0, MaximumLevel]. Your own tags may exceed this range.
  filter->SetMaximumLevel(3);
  SetTags(mesh, { -2.0f, 6.0f, 8.0f, -3.0f });
  filter->Update();
  CHECK_EQUAL(Tags(filter)->GetValue(0), -2.0f);
  CHECK_EQUAL(Tags(filter)->GetValue(2), 8.0f);
  CHECK(HasLevels(filter, 0, 2, 3, 3));
  CHECK(HasLevels(filter, 1, 3, 2, 3)); // means 7, 1.5 and 2.5
  const float infinity = std::numeric_limits<float>::infinity();
  SetTags(mesh, { -infinity, -2.0f, infinity, 3e38f });
  filter->Update();
  CHECK(HasLevels(filter, 0, 0, 3, 0));
  CHECK(HasLevels(filter, 1, 3, 3, 3));

  // Coincident points share the larger of their tags.
  auto split =
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { -0.0, 1, 0 }, { 1, 1, 0 } },
      { { 0, 1, 2 }, { 4, 3, 5 } });
  SetTags(split, { 0.0f, 3.0f, 1.0f, 1.0f, 2.0f, 0.0f });
  filter->SetInputData(split);
  filter->Update();
  for (int id : { 1, 3 })
  {
    CHECK_CASE(id);
    CHECK_EQUAL(Tags(filter)->GetValue(id), 3.0f);
    CHECK_EQUAL(Tags(filter)->GetValue(id + 1), 2.0f);
  }
  CHECK(HasLevels(filter, 0, 2, 3, 1));
  CHECK(HasLevels(filter, 1, 3, 2, 1));
}

void TestLevelRule(RelevoCheck& check)
{
  // One unit covers 100 pixels. The edges of length 0.8, 1 and 0.6 give 3, 3.32 and 2.58 levels.
  auto mesh = MakeMesh({ { 0, 0, 0 }, { 0.8, 0, 0 }, { 0, 0.6, 0 }, { 0, 0.6, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 3, 2 } });
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 2);
  camera->SetViewAngle(90);
  camera->SetClippingRange(0.1, 10.0);
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetMaximumLevel(5);
  filter->SetInputData(mesh);
  filter->SetMetric(metric);
  filter->SetCamera(camera);
  filter->SetViewportSize(400, 400);
  CHECK_EQUAL(filter->GetLevelRule(), vtkDepthTagMetric::PER_VERTEX);
  metric->SetReferenceLength(7.5); // adds 0.42 levels
  filter->Update();
  CHECK(HasLevels(filter, 0, 4, 4, 4)); // tags 3.42, 3.74 and 3.74
  filter->SetLevelRuleToPerEdge();
  filter->Update();
  CHECK(HasLevels(filter, 0, 3, 4, 3));
  CHECK(HasLevels(filter, 1, 3, 3, 4));
  CHECK(HasLevels(filter, 2, 0, 0, 0));
  CHECK_NEAR(Tags(filter)->GetValue(0), std::log2(80 / 7.5), 1e-5);

  // An array of your own has one tag per point, so levels per edge do not apply.
  SetTags(mesh, { 1.0f, 3.0f, 5.0f, 5.0f });
  filter->SetMetric(nullptr);
  filter->Update();
  CHECK(HasLevels(filter, 0, 2, 4, 3));

  RelevoErrors errors(filter);
  filter->SetLevelRule(2);
  CHECK(errors.Said("LevelRule") && filter->GetLevelRule() == vtkDepthTagMetric::PER_EDGE);
}

void TestPassThrough(RelevoCheck& check)
{
  auto mesh = MakeMesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 3, 2 }, { 0, 1, 2 }, { 3 } });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 1, 2 });
  mesh->SetVerts(verts);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  mesh->SetLines(lines);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  mesh->SetStrips(strips);
  vtkNew<vtkFloatArray> temperature;
  temperature->SetName("Temperature");
  temperature->SetNumberOfTuples(4);
  temperature->FillValue(20.0f);
  mesh->GetPointData()->SetScalars(temperature);
  vtkNew<vtkIntArray> material;
  material->SetName("Material");
  material->SetNumberOfTuples(mesh->GetNumberOfCells());
  material->FillValue(3);
  mesh->GetCellData()->AddArray(material);
  vtkNew<vtkIntArray> field;
  field->SetName("Field");
  mesh->GetFieldData()->AddArray(field);

  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(2.0);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 0);
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetInputData(mesh);
  filter->SetMetric(metric);
  filter->SetCamera(camera);
  filter->SetMaximumLevel(4);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetPoints(), mesh->GetPoints());
  CHECK_EQUAL(output->GetPolys(), mesh->GetPolys());
  CHECK_EQUAL(output->GetNumberOfCells(), 7);
  CHECK_EQUAL(output->GetPointData()->GetScalars(), temperature.Get());
  CHECK_EQUAL(output->GetCellData()->GetArray("Material"), material.Get());
  CHECK_EQUAL(output->GetFieldData()->GetArray("Field"), field.Get());
  CHECK_EQUAL(mesh->GetPointData()->GetArray("DepthTag"), nullptr);

  // The tags are 4, 2, 2 and 4 - 2 sqrt(2).
  CHECK_NEAR(Tags(filter)->GetValue(0), 4.0, 1e-6);
  CHECK_NEAR(Tags(filter)->GetValue(1), 2.0, 1e-6);
  CHECK_NEAR(Tags(filter)->GetValue(3), 4.0 - 2.0 * std::sqrt(2.0), 1e-6);
  CHECK_EQUAL(Levels(filter)->GetNumberOfTuples(), 7);
  CHECK_EQUAL(Levels(filter)->GetNumberOfComponents(), 3);
  for (vtkIdType cell : { 0, 1, 2, 3, 5, 6 })
  {
    CHECK_CASE(cell);
    CHECK(HasLevels(filter, cell, -1, -1, -1));
  }
  CHECK(HasLevels(filter, 4, 3, 2, 3));

  // A metric replaces existing tags.
  vtkNew<vtkDepthTagFilter> second;
  second->SetInputData(output);
  second->SetMetric(metric);
  second->SetMaximumLevel(2);
  second->SetCamera(camera);
  second->Update();
  CHECK_NEAR(Tags(second)->GetValue(0), 2.0, 1e-6);
}

void TestUpdates(RelevoCheck& check)
{
  auto mesh = MakeTriangle();
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMaximumDistance(10.0);
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 1);
  vtkNew<vtkDepthTagFilter> filter;
  int runs = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&runs);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  filter->AddObserver(vtkCommand::EndEvent, count);
  filter->SetInputData(mesh);
  filter->SetMetric(distance);
  filter->SetCamera(camera);
  filter->Update();
  filter->Update();
  CHECK_EQUAL(runs, 1);
  const float before = Tags(filter)->GetValue(0);
  camera->SetPosition(0, 0, 2);
  filter->Update();
  CHECK_EQUAL(runs, 2);
  CHECK_LESS(Tags(filter)->GetValue(0), before);
  distance->SetMaximumDistance(20.0);
  filter->Update();
  CHECK_EQUAL(runs, 3);
  filter->SetViewportSize(640, 480);
  filter->SetMaximumLevel(7);
  filter->Update();
  CHECK_EQUAL(runs, 4);
  // If the metric does not depend on the view, moving the camera does not execute the filter.
  filter->SetMetric(curvature);
  filter->Update();
  CHECK_EQUAL(runs, 5);
  camera->SetPosition(0, 0, 3);
  filter->Update();
  CHECK_EQUAL(runs, 5);
  curvature->SetCurvatureTypeToMean();
  filter->Update();
  CHECK_EQUAL(runs, 6);
}

// Errors of the filter and of its executive.
struct FilterErrors : RelevoErrors
{
  explicit FilterErrors(vtkDepthTagFilter* filter)
    : RelevoErrors(filter)
    , Executive(filter->GetExecutive())
  {
  }
  RelevoErrors Executive;
};

void TestMetricErrors(RelevoCheck& check)
{
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetInputData(MakeTriangle());
  FilterErrors errors(filter);

  // Without metric and array, the output is empty even after a successful run.
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  filter->SetMetric(curvature);
  filter->Update();
  CHECK(errors.None() && Tags(filter)->GetNumberOfTuples() == 3);
  filter->SetMetric(nullptr);
  filter->Update();
  CHECK(errors.Said("no metric"));
  CHECK(IsEmpty(filter));
  const auto withCellArray = MakeTriangle();
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("DepthTag");
  ofCells->InsertNextValue(1.0f);
  withCellArray->GetCellData()->AddArray(ofCells);
  filter->SetInputData(withCellArray);
  filter->Update();
  CHECK(errors.Said("the input has no point array \"DepthTag\", but a cell array of that name. "
                    "Convert it with vtkCellDataToPointData."));
  filter->SetInputData(MakeTriangle());

  vtkNew<vtkDistanceDepthTagMetric> distance;
  filter->SetMetric(distance);
  filter->Update();
  CHECK(errors.Said("SetCamera"));
  CHECK(IsEmpty(filter));

  // A metric that fails reports the cause, and the filter reports that the metric failed.
  curvature->SetMinimumCurvature(1.0);
  filter->SetMetric(curvature);
  {
    RelevoErrors metricErrors(curvature);
    filter->Update();
    CHECK(metricErrors.Said("MinimumCurvature"));
  }
  CHECK(errors.Said("vtkCurvatureDepthTagMetric"));
  CHECK(IsEmpty(filter));
}

// Arrays of tags that are not one finite number per point.
void TestTagErrors(RelevoCheck& check)
{
  auto mesh = MakeTriangle();
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetInputData(mesh);
  FilterErrors errors(filter);
  SetTags(mesh, { 1.0f, 2.0f });
  filter->Update();
  CHECK(errors.Said("2 tuples"));
  CHECK(IsEmpty(filter));
  SetTags(mesh, { 1.0f, std::numeric_limits<float>::quiet_NaN(), 2.0f });
  filter->Update();
  CHECK(errors.Said("at point 1"));
  CHECK(IsEmpty(filter));
  SetTags(mesh, { 1.0f, 1.0f, 2.0f });
  filter->Update();
  CHECK(errors.None() && Tags(filter)->GetNumberOfTuples() == 3);
}

void TestSettingErrors(RelevoCheck& check)
{
  vtkNew<vtkDepthTagFilter> filter;
  RelevoErrors errors(filter);
  for (int bad : { -1, 8 })
  {
    CHECK_CASE(bad);
    filter->SetMaximumLevel(bad);
    CHECK(errors.Said("MaximumLevel"));
    CHECK_EQUAL(filter->GetMaximumLevel(), 3);
  }
  filter->SetViewportSize(0, 100);
  CHECK(errors.Said("ViewportSize"));
  CHECK(filter->GetViewportSize()[0] == 300 && filter->GetViewportSize()[1] == 300);
}

// Points that are not finite, invalid ids, and empty meshes.
void TestBrokenMeshes(RelevoCheck& check)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 0);
  vtkNew<vtkDistanceDepthTagMetric> distance;
  distance->SetMaximumDistance(10.0);
  vtkNew<vtkDepthTagFilter> filter;
  filter->SetMaximumLevel(5);
  filter->SetMetric(distance);
  filter->SetCamera(camera);
  FilterErrors errors(filter);

  // Points that are not finite get level 0.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  filter->SetInputData(MakeMesh(
    { { 0, 0, 0 }, { nan, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
  filter->Update();
  CHECK(errors.None());
  CHECK_EQUAL(Tags(filter)->GetValue(0), 5.0f);
  CHECK_EQUAL(Tags(filter)->GetValue(1), 0.0f);
  CHECK(HasLevels(filter, 0, 3, 2, 5));

  // Cells with invalid ids have no levels.
  filter->SetInputData(MakeMesh({ { 0, 0, 0 } }, { { 0, 1, 2 }, { 0, -1, 0 } }));
  filter->Update();
  CHECK(HasLevels(filter, 0, -1, -1, -1) && HasLevels(filter, 1, -1, -1, -1));

  // An empty mesh gives an empty output with both arrays.
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  for (vtkDepthTagMetric* metric : std::vector<vtkDepthTagMetric*>{ distance, curvature })
  {
    filter->SetMetric(metric);
    filter->Update();
    CHECK(errors.None());
    CHECK(Tags(filter) && Tags(filter)->GetNumberOfTuples() == 0);
    CHECK(Levels(filter) && Levels(filter)->GetNumberOfTuples() == 0);
  }

  // A block that is not a vtkPolyData.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkUnstructuredGrid>());
  filter->SetInputDataObject(blocks);
  filter->Update();
  CHECK(errors.Said("The input is a vtkUnstructuredGrid; a vtkPolyData is needed."));
}
}

int TestDepthTagFilter(int, char*[])
{
  RelevoCheck check;
  TestEdgeRule(check);
  TestLevelRule(check);
  TestPassThrough(check);
  TestUpdates(check);
  TestMetricErrors(check);
  TestTagErrors(check);
  TestSettingErrors(check);
  TestBrokenMeshes(check);
  return check.GetResult();
}
