// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementFilter promises an error that names the cause and an empty output for
// unusable input. Its output never contains NaN.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellArray.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTexturedSphereSource.h"

#include <cmath>
#include <limits>

using namespace RelevoMeshes;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Returns the tags that a test gives it, or fails.
class BadMetric : public vtkDepthTagMetric
{
public:
  static BadMetric* New()
  {
    BadMetric* result = new BadMetric;
    result->InitializeObjectBase();
    return result;
  }
  vtkTypeMacro(BadMetric, vtkDepthTagMetric);
  bool IsViewDependent() override { return false; }
  bool ComputeTags(vtkPolyData*, const relevo::RefinementView&, int, vtkFloatArray* tags) override
  {
    for (float value : this->Values)
    {
      tags->InsertNextValue(value);
    }
    return !this->Values.empty();
  }
  std::vector<float> Values;
};

// Runs a filter that must fail with these words and an empty output.
void expectError(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter, const std::string& words)
{
  RelevoErrors executive(filter->GetExecutive());
  RelevoErrors errors(filter);
  filter->Modified();
  const int result = filter->GetExecutive()->Update();
  if (result != 0 || !errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, "no error with: " + words);
  }
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
}

// Runs a filter that must succeed with finite points and normals.
void expectSuccess(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  filter->Modified();
  CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
  vtkPolyData* output = filter->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    CHECK(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
    if (vtkDataArray* normals = output->GetPointData()->GetNormals())
    {
      normals->GetTuple(i, p);
      CHECK_NEAR(vtkMath::Norm(p), 1.0, 1e-5);
    }
  }
}

void testRecipe(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(Sphere(6, 5));
  expectError(check, filter, "SetRefinement");

  vtkNew<vtkAdaptiveRefinement> recipe;
  filter->SetRefinement(recipe);
  {
    RelevoErrors errors(recipe);
    for (int level : { -1, 8, 1000 })
    {
      CHECK_CASE(level);
      recipe->SetMaximumLevel(3);
      recipe->SetMaximumLevel(level);
      CHECK(errors.Said("MaximumLevel"));
      CHECK_EQUAL(recipe->GetMaximumLevel(), 3);
    }
  }
  {
    RelevoErrors errors(filter);
    filter->SetViewportSize(0, 100);
    CHECK(errors.Said("ViewportSize"));
    CHECK(filter->GetViewportSize()[0] == 300 && filter->GetViewportSize()[1] == 300);
  }
  // The filter works again after an error.
  expectSuccess(check, filter);
  CHECK_GREATER(filter->GetOutput()->GetNumberOfPolys(), 0);
}

void testTags(RelevoCheck& check)
{
  Mesh sphere = Sphere(6, 5);
  const vtkIdType n = sphere->GetNumberOfPoints();
  vtkNew<vtkAdaptiveRefinement> recipe;
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(sphere);
  filter->SetRefinement(recipe);
  for (vtkIdType length : { vtkIdType(0), n - 1, n + 1 })
  {
    CHECK_CASE(length);
    vtkNew<vtkFloatArray> tags;
    tags->SetName("DepthTag");
    tags->SetNumberOfValues(length);
    tags->Fill(1.0);
    sphere->GetPointData()->AddArray(tags);
    expectError(check, filter, "\"DepthTag\" of depth-tags has " + std::to_string(length));
  }
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("DepthTag");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(n);
  vectors->Fill(1.0);
  sphere->GetPointData()->AddArray(vectors);
  expectError(check, filter, "3 components");

  vtkNew<vtkStringArray> words;
  words->SetName("DepthTag");
  words->SetNumberOfValues(n);
  sphere->GetPointData()->AddArray(words);
  expectError(check, filter, "no numbers");

  vtkNew<vtkDoubleArray> tags;
  tags->SetName("DepthTag");
  tags->SetNumberOfValues(n);
  tags->Fill(1.0);
  tags->SetValue(7, NaN);
  sphere->GetPointData()->AddArray(tags);
  expectError(check, filter, "NaN at point 7");
  tags->SetValue(7, Infinity);
  tags->SetValue(8, -Infinity);
  tags->Modified();
  expectSuccess(check, filter);
  sphere->GetPointData()->RemoveArray("DepthTag");

  vtkNew<BadMetric> metric;
  recipe->SetMetric(metric);
  expectError(check, filter, "BadMetric returned no depth-tags");
  metric->Values = { 1.0f, 2.0f };
  expectError(check, filter, "BadMetric");
  metric->Values.assign(static_cast<size_t>(n), 1.0f);
  expectSuccess(check, filter);
  metric->Values[3] = static_cast<float>(NaN);
  expectError(check, filter, "NaN at point 3");
}

