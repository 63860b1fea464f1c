// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkFieldVariationDepthTagMetric promises levels by the variation of an array, compared with
// values computed by hand.
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

// Triangles (i, i + 1, i + 2): point i has edges to the two points before it and the two after it.
RelevoMeshes::Mesh Strip()
{
  return RelevoMeshes::FromTriangles({ { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } },
                                       { { 1, 1, 0 } }, { { 2, 0, 0 } }, { { 2, 1, 0 } } },
    { { { 0, 2, 1 } }, { { 1, 2, 3 } }, { { 2, 4, 3 } }, { { 3, 4, 5 } } });
}

const double NaN = std::nan("");
const double Infinity = std::numeric_limits<double>::infinity();

// A strip, and the metric of its array "field".
struct Scene
{
  Scene()
  {
    this->Metric->SetArrayName("field");
    this->Metric->SetMaximumVariation(1.0);
  }
  vtkPointData* GetPointData() { return this->Mesh->GetPointData(); }
  std::vector<float> GetTags(int maximumLevel)
  {
    return TagsOf(this->Metric, this->Mesh, this->View, maximumLevel);
  }
  void Expect(RelevoCheck& check, const std::vector<double>& levels)
  {
    const auto tags = this->GetTags(4);
    CHECK_EQUAL(tags.size(), levels.size());
    for (std::size_t i = 0; i < tags.size() && i < levels.size(); ++i)
    {
      CHECK_NEAR(tags[i], levels[i], 1e-5);
    }
  }

  vtkNew<vtkFieldVariationDepthTagMetric> Metric;
  RelevoMeshes::Mesh Mesh = Strip();
  relevo::RefinementView View; // no camera is needed
};

// The variation is relative to the array's range of 8.
void TestScalar(RelevoCheck& check)
{
  Scene scene;
  CHECK(!scene.Metric->IsViewDependent());
  AddArray<vtkIntArray>(scene.GetPointData(), 1, { -4, -4, -2, -2, 4, 0 });
  scene.Expect(check, { 1, 1, 3, 3, 3, 2 });
  scene.Metric->SetMinimumVariation(0.25);
  scene.Metric->SetMaximumVariation(0.5);
  scene.Expect(check, { 0, 0, 4, 4, 4, 4 });
  scene.Metric->SetMinimumVariation(0.0);
  scene.Metric->SetMaximumVariation(1.0);
  // Values that are not finite give no variation.
  AddArray<vtkDoubleArray>(scene.GetPointData(), 1, { 0, NaN, 1, Infinity, -Infinity, 4 });
  scene.Expect(check, { 1, 0, 1, 0, 0, 0 });
  AddArray<vtkDoubleArray>(scene.GetPointData(), 1, std::vector<double>(6, NaN));
  scene.Expect(check, std::vector<double>(6, 0.0));
  AddArray<vtkDoubleArray>(scene.GetPointData(), 1, std::vector<double>(6, 7.0));
  scene.Expect(check, std::vector<double>(6, 0.0));
  AddArray<vtkDoubleArray>(scene.GetPointData(), 1, { -1e308, 1e308, 0, 0, 0, 0 });
  CHECK(AreLevels(scene.GetTags(4), 6, 4));
}

// For vectors it is the angle over 180 degrees, or the difference of lengths over the largest
// length.
void TestVectors(RelevoCheck& check)
{
  Scene scene;
  AddArray<vtkDoubleArray>(
    scene.GetPointData(), 3, { 8, 0, 0, 8, 0, 0, 8, 0, 0, 0, 8, 0, 0, 2, 0, 0, 0, 0 });
  scene.Expect(check, { 0, 2, 3, 4, 3, 4 });
  // Opposite vectors, vectors too short to have a direction, and a NaN component.
  AddArray<vtkDoubleArray>(scene.GetPointData(), 2, { 1, 0, -1, 0, -1, 0, -1, NaN, 0, 1e-9, 0, 0 });
  scene.Expect(check, { 4, 4, 4, 0, 4, 0 });
  // Missing values give no variation and do not count for the largest length.
  for (double sentinel : { -1e9, 1e20, 1e8, Infinity })
  {
    CHECK_CASE(sentinel);
    AddArray<vtkDoubleArray>(
      scene.GetPointData(), 2, { 8, 0, 8, 0, 8, 0, 0, 8, sentinel, 2, 0, 0 });
    scene.Expect(check, { 0, 2, 2, 4, 0, 4 });
  }
  scene.Metric->SetNoDataMagnitude(1e10);
  AddArray<vtkDoubleArray>(scene.GetPointData(), 2, { 1, 0, 1, 0, 1, 0, 1, 0, -1e9, 0, 1, 0 });
  scene.Expect(check, { 0, 0, 4, 4, 4, 4 });
  scene.Metric->SetNoDataMagnitude(1e8);
  // Small angles stay accurate in any dimension.
  scene.Metric->SetMaximumVariation(1e-6);
  AddArray<vtkDoubleArray>(scene.GetPointData(), 4,
    { 1, 0, 0, 0, 1, 0, 0, 0.5e-6 * vtkMath::Pi(), 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0,
      0 });
  scene.Expect(check, { 2, 2, 2, 2, 0, 0 });
}

