// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkFieldVariationDepthTagMetric against variations by hand.
#include "RelevoCheck.h"
#include "RelevoMetricCheck.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <limits>
#include <numeric>

namespace
{
template <typename ArrayT>
void AddArray(vtkDataSetAttributes* data, int components, const std::vector<double>& values)
{
  vtkNew<ArrayT> array;
  array->SetName("field");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetComponent(
      static_cast<vtkIdType>(i) / components, static_cast<int>(i) % components, values[i]);
  }
  data->RemoveArray("field");
  data->AddArray(array);
}

// Triangles (i, i + 1, i + 2): point i has edges to the two before and the two after.
RelevoMeshes::Mesh Strip()
{
  return RelevoMeshes::FromTriangles({ { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } },
                                       { { 1, 1, 0 } }, { { 2, 0, 0 } }, { { 2, 1, 0 } } },
    { { { 0, 2, 1 } }, { { 1, 2, 3 } }, { { 2, 4, 3 } }, { { 3, 4, 5 } } });
}
}

int TestFieldVariationDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  vtkNew<vtkFieldVariationDepthTagMetric> metric;
  CHECK(!metric->IsViewDependent());
  const relevo::RefinementView view; // no camera is needed
  metric->SetArrayName("field");
  metric->SetMaximumVariation(1.0);
  auto mesh = Strip();
  const auto expect = [&](const std::vector<double>& levels)
  {
    const auto tags = TagsOf(metric, mesh, view, 4);
    CHECK(tags.size() == levels.size());
    for (std::size_t i = 0; i < tags.size() && i < levels.size(); ++i)
    {
      CHECK_NEAR(tags[i], levels[i], 1e-5);
    }
  };

  // A scalar, relative to its range of 8.
  AddArray<vtkIntArray>(mesh->GetPointData(), 1, { -4, -4, -2, -2, 4, 0 });
  expect({ 1, 1, 3, 3, 3, 2 });
  metric->SetMinimumVariation(0.25);
  metric->SetMaximumVariation(0.5);
  expect({ 0, 0, 4, 4, 4, 4 });
  metric->SetMinimumVariation(0.0);
  metric->SetMaximumVariation(1.0);
  // Values that are not finite make no variation.
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 1, { 0, nan, 1, infinity, -infinity, 4 });
  expect({ 1, 0, 1, 0, 0, 0 });
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 1, std::vector<double>(6, nan));
  expect(std::vector<double>(6, 0.0));
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 1, std::vector<double>(6, 7.0));
  expect(std::vector<double>(6, 0.0));
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 1, { -1e308, 1e308, 0, 0, 0, 0 });
  CHECK(AreLevels(TagsOf(metric, mesh, view, 4), 6, 4));

  // Vectors: the angle over 180 degrees, or the difference of lengths over the longest.
  AddArray<vtkDoubleArray>(
    mesh->GetPointData(), 3, { 8, 0, 0, 8, 0, 0, 8, 0, 0, 0, 8, 0, 0, 2, 0, 0, 0, 0 });
  expect({ 0, 2, 3, 4, 3, 4 });
  // Opposite vectors; ones too short to have a direction; a NaN in one component.
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 2, { 1, 0, -1, 0, -1, 0, -1, nan, 0, 1e-9, 0, 0 });
  expect({ 4, 4, 4, 0, 4, 0 });
  // What stands for no data makes no variation and does not count as the longest.
  for (double sentinel : { -1e9, 1e20, 1e8, infinity })
  {
    AddArray<vtkDoubleArray>(
      mesh->GetPointData(), 2, { 8, 0, 8, 0, 8, 0, 0, 8, sentinel, 2, 0, 0 });
    expect({ 0, 2, 2, 4, 0, 4 });
  }
  metric->SetNoDataMagnitude(1e10);
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 2, { 1, 0, 1, 0, 1, 0, 1, 0, -1e9, 0, 1, 0 });
  expect({ 0, 0, 4, 4, 4, 4 });
  metric->SetNoDataMagnitude(1e8);
  // Small angles keep their digits, in any dimension.
  metric->SetMaximumVariation(1e-6);
  AddArray<vtkDoubleArray>(mesh->GetPointData(), 4,
    { 1, 0, 0, 0, 1, 0, 0, 0.5e-6 * vtkMath::Pi(), 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0,
      0 });
  expect({ 2, 2, 2, 2, 0, 0 });
  metric->SetMaximumVariation(1.0);

  // Cells: the jump over an edge between two of them, 0 over the border. Verts and lines come
  // first.
  mesh->GetPointData()->RemoveArray("field");
  AddArray<vtkDoubleArray>(mesh->GetCellData(), 1, { 0, 0, 4, 2 });
  expect({ 0, 0, 4, 4, 2, 0 });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  mesh->SetVerts(verts);
  AddArray<vtkDoubleArray>(mesh->GetCellData(), 1, { 9, 9, 9, 5, 1 });
  expect({ 0, 0, 2, 2, 2, 0 });
  // The points' array wins.
  AddArray<vtkIntArray>(mesh->GetPointData(), 1, std::vector<double>(6, 1));
  expect(std::vector<double>(6, 0.0));

  // Automatic: what 95 % of the edges do not exceed; the scale of the values does not matter.
  metric->SetMaximumVariation(0.0);
  auto plane = RelevoMeshes::Plane(20, 20);
  std::vector<double> square;
  std::vector<double> scaled;
  for (vtkIdType point = 0; point < plane->GetNumberOfPoints(); ++point)
  {
    const double x = plane->GetPoint(point)[0] + 0.5;
    square.push_back(x * x);
    scaled.push_back(1e12 * x * x + 3e11);
  }
  AddArray<vtkDoubleArray>(plane->GetPointData(), 1, square);
  const auto tags = TagsOf(metric, plane, view, 5);
  AddArray<vtkDoubleArray>(plane->GetPointData(), 1, scaled);
  const auto ofScaled = TagsOf(metric, plane, view, 5);
  for (std::size_t i = 0; i < tags.size(); ++i)
  {
    CHECK_NEAR(ofScaled[i], tags[i], 1e-3);
    if (i > 0 && i % 21)
    {
      CHECK(tags[i] >= tags[i - 1]); // steeper with x
    }
  }
  CHECK(tags[0] < 0.2f && tags[20] == 5.0f);

  // Odd meshes, with an array.
  for (auto odd : { RelevoMeshes::Mixed(), RelevoMeshes::NonManifold(), RelevoMeshes::Strips() })
  {
    std::vector<double> values(odd->GetNumberOfCells());
    std::iota(values.begin(), values.end(), 0.0);
    AddArray<vtkDoubleArray>(odd->GetCellData(), 1, values);
    CHECK(AreLevels(TagsOf(metric, odd, view, 5), odd->GetNumberOfPoints(), 5));
  }

  // Errors.
  RelevoErrors errors(metric);
  for (double bad : { -0.1, 1.1, nan })
  {
    metric->SetMinimumVariation(bad);
    CHECK(errors.Said("MinimumVariation") && metric->GetMinimumVariation() == 0.0);
    metric->SetMaximumVariation(bad);
    CHECK(errors.Said("MaximumVariation") && metric->GetMaximumVariation() == 0.0);
  }
  for (double bad : { 0.0, -1.0, nan })
  {
    metric->SetNoDataMagnitude(bad);
    CHECK(errors.Said("NoDataMagnitude") && metric->GetNoDataMagnitude() == 1e8);
  }
  metric->SetMinimumVariation(0.5);
  CHECK(TagsOf(metric, plane, view, 5).empty() && errors.Said("above"));
  metric->SetMinimumVariation(0.0);
  metric->SetArrayName("absent");
  CHECK(TagsOf(metric, plane, view, 5).empty() && errors.Said("\"absent\""));
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(plane->GetNumberOfPoints());
  plane->GetPointData()->AddArray(words);
  metric->SetArrayName("words");
  CHECK(TagsOf(metric, plane, view, 5).empty() && errors.Said("array of numbers"));
  metric->SetArrayName("field");
  AddArray<vtkDoubleArray>(plane->GetPointData(), 1, { 1, 2, 3 });
  CHECK(TagsOf(metric, plane, view, 5).empty() && errors.Said("3 tuples"));
  metric->SetArrayName(nullptr);
  CHECK(TagsOf(metric, plane, view, 5).empty() && errors.Said("SetArrayName"));
  return check.GetResult();
}