void testDisplacement(RelevoCheck& check)
{
  vtkNew<vtkDisplacement> displacement;
  {
    RelevoErrors errors(displacement);
    displacement->SetScale(2.0);
    displacement->SetScale(NaN);
    CHECK(errors.Said("Scale") && displacement->GetScale() == 2.0);
    displacement->SetOffset(Infinity);
    CHECK(errors.Said("Offset") && displacement->GetOffset() == 0.0);
    displacement->SetDirection(0.0, 3.0, 4.0);
    displacement->SetDirection(0.0, 0.0, 0.0);
    CHECK(errors.Said("Direction"));
    displacement->SetDirection(0.0, NaN, 1.0);
    CHECK(errors.Said("Direction"));
    displacement->SetDirection(0.0, Infinity, 1.0);
    CHECK(errors.Said("Direction"));
    CHECK_NEAR(displacement->GetDirection()[1], 0.6, 1e-12);
    CHECK(!displacement->IsAlongNormal());
    displacement->SetDirectionToNormal();
  }
  Mesh plane = Plane(3, 3);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  recipe->SetDisplacement(displacement);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(plane);
  filter->SetRefinement(recipe);
  vtkNew<RelevoHeights> heights;
  displacement->SetHeightMap(heights);
  {
    RelevoErrors errors(displacement);
    RelevoErrors own(heights);
    expectError(check, filter, "height map");
    CHECK(errors.Said("RelevoHeights has no samples"));
  }
  heights->FillRandom(5, 5, 3);
  expectSuccess(check, filter);
  heights->FillRandom(1, 1, 3);
  expectSuccess(check, filter);
  heights->FillRandom(1, 7, 3);
  expectSuccess(check, filter);

  vtkSmartPointer<vtkDataArray> uvs = plane->GetPointData()->GetTCoords();
  plane->GetPointData()->SetTCoords(nullptr);
  expectError(check, filter, "texture coordinates");
  vtkNew<vtkFloatArray> one;
  one->SetName("u");
  one->SetNumberOfValues(plane->GetNumberOfPoints());
  one->Fill(0.5);
  plane->GetPointData()->SetTCoords(one);
  expectError(check, filter, "1 components");
  vtkNew<vtkFloatArray> few;
  few->SetName("few");
  few->SetNumberOfComponents(2);
  few->SetNumberOfTuples(3);
  few->Fill(0.5);
  plane->GetPointData()->SetTCoords(few);
  expectError(check, filter, "3 tuples");
  plane->GetPointData()->SetTCoords(uvs);
  uvs->SetComponent(5, 1, NaN);
  uvs->Modified();
  expectError(check, filter, "point 5");
  uvs->SetComponent(5, 1, -1e30);
  uvs->Modified();
  expectSuccess(check, filter);
  // Lines without faces need no texture coordinates.
  Mesh lines = Make();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  lines->SetPoints(points);
  lines->SetLines(cells);
  filter->SetInputData(lines);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfLines(), 1);
}

void testNoCells(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  filter->SetInputData(Make());
  expectError(check, filter, "no cells");
  Mesh loose = Make();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  loose->SetPoints(points);
  filter->SetInputData(loose);
  expectError(check, filter, "no cells");
}

// Cells of all four kinds that refer to missing points.
void testMissingPoints(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  for (int cells = 0; cells < 4; ++cells)
  {
    for (vtkIdType bad : { vtkIdType(8), vtkIdType(-1), vtkIdType(1) << 40 })
    {
      CHECK_CASE(bad);
      Mesh mesh = Sphere(3, 4);
      const vtkIdType known = mesh->GetNumberOfPoints();
      CHECK_EQUAL(known, 8);
      vtkNew<vtkCellArray> broken;
      broken->InsertNextCell({ 0, 1, bad });
      cells == 0     ? mesh->SetVerts(broken)
        : cells == 1 ? mesh->SetLines(broken)
        : cells == 2 ? mesh->SetPolys(broken)
                     : mesh->SetStrips(broken);
      filter->SetInputData(mesh);
      expectError(check, filter, "refers to point " + std::to_string(bad));
    }
  }
  Mesh noPoints = Make();
  noPoints->SetPolys(Sphere(3, 4)->GetPolys());
  filter->SetInputData(noPoints);
  expectError(check, filter, "refers to point");
}

