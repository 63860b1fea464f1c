// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/SampledFaces.h"

#include "Evaluation/FaceMeasure.h"
#include "Evaluation/HoleFinder.h"
#include "Levels/EdgeLevels.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/FaceEdges.h"
#include "Patterns/FacePattern.h"
#include "Patterns/PatternFamily.h"
#include "Surfaces/HeightRanges.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// A view that moves for long needs ever more patterns. Each entry takes 20 bytes.
constexpr std::size_t MaximumNumberOfEntries = 64;
}

struct SampledFaces::Internals
{
  std::unique_ptr<HoleFinder> Holes;
  std::unique_ptr<FaceMeasure> Measure;
};

SampledFaces::SampledFaces()
  : Data(new Internals)
{
}

SampledFaces::~SampledFaces() = default;

void SampledFaces::Take(
  vtkAdaptiveRefinement* recipe, std::shared_ptr<const PatternFamily> patterns)
{
  this->Family = std::move(patterns);
  this->MaximumLevel = recipe->GetMaximumLevel();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  const HeightValidity validity = GetHoles(displacement);
  if (validity.Samples)
  {
    this->Data->Holes = std::make_unique<HoleFinder>(this->Mesh, validity);
  }
  this->Data->Measure = std::make_unique<FaceMeasure>(this->Mesh, recipe, this->Data->Holes.get());
  this->Entries.resize(this->Mesh.Faces.size());
  this->Boxes.resize(this->Mesh.Faces.size());
  const HeightRanges ranges(displacement->GetHeightMap());
  const FaceBounds bounds(this->Mesh, recipe->GetSurface(), displacement, &ranges);
  const dvec3 origin(this->Mesh.Origin[0], this->Mesh.Origin[1], this->Mesh.Origin[2]);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        PointBox& box = this->Boxes[f];
        bounds.GetBox(static_cast<std::size_t>(f), &box.Low[0], &box.High[0]);
        box.Low += origin;
        box.High += origin;
      }
    });
}

int SampledFaces::GetNumberOfFaces() const
{
  return static_cast<int>(this->Mesh.Faces.size());
}

std::array<int, 3> SampledFaces::GetMergedPoints(int face) const
{
  std::array<int, 3> points;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = this->Mesh.GetMergedPoint(this->Mesh.Faces[face].Corners[i]);
  }
  return points;
}

std::vector<int> SampledFaces::FindEdges(const SurfaceEdges& edges) const
{
  return FindFaceEdges(this->Mesh, edges);
}

PointBox SampledFaces::GetBox(int face) const
{
  return this->Boxes[face];
}

// Patterns that morph differ by the quarters of levels to which means of two tags can be rounded.
unsigned int SampledFaces::GetKey(const int steps[3], const std::array<float, 3>& tags) const
{
  unsigned int key = 0;
  for (int e = 0; e < 3; ++e)
  {
    key = key << 8 |
      static_cast<unsigned int>(
        this->Family->IsMorphing() ? std::lround(4.0f * tags[e]) : long{ steps[e] });
  }
  return key;
}

FaceDeviations SampledFaces::Measure(int face, const std::array<float, 3>& given)
{
  int steps[3];
  std::array<float, 3> tags;
  std::array<float, 3> morphTags;
  for (int e = 0; e < 3; ++e)
  {
    tags[e] = clampTag(given[e], 0.0f, this->MaximumLevel);
    steps[e] = this->Family->AreWholeNumbers() ? SegmentSteps::GetWholeNumberStep(tags[e])
                                               : levelOfTag(tags[e]);
    morphTags[e] = morphTag(tags[e], this->MaximumLevel);
  }
  const unsigned int key = this->GetKey(steps, tags);
  std::vector<Entry>& entries = this->Entries[face];
  for (const Entry& entry : entries)
  {
    if (entry.Key == key)
    {
      return entry.Deviations;
    }
  }
  const unsigned int entry =
    this->Family->GetEntry(this->Mesh.Faces[face].Order, steps[0], steps[1], steps[2]);
  const int patternKey = static_cast<int>(entry >> 3);
  const FacePattern pattern{ this->Family->GetPattern(patternKey).get(),
    static_cast<int>(entry & 7u), PatternFamily::IsMirrored(patternKey),
    this->Family->IsMorphing() ? morphTags.data() : nullptr };
  if (entries.size() >= MaximumNumberOfEntries)
  {
    entries.clear();
  }
  entries.push_back({ key, this->Data->Measure->Measure(face, pattern) });
  return entries.back().Deviations;
}
}
