// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on budgets: relevo::TriangleBudget finds the offset closest to the target.
// PatternSelection gives the counts at the offset and just above it.
#include "RelevoCheck.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/TriangleBudget.h"
#include "Mesh/RefinementMesh.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
using Budget = relevo::TriangleBudget;
constexpr double Step = 1.0 / Budget::Resolution;
constexpr double Lowest = -16.0;
constexpr double Highest = 16.0;

// A mesh with its tags.
class Scene
{
public:
  Scene(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
    : Input(input)
    , Recipe(recipe)
  {
    this->Mesh.Build(input, recipe->GetSurface(), recipe->GetDisplacement());
    this->View.Camera = this->Camera;
    this->Camera->SetPosition(0.0, -1.0, 1.0);
    this->Camera->SetFocalPoint(0.0, 0.0, 0.0);
  }

  Budget::Part GetPart()
  {
    std::string error;
    this->Tags.Compute(this->Recipe, this->Input, this->Mesh, this->View, error);
    return { &this->Mesh, &this->Tags, relevo::GetPatternFamily(this->Recipe, this->Input) };
  }

  vtkIdType Select(double offset)
  {
    relevo::PatternSelection selection;
    selection.Select(this->Mesh, this->Tags, *relevo::GetPatternFamily(this->Recipe, this->Input),
      this->Recipe->GetMaximumLevel(), static_cast<float>(offset));
    return selection.GetNumberOfTriangles();
  }

  vtkPolyData* Input;
  vtkAdaptiveRefinement* Recipe;
  relevo::RefinementMesh Mesh;
  relevo::EdgeTags Tags;
  relevo::RefinementView View;
  vtkNew<vtkCamera> Camera;
};

vtkSmartPointer<vtkPolyData> MakePlane(int resolution)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(resolution, resolution);
  source->Update();
  return source->GetOutput();
}

void SetTags(vtkPolyData* mesh, const std::function<double(const double*)>& getTag)
{
  vtkNew<vtkFloatArray> tags;
  tags->SetName("DepthTag");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    tags->InsertNextValue(static_cast<float>(getTag(mesh->GetPoint(i))));
  }
  mesh->GetPointData()->AddArray(tags);
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(int policy, int morphing, int rule)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  metric->SetReferenceLength(1.5);
  recipe->SetMetric(metric);
  recipe->SetMaximumLevel(7); // no tag reaches it; many would change at once where tags are clamped
  recipe->SetSegmentPolicy(policy);
  recipe->SetGeomorphing(morphing);
  recipe->SetLevelRule(rule);
  return recipe;
}

// For distributed tags, the count is within the tolerance of the target, independent of the initial
// guess.
void TestSpreadTags(RelevoCheck& check, vtkAdaptiveRefinement* recipe, const std::string& name)
{
  CHECK_CASE(name);
  auto mesh = MakePlane(40);
  Scene scene(mesh, recipe);
  const Budget::Part part = scene.GetPart();
  Budget budget;
  const vtkIdType least = scene.Select(Lowest);
  const vtkIdType most = scene.Select(Highest);
  for (const double share : { 1.2, 2.0, 5.0, 20.0, 70.0, 300.0 })
  {
    CHECK_CASE(share);
    const auto target = static_cast<vtkIdType>(share * static_cast<double>(least));
    if (target > most)
    {
      continue;
    }
    const double offset =
      budget.FindOffset({ part }, recipe->GetMaximumLevel(), target, Lowest, Highest);
    const auto count = static_cast<double>(scene.Select(offset));
    CHECK_NEAR(count / static_cast<double>(target), 1.0, 0.05);
    for (const double guess : { -16.0, -3.3, offset, offset + 0.1, 1.7, 16.0 })
    {
      CHECK_CASE(guess);
      Budget fresh;
      CHECK_EQUAL(
        fresh.FindOffset({ part }, recipe->GetMaximumLevel(), target, Lowest, Highest, guess),
        offset);
    }
    CHECK_EQUAL(Budget::CountTriangles({ part }, recipe->GetMaximumLevel(), offset),
      static_cast<vtkIdType>(count));
  }
}

// If the target lies between two plateaus, the budget chooses the end of the lower one, unless
// the upper one is within the tolerance.
void TestUniformTags(RelevoCheck& check)
{
  auto mesh = MakePlane(5); // 50 faces
  SetTags(mesh, [](const double*) { return 2.25; });
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(5);
  Scene scene(mesh, recipe);
  const Budget::Part part = scene.GetPart();
  Budget budget;
  const auto find = [&](vtkIdType target, double lowest = Lowest, double highest = Highest)
  { return budget.FindOffset({ part }, recipe->GetMaximumLevel(), target, lowest, highest); };
  // Level 3 begins at offset 0.25, level 2 at -0.75.
  CHECK_NEAR(find(3000), 0.25, Step);
  CHECK_EQUAL(scene.Select(find(3000)), 800);
  CHECK_EQUAL(scene.Select(find(800)), 800);
  CHECK_EQUAL(scene.Select(find(799)), 800); // within the tolerance
  CHECK_EQUAL(scene.Select(find(3100)), 3200);
  CHECK_EQUAL(scene.Select(find(760)), 200);
  // These targets cannot be reached.
  CHECK_NEAR(find(10), -1.75, Step);
  CHECK_EQUAL(scene.Select(find(10)), 50);
  CHECK_NEAR(find(1000000000), 2.25, Step);
  CHECK_EQUAL(scene.Select(find(1000000000)), 50 * 1024);
  CHECK_EQUAL(scene.Select(find(50 * 1024)), 50 * 1024);
  // The offset has bounds.
  CHECK_EQUAL(find(3000, Lowest, 0.0), 0.0);
  CHECK_NEAR(find(10, -1.0, 0.0), -1.0, Step);
  CHECK_EQUAL(find(1000000000, Lowest, 1.0), 1.0);
  CHECK_NEAR(find(300, Lowest, 0.0), -0.75, Step);
}