// Triangles with points that are not finite are dropped with a warning, and so are the points.
void testInfinitePoints(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  for (double bad : { NaN, Infinity, -Infinity, 1e300 })
  {
    Mesh mesh = Moved(Sphere(6, 5), 1.0, std::array<double, 3>{ { 0, 0, 0 } }.data(), VTK_DOUBLE);
    mesh->GetPoints()->SetPoint(9, 0.1, bad, 0.2);
    int around = 0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, ids);
      around += ids->IsId(9) >= 0 ? 1 : 0;
    }
    filter->SetInputData(mesh);
    if (bad == 1e300)
    {
      // The centre is so far away that float coordinates relative to it overflow.
      expectError(check, filter, "farther than");
      continue;
    }
    RelevoErrors errors(filter);
    expectSuccess(check, filter);
    CHECK(errors.Warned(std::to_string(around) + " degenerate"));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), (mesh->GetNumberOfPolys() - around) * 16);
  }
}

// The warning counts degenerate cells.
void testDegenerateCells(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  Mesh degenerate = Sphere(6, 5);
  degenerate->GetPolys()->InsertNextCell({ 1, 1, 2 });
  degenerate->GetPolys()->InsertNextCell({ 1, 2 });
  degenerate->GetPolys()->InsertNextCell({ 5 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 1, 2, 2, 3 });
  degenerate->SetStrips(strips);
  filter->SetInputData(degenerate);
  {
    RelevoErrors errors(filter);
    expectSuccess(check, filter);
    CHECK(errors.Warned("5 degenerate"));
  }
  // A mesh of degenerate cells only gives an empty output.
  Mesh nothing = FromTriangles({ { { 0, 0, 0 } }, { { 1, 0, 0 } } }, { { { 0, 1, 1 } } });
  filter->SetInputData(nothing);
  {
    RelevoErrors errors(filter);
    CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
    CHECK(errors.Warned("1 degenerate"));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

// Meshes near the limits of the float range, and slivers.
void testSizes(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  for (double scale : { 1e-30, 1e-18, 1e15, 1e25 })
  {
    CHECK_CASE(scale);
    filter->SetInputData(
      Moved(Sphere(6, 5), scale, std::array<double, 3>{ { 0, 0, 0 } }.data(), VTK_FLOAT));
    expectSuccess(check, filter);
    CHECK_GREATER(filter->GetOutput()->GetNumberOfPolys(), 0);
  }
  // A sphere that is closed only up to rounding, with slivers of 1e-17 at a pole, with and without
  // normals.
  vtkNew<vtkTexturedSphereSource> source;
  source->Update();
  filter->SetInputData(source->GetOutput());
  RelevoErrors errors(filter);
  expectSuccess(check, filter);
  source->GetOutput()->GetPointData()->SetNormals(nullptr);
  expectSuccess(check, filter);
}

// Normals that cannot be used are computed.
void testNormals(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  Mesh sphere = Sphere(6, 5);
  vtkDataArray* normals = sphere->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    normals->SetComponent(i, 1, i % 2 ? NaN : Infinity);
  }
  filter->SetInputData(sphere);
  expectSuccess(check, filter);
  // Here the normals are fewer than the points.
  normals->SetNumberOfTuples(3);
  filter->SetInputData(sphere);
  expectSuccess(check, filter);
}

// An invalid block does not affect the other blocks.
void testBlocks(RelevoCheck& check, vtkAdaptiveRefinementFilter* filter)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Make());
  blocks->SetBlock(1, Sphere(6, 5));
  blocks->SetBlock(2, vtkNew<vtkImageData>());
  filter->SetInputDataObject(blocks);
  RelevoErrors errors(filter);
  RelevoErrors errorsOfTypes(filter);
  RelevoErrors executive(filter->GetExecutive());
  filter->Update();
  CHECK(errors.Said("no cells"));
  CHECK(errorsOfTypes.Said("The input is a vtkImageData; a vtkPolyData is needed."));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* second = output ? vtkPolyData::SafeDownCast(output->GetBlock(1)) : nullptr;
  CHECK(second && second->GetNumberOfPolys() > 0);
}

// Tests all combinations of surface and displacement.
void testMeshes(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> pn;
  vtkNew<vtkDisplacement> displacement;
  displacement->SetOffset(0.1);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetRefinement(recipe);
  for (int kind = 0; kind < 4; ++kind)
  {
    recipe->SetSurface(kind % 2 ? pn.Get() : nullptr);
    recipe->SetDisplacement(kind / 2 ? displacement.Get() : nullptr);
    testNoCells(check, filter);
    testMissingPoints(check, filter);
    testInfinitePoints(check, filter);
    testDegenerateCells(check, filter);
    testSizes(check, filter);
    testNormals(check, filter);
  }
  testBlocks(check, filter);
}
}

int TestAdaptiveRefinementFilterErrors(int, char*[])
{
  RelevoCheck check;
  testRecipe(check);
  testTags(check);
  testDisplacement(check);
  testMeshes(check);
  return check.GetResult();
}
