// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkLevels.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

vtkFloatArray* BenchmarkLevels::GetTags(vtkPolyData* mesh)
{
  if (!mesh->GetPointData()->HasArray("DepthTag"))
  {
    vtkNew<vtkFloatArray> tags;
    tags->SetName("DepthTag");
    tags->SetNumberOfTuples(mesh->GetNumberOfPoints());
    tags->FillValue(0.0f);
    mesh->GetPointData()->AddArray(tags);
  }
  return vtkFloatArray::SafeDownCast(mesh->GetPointData()->GetArray("DepthTag"));
}

double BenchmarkLevels::FindTags(vtkPolyData* mesh, double triangles, double low, double high,
  const std::function<void(double)>& setTags)
{
  vtkFloatArray* tags = GetTags(mesh);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(vtkRefinementPatternTable::HighestLevel);
  relevo::RefinementMesh refinementMesh;
  refinementMesh.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement());
  const auto count = [&](double number)
  {
    setTags(number);
    tags->Modified();
    relevo::EdgeTags edgeTags;
    std::string error;
    edgeTags.Compute(recipe, mesh, refinementMesh, {}, error);
    relevo::PatternSelection selection;
    selection.Select(
      refinementMesh, edgeTags, *relevo::GetPatternFamily(recipe, mesh), recipe->GetMaximumLevel());
    return static_cast<double>(selection.GetNumberOfTriangles());
  };

  for (int i = 0; i < 24; ++i)
  {
    const double middle = 0.5 * (low + high);
    (count(middle) < triangles ? low : high) = middle;
  }
  const double below = count(low);
  const double above = count(high);
  return triangles - below < above - triangles ? count(low) : above;
}

double BenchmarkLevels::SetRandomTags(vtkPolyData* mesh, double triangles)
{
  std::mt19937 random(5);
  std::vector<float> shares(static_cast<size_t>(mesh->GetNumberOfPoints()));
  std::generate(shares.begin(), shares.end(), [&random]() { return random() / 4294967296.0f; });
  vtkFloatArray* tags = GetTags(mesh);
  const double highest = vtkRefinementPatternTable::HighestLevel;
  return FindTags(mesh, triangles, 0.0, 2.0 * highest,
    [&](double range)
    {
      const double first = std::max(0.0, range - highest);
      const double last = std::min(highest, range);
      for (size_t i = 0; i < shares.size(); ++i)
      {
        tags->SetValue(
          static_cast<vtkIdType>(i), static_cast<float>(first + shares[i] * (last - first)));
      }
    });
}
