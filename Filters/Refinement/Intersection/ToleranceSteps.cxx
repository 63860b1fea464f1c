// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection/ToleranceSteps.h"

#include "Evaluation/PatternSelection.h"
#include "Intersection/PatternDeviation.h"
#include "Intersection/RefinedSurface.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/PatternFamily.h"
#include "Recipe/RecipeLevels.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// The number of parts of a face's edge between measured points. Surfaces are smooth, and heights
// are smooth between their texels.
constexpr int MinimumParts = 16;
}

void ToleranceSteps::Take(const RefinementMesh& mesh, const RefinedSurface& surface,
  vtkAdaptiveRefinement* recipe, std::vector<int> faceEdges, int numberOfEdges)
{
  this->Mesh = &mesh;
  this->Surface = &surface;
  this->Family = GetRoundedPatternFamily(recipe);
  const int level = recipe->GetMaximumLevel();
  this->HighestStep = this->Family->AreWholeNumbers()
    ? SegmentSteps::GetWholeNumberStep(static_cast<float>(level))
    : level;
  this->MaximumParts = std::max(MinimumParts, 2 << level);
  std::fill_n(this->Texels, 2, 0);
  if (recipe->GetDisplacement() && recipe->GetDisplacement()->GetHeightMap())
  {
    recipe->GetDisplacement()->GetHeightMap()->GetDimensions(this->Texels);
  }
  this->FaceEdges = std::move(faceEdges);
  this->EdgeSteps.assign(static_cast<std::size_t>(numberOfEdges), 0);
  this->Tolerance = -1.0;
}

FacePattern ToleranceSteps::MakePattern(int face, const Steps& steps) const
{
  const unsigned int entry =
    this->Family->GetEntry(this->Mesh->Faces[face].Order, steps[0], steps[1], steps[2]);
  const int key = static_cast<int>(entry >> 3);
  return { this->Family->GetPattern(key).get(), static_cast<int>(entry & 7u),
    PatternFamily::IsMirrored(key), nullptr };
}

ToleranceSteps::Steps ToleranceSteps::GetSteps(int face) const
{
  const int* edges = &this->FaceEdges[3 * static_cast<std::size_t>(face)];
  return { this->EdgeSteps[edges[0]], this->EdgeSteps[edges[1]], this->EdgeSteps[edges[2]] };
}

int ToleranceSteps::CountParts(int face) const
{
  double texels = 0.0;
  if (!this->Mesh->TextureCoordinates.empty())
  {
    const auto [a, b, c] = this->Mesh->Faces[face].Corners;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto get = [&](int point)
      { return this->Mesh->TextureCoordinates[2 * static_cast<std::size_t>(point) + axis]; };
      const auto range = std::minmax({ get(a), get(b), get(c) });
      texels = std::max<double>(texels, (range.second - range.first) * this->Texels[axis]);
    }
  }
  return texels < this->MaximumParts ? std::max(MinimumParts, static_cast<int>(std::ceil(texels)))
                                     : this->MaximumParts;
}

// The deviation of smooth surfaces is proportional to the square of the segments' length.
int ToleranceSteps::GetNextStep(int step, double deviation) const
{
  const SegmentSteps& steps = this->Family->GetSegmentSteps();
  const double growth = std::min(2.0, std::sqrt(deviation / this->Tolerance));
  const int wanted = steps.FindStep(static_cast<int>(std::ceil(growth * steps.GetSegments(step))));
  return std::min(this->HighestStep, std::max(step + 1, wanted));
}

void ToleranceSteps::FindOwnStep(int face, PatternDeviation& deviation)
{
  const int parts = this->CountParts(face);
  int step = 0;
  double measured = deviation.Measure(face, this->MakePattern(face, { 0, 0, 0 }), parts);
  while (measured > this->Tolerance && step < this->HighestStep)
  {
    step = this->GetNextStep(step, measured);
    measured = deviation.Measure(face, this->MakePattern(face, { step, step, step }), parts);
  }
  this->OwnSteps[face] = static_cast<signed char>(step);
  this->OwnDeviations[face] = measured;
}

void ToleranceSteps::FindOwnSteps(const std::vector<int>& faces)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      PatternDeviation deviation(this->Surface->GetEvaluator(), this->Surface->GetHoles());
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (this->OwnSteps[faces[i]] < 0)
        {
          this->FindOwnStep(faces[i], deviation);
        }
      }
    });
}

void ToleranceSteps::ShareOwnSteps(const std::vector<int>& faces)
{
  std::fill(this->EdgeSteps.begin(), this->EdgeSteps.end(), 0);
  for (int face : faces)
  {
    const int step = this->Tolerance > 0.0 ? this->OwnSteps[face] : this->HighestStep;
    for (int e = 0; e < 3; ++e)
    {
      unsigned char& shared =
        this->EdgeSteps[this->FaceEdges[3 * static_cast<std::size_t>(face) + e]];
      shared = std::max(shared, static_cast<unsigned char>(step));
    }
  }
}

std::vector<double> ToleranceSteps::Measure(const std::vector<int>& faces) const
{
  std::vector<double> deviations(faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      PatternDeviation deviation(this->Surface->GetEvaluator(), this->Surface->GetHoles());
      for (vtkIdType i = begin; i < end; ++i)
      {
        const int face = faces[i];
        const int own = this->OwnSteps[face];
        const Steps steps = this->GetSteps(face);
        deviations[i] = steps == Steps{ own, own, own }
          ? this->OwnDeviations[face]
          : deviation.Measure(face, this->MakePattern(face, steps), this->CountParts(face));
      }
    });
  return deviations;
}

bool ToleranceSteps::Raise(const std::vector<int>& faces, const std::vector<double>& deviations)
{
  const std::vector<unsigned char> before = this->EdgeSteps;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (deviations[i] <= this->Tolerance)
    {
      continue;
    }
    const int* edges = &this->FaceEdges[3 * static_cast<std::size_t>(faces[i])];
    const int least = std::min({ before[edges[0]], before[edges[1]], before[edges[2]] });
    const auto next = static_cast<unsigned char>(this->GetNextStep(least, deviations[i]));
    for (int e = 0; e < 3; ++e)
    {
      this->EdgeSteps[edges[e]] = std::max(this->EdgeSteps[edges[e]], next);
    }
  }
  return this->EdgeSteps != before;
}

std::pair<vtkIdType, double> ToleranceSteps::Choose(
  const std::vector<unsigned char>& areWanted, double tolerance)
{
  if (!(std::abs(tolerance - this->Tolerance) <=
        1e-9 * tolerance)) // tolerates rounding by rotations
  {
    this->Tolerance = tolerance;
    this->OwnSteps.assign(areWanted.size(), -1);
    this->OwnDeviations.assign(areWanted.size(), 0.0);
  }
  std::vector<int> faces;
  for (std::size_t face = 0; face < areWanted.size(); ++face)
  {
    if (areWanted[face] != 0)
    {
      faces.push_back(static_cast<int>(face));
    }
  }
  if (!(tolerance > 0.0))
  {
    this->ShareOwnSteps(faces);
    return { 0, 0.0 };
  }
  this->FindOwnSteps(faces);
  this->ShareOwnSteps(faces);
  std::vector<double> deviations = this->Measure(faces);
  while (this->Raise(faces, deviations))
  {
    deviations = this->Measure(faces);
  }
  std::pair<vtkIdType, double> warning(0, 0.0);
  for (double deviation : deviations)
  {
    if (deviation > tolerance)
    {
      ++warning.first;
      warning.second = std::max(warning.second, deviation);
    }
  }
  return warning;
}
}