// For cell data it is the jump across an edge, and 0 at the border. Vertices and lines come first.
void TestCells(RelevoCheck& check)
{
  Scene scene;
  vtkCellData* data = scene.Mesh->GetCellData();
  AddArray<vtkDoubleArray>(data, 1, { 0, 0, 4, 2 });
  scene.Expect(check, { 0, 0, 4, 4, 2, 0 });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  scene.Mesh->SetVerts(verts);
  AddArray<vtkDoubleArray>(data, 1, { 9, 9, 9, 5, 1 });
  scene.Expect(check, { 0, 0, 2, 2, 2, 0 });
  // A point array takes precedence.
  AddArray<vtkIntArray>(scene.GetPointData(), 1, std::vector<double>(6, 1));
  scene.Expect(check, std::vector<double>(6, 0.0));
}

// A plane whose "field" is scale x^2 + offset, with x from 0 on.
RelevoMeshes::Mesh MakeParabola(double scale, double offset)
{
  auto plane = RelevoMeshes::Plane(20, 20);
  std::vector<double> values;
  for (vtkIdType point = 0; point < plane->GetNumberOfPoints(); ++point)
  {
    const double x = plane->GetPoint(point)[0] + 0.5;
    values.push_back(scale * x * x + offset);
  }
  AddArray<vtkDoubleArray>(plane->GetPointData(), 1, values);
  return plane;
}

// The automatic threshold is the value that 95 % of the edges do not exceed. The scale of the
// values has no influence.
void TestAutomatic(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMaximumVariation(0.0);
  const auto tags = TagsOf(scene.Metric, MakeParabola(1.0, 0.0), scene.View, 5);
  const auto scaled = TagsOf(scene.Metric, MakeParabola(1e12, 3e11), scene.View, 5);
  for (std::size_t i = 0; i < tags.size(); ++i)
  {
    CHECK_NEAR(scaled[i], tags[i], 1e-3);
    if (i > 0 && i % 21)
    {
      CHECK_GREATER_EQUAL(tags[i], tags[i - 1]); // x increases the slope
    }
  }
  CHECK(tags[0] < 0.2f && tags[20] == 5.0f);

  // Degenerate meshes with an array give levels, too.
  for (auto odd : { RelevoMeshes::Mixed(), RelevoMeshes::NonManifold(), RelevoMeshes::Strips() })
  {
    std::vector<double> values(odd->GetNumberOfCells());
    std::iota(values.begin(), values.end(), 0.0);
    AddArray<vtkDoubleArray>(odd->GetCellData(), 1, values);
    CHECK(AreLevels(TagsOf(scene.Metric, odd, scene.View, 5), odd->GetNumberOfPoints(), 5));
  }
}

void TestSettingErrors(RelevoCheck& check)
{
  vtkNew<vtkFieldVariationDepthTagMetric> metric;
  RelevoErrors errors(metric);
  for (double bad : { -0.1, 1.1, NaN })
  {
    CHECK_CASE(bad);
    metric->SetMinimumVariation(bad);
    CHECK(errors.Said("MinimumVariation") && metric->GetMinimumVariation() == 0.0);
    metric->SetMaximumVariation(bad);
    CHECK(errors.Said("MaximumVariation") && metric->GetMaximumVariation() == 0.0);
  }
  for (double bad : { 0.0, -1.0, NaN })
  {
    CHECK_CASE(bad);
    metric->SetNoDataMagnitude(bad);
    CHECK(errors.Said("NoDataMagnitude") && metric->GetNoDataMagnitude() == 1e8);
  }
}

// Thresholds that contradict each other, and arrays that are missing or cannot be used.
void TestArrayErrors(RelevoCheck& check)
{
  Scene scene;
  scene.Metric->SetMaximumVariation(0.0);
  scene.Mesh = MakeParabola(1e12, 3e11);
  vtkFieldVariationDepthTagMetric* metric = scene.Metric;
  RelevoErrors errors(metric);
  metric->SetMinimumVariation(0.5);
  CHECK(scene.GetTags(5).empty() && errors.Said("above"));
  metric->SetMinimumVariation(0.0);
  metric->SetArrayName("absent");
  CHECK(scene.GetTags(5).empty() && errors.Said("\"absent\""));
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(scene.Mesh->GetNumberOfPoints());
  scene.GetPointData()->AddArray(words);
  metric->SetArrayName("words");
  CHECK(scene.GetTags(5).empty() && errors.Said("array of numbers"));
  metric->SetArrayName("field");
  AddArray<vtkDoubleArray>(scene.GetPointData(), 1, { 1, 2, 3 });
  CHECK(scene.GetTags(5).empty() && errors.Said("3 tuples"));
  metric->SetArrayName(nullptr);
  CHECK(scene.GetTags(5).empty() && errors.Said("SetArrayName"));
}
}

int TestFieldVariationDepthTagMetric(int, char*[])
{
  RelevoCheck check;
  TestScalar(check);
  TestVectors(check);
  TestCells(check);
  TestAutomatic(check);
  TestSettingErrors(check);
  TestArrayErrors(check);
  return check.GetResult();
}