// Without metric and tags, all levels are MaximumLevel. One mesh has nothing to refine.
void TestPlainRecipes(RelevoCheck& check)
{
  auto mesh = MakePlane(5);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  {
    Scene scene(mesh, recipe);
    const Budget::Part part = scene.GetPart();
    Budget budget;
    const double offset =
      budget.FindOffset({ part }, recipe->GetMaximumLevel(), 4000, Lowest, Highest);
    CHECK_NEAR(offset, -0.5, Step);
    CHECK_EQUAL(scene.Select(offset), 3200);
  }
  recipe->SetMaximumLevel(0);
  Scene scene(mesh, recipe);
  Budget budget;
  CHECK_LESS_EQUAL(std::abs(budget.FindOffset(
                     { scene.GetPart() }, recipe->GetMaximumLevel(), 4000, Lowest, Highest)),
    Step);
  vtkNew<vtkPolyData> nothing;
  Scene empty(nothing, recipe);
  CHECK_LESS_EQUAL(std::abs(budget.FindOffset(
                     { empty.GetPart() }, recipe->GetMaximumLevel(), 4000, Lowest, Highest)),
    Step);
  CHECK(std::isfinite(budget.FindOffset({}, recipe->GetMaximumLevel(), 4000, Lowest, Highest)));
}

// The result is the smallest offset that reaches the target, found by trying all. Tags are random,
// some far out of range.
void TestBruteForce(RelevoCheck& check)
{
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i)
  {
    CHECK_CASE(i);
    auto mesh = MakePlane(1 + i % 4);
    std::uniform_real_distribution<double> tag(i % 3 == 0 ? -9.0 : 0.0, i % 3 == 0 ? 9.0 : 3.0);
    SetTags(mesh, [&](const double*) { return tag(random); });
    vtkNew<vtkAdaptiveRefinement> recipe;
    recipe->SetMaximumLevel(3);
    recipe->GeomorphingOn(); // nested patterns: more segments never mean fewer triangles
    Scene scene(mesh, recipe);
    const Budget::Part part = scene.GetPart();
    Budget budget;
    const vtkIdType target = mesh->GetNumberOfCells() * (2 + i);
    const double offset =
      budget.FindOffset({ part }, recipe->GetMaximumLevel(), target, Lowest, Highest);
    const vtkIdType count = scene.Select(offset);
    const auto far = [target](vtkIdType triangles)
    {
      return triangles > 1.05 * static_cast<double>(target)
        ? std::numeric_limits<vtkIdType>::max() / 2
        : std::abs(triangles - target);
    };
    for (double other = Lowest; other < Highest; other += 0.01)
    {
      CHECK_CASE(other);
      CHECK_LESS_EQUAL(far(count), far(scene.Select(other)));
    }
  }
}

// All parts share one offset.
void TestParts(RelevoCheck& check)
{
  auto recipe = MakeRecipe(0, 0, 0);
  auto plane = MakePlane(30);
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(30);
  source->Update();
  Scene first(plane, recipe);
  Scene second(source->GetOutput(), recipe);
  Budget budget;
  const double offset = budget.FindOffset(
    { first.GetPart(), second.GetPart() }, recipe->GetMaximumLevel(), 40000, Lowest, Highest);
  CHECK_NEAR(static_cast<double>(first.Select(offset) + second.Select(offset)), 40000.0, 400.0);
}

// During a flight, the offset changes no more than the tag of some edge.
void TestFlight(RelevoCheck& check, vtkAdaptiveRefinement* recipe)
{
  auto mesh = MakePlane(60);
  Scene scene(mesh, recipe);
  Budget budget;
  double last = 0.0;
  std::vector<float> lastTags;
  for (int frame = 0; frame < 200; ++frame)
  {
    const double distance = 2.0 * std::exp2(-0.01 * frame);
    scene.Camera->SetPosition(0.0, -0.7 * distance, 0.7 * distance);
    const double offset = budget.FindOffset(
      { scene.GetPart() }, recipe->GetMaximumLevel(), 30000, Lowest, Highest, last);
    CHECK_NEAR(static_cast<double>(scene.Select(offset)), 30000.0, 1500.0);
    const float* values = scene.Tags.GetValues();
    const std::vector<float> tags(values, values + scene.Tags.GetNumberOfValues());
    if (frame > 0)
    {
      float change = 0.0f;
      for (size_t i = 0; i < tags.size(); ++i)
      {
        change = std::max(change, std::abs(tags[i] - lastTags[i]));
      }
      CHECK_LESS(change, 0.5f);
      CHECK_NEAR(offset, last, change + 2.0 * Step);
    }
    last = offset;
    lastTags = tags;
  }
}
}

int TestTriangleBudget(int, char*[])
{
  RelevoCheck check;
  for (const int rule : { 0, 1 })
  {
    CHECK_CASE(rule);
    TestSpreadTags(check, MakeRecipe(0, 0, rule), "powers of two");
    TestSpreadTags(check, MakeRecipe(0, 1, rule), "morphing");
    TestSpreadTags(check, MakeRecipe(1, 0, rule), "whole numbers");
  }
  TestUniformTags(check);
  TestPlainRecipes(check);
  TestBruteForce(check);
  TestParts(check);
  TestFlight(check, MakeRecipe(0, 1, 0));
  TestFlight(check, MakeRecipe(0, 0, 1));
  return check.GetResult();
}
