// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthTagFilter and vtkAdaptiveRefinementFilter promise an error for a metric that does not
// return one number per point or edge. An array that moves from points to cells takes effect.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Metrics/MetricEvaluator.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkDepthTagFilter.h"
#include "vtkExecutive.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{
// A mesh with as many triangles as points.
RelevoMeshes::Mesh MakeTetrahedron()
{
  return RelevoMeshes::FromTriangles(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } },
    { { { 1, 2, 3 } }, { { 0, 3, 2 } }, { { 0, 1, 3 } }, { { 0, 2, 1 } } });
}

// Returns the given tags for points and for edges. Without tags for edges, it returns the means of
// the points' tags.
class GivenTags : public vtkDepthTagMetric
{
public:
  static GivenTags* New() { VTK_STANDARD_NEW_BODY(GivenTags); }
  vtkTypeMacro(GivenTags, vtkDepthTagMetric);

  bool IsViewDependent() override { return false; }

  static void Copy(const std::vector<float>& values, vtkFloatArray* tags)
  {
    tags->Initialize();
    for (float value : values)
    {
      tags->InsertNextValue(value);
    }
  }

  bool ComputeTags(vtkPolyData*, const relevo::RefinementView&, int, vtkFloatArray* tags) override
  {
    Copy(this->OfPoints, tags);
    return true;
  }

  bool ComputeEdgeTags(vtkPolyData* mesh, const relevo::RefinementView& view, int maximumLevel,
    const relevo::SurfaceEdges& edges, vtkFloatArray* tags) override
  {
    if (this->OfEdges.empty())
    {
      return this->Superclass::ComputeEdgeTags(mesh, view, maximumLevel, edges, tags);
    }
    Copy(this->OfEdges, tags);
    return true;
  }

  std::vector<float> OfPoints = std::vector<float>(4, 1.0f);
  std::vector<float> OfEdges;
};

// The same tags for points, from an evaluator without edge tags.
class EvaluatedTags : public GivenTags
{
public:
  static EvaluatedTags* New() { VTK_STANDARD_NEW_BODY(EvaluatedTags); }
  vtkTypeMacro(EvaluatedTags, GivenTags);

  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override
  {
    class Evaluator : public relevo::MetricEvaluator
    {
    public:
      Evaluator(EvaluatedTags* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
        : MetricEvaluator(metric, mesh)
      {
      }
      bool ComputeTags(const relevo::RefinementView&, int, vtkFloatArray* tags) override
      {
        Copy(static_cast<EvaluatedTags*>(this->GetMetric())->OfPoints, tags);
        return true;
      }
    };
    return std::make_unique<Evaluator>(this, mesh);
  }
};

// Returns the errors of a filter that executes.
std::string Run(vtkPolyDataAlgorithm* filter)
{
  std::string said;
  RelevoErrors executive(filter->GetExecutive());
  vtkNew<vtkTest::ErrorObserver> observer;
  const unsigned long tag = filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(tag);
  return observer->GetError() ? observer->GetErrorMessage() : "";
}

// Both filters, with the same level rule.
class Filters
{
public:
  Filters(vtkDepthTagMetric* metric, int rule)
  {
    this->Tag->SetInputData(this->Mesh);
    this->Tag->SetMetric(metric);
    this->Tag->SetLevelRule(rule);
    this->Recipe->SetMetric(metric);
    this->Recipe->SetLevelRule(rule);
    this->Refine->SetInputData(this->Mesh);
    this->Refine->SetRefinement(this->Recipe);
  }

  // Whether both filters report these words and have an empty output.
  bool Say(const std::string& words)
  {
    return Run(this->Tag).find(words) != std::string::npos &&
      Run(this->Refine).find(words) != std::string::npos &&
      this->Tag->GetOutput()->GetNumberOfPoints() == 0 &&
      this->Refine->GetOutput()->GetNumberOfPoints() == 0;
  }

