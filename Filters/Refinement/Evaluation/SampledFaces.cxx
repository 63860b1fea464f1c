// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/SampledFaces.h"

#include "Evaluation/FaceMeasure.h"
#include "Evaluation/HoleFinder.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/FaceEdges.h"
#include "Surfaces/HeightRanges.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkSMPTools.h"

#include <utility>

namespace relevo
{
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
  this->Patterns =
    MeasuredPatterns(std::move(patterns), recipe->GetMaximumLevel(), this->Mesh.Faces.size());
  vtkDisplacement* displacement = recipe->GetDisplacement();
  const HeightValidity validity = GetHoles(displacement);
  if (validity.Samples)
  {
    this->Data->Holes = std::make_unique<HoleFinder>(this->Mesh, validity);
  }
  this->Data->Measure = std::make_unique<FaceMeasure>(this->Mesh, recipe, this->Data->Holes.get());
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

FaceDeviations SampledFaces::Measure(int face, const std::array<float, 3>& tags)
{
  return this->Patterns.Measure(face, this->Mesh.Faces[face].Order, tags,
    [&](const FacePattern& pattern) { return this->Data->Measure->Measure(face, pattern); });
}
}