  bool Work()
  {
    return Run(this->Tag).empty() && Run(this->Refine).empty() &&
      this->Tag->GetOutput()->GetNumberOfPoints() == 4 &&
      this->Refine->GetOutput()->GetNumberOfPolys() == 16;
  }

private:
  RelevoMeshes::Mesh Mesh = MakeTetrahedron();
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkDepthTagFilter> Tag;
  vtkNew<vtkAdaptiveRefinementFilter> Refine;
};

void TestPoints(RelevoCheck& check, GivenTags* metric, int rule)
{
  Filters filters(metric, rule);
  CHECK(filters.Work());
  RelevoErrors errors(metric);
  const bool perEdge = rule == vtkDepthTagMetric::PER_EDGE;
  for (std::size_t number : { 0, 2, 5 })
  {
    CHECK_CASE(number);
    metric->OfPoints.assign(number, 1.0f);
    const std::string words = "returned " + std::to_string(number) + " tags for 4 points";
    Filters anew(metric, rule);
    CHECK(anew.Say(perEdge ? metric->GetClassName() : words));
    CHECK_EQUAL(errors.Said(words), perEdge);
  }
  metric->OfPoints = { 1.0f, 1.0f, std::nanf(""), 1.0f };
  CHECK(filters.Say("that is NaN at "));
  metric->OfPoints.assign(4, 1.0f);
  CHECK(filters.Work() && errors.None());
}

void TestEdges(RelevoCheck& check)
{
  vtkNew<GivenTags> metric;
  Filters filters(metric, vtkDepthTagMetric::PER_EDGE);
  for (std::size_t number : { 1, 4, 7 })
  {
    CHECK_CASE(number);
    metric->OfEdges.assign(number, 1.0f);
    CHECK(filters.Say("GivenTags returned " + std::to_string(number) + " tags for 6 edges"));
  }
  metric->OfEdges.assign(6, 1.0f);
  CHECK(filters.Work());
  metric->OfEdges[5] = std::nanf("");
  CHECK(filters.Say("GivenTags returned a tag that is NaN at edge 5"));
}

void TestComposite(RelevoCheck& check)
{
  vtkNew<GivenTags> metric;
  vtkNew<vtkCompositeDepthTagMetric> composite;
  composite->AddMetric(metric);
  for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
  {
    CHECK_CASE(rule);
    metric->OfEdges.clear();
    Filters filters(composite, rule);
    RelevoErrors errors(composite);
    RelevoErrors ofPart(metric);
    metric->OfPoints.assign(3, 1.0f);
    CHECK(filters.Say("vtkCompositeDepthTagMetric returned no depth-tags"));
    CHECK(errors.Said("Metric 0: GivenTags returned "));
    CHECK_EQUAL(ofPart.Said("returned 3 tags for 4 points"), (rule == vtkDepthTagMetric::PER_EDGE));
    metric->OfPoints.assign(4, 1.0f);
    CHECK(filters.Work() && errors.None());
  }
}

// The same array moves from points to cells.
void TestMovedArray(RelevoCheck& check, int rule)
{
  auto mesh = MakeTetrahedron();
  vtkNew<vtkFloatArray> field;
  field->SetName("field");
  for (float value : { 0.0f, 1.0f, 3.0f, 8.0f })
  {
    field->InsertNextValue(value);
  }
  mesh->GetPointData()->AddArray(field);
  vtkNew<vtkFieldVariationDepthTagMetric> metric;
  metric->SetArrayName("field");
  metric->SetMaximumVariation(1.0);
  const auto getLevels = [&](vtkDepthTagFilter* filter)
  {
    filter->SetInputData(mesh);
    filter->SetMetric(metric);
    filter->SetMaximumLevel(7);
    filter->SetLevelRule(rule);
    filter->Update();
    auto* levels =
      vtkIntArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("EdgeLevels"));
    return std::vector<int>(levels->GetPointer(0), levels->GetPointer(12));
  };
  vtkNew<vtkDepthTagFilter> filter;
  const std::vector<int> ofPoints = getLevels(filter);
  mesh->GetPointData()->RemoveArray("field");
  mesh->GetCellData()->AddArray(field);
  const std::vector<int> ofCells = getLevels(filter);
  CHECK_NOT_EQUAL(ofCells, ofPoints);
  CHECK_EQUAL(ofCells, getLevels(vtkNew<vtkDepthTagFilter>()));
}
}

int TestDepthTagFilterMetrics(int, char*[])
{
  RelevoCheck check;
  for (int rule : { vtkDepthTagMetric::PER_VERTEX, vtkDepthTagMetric::PER_EDGE })
  {
    CHECK_CASE(rule);
    TestPoints(check, vtkNew<GivenTags>(), rule);
    TestPoints(check, vtkNew<EvaluatedTags>(), rule);
    TestMovedArray(check, rule);
  }
  TestEdges(check);
  TestComposite(check);
  return check.GetResult();
}
