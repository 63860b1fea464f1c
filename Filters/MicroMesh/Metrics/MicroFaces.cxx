// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/MicroFaces.h"

#include "Data/LevelErrors.h"
#include "Data/MicroMeshArrays.h"
#include "Mathematics/CornerOrder.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/MicroPatternMeasure.h"
#include "Patterns/PatternFamily.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
MicroFaces::MicroFaces(std::shared_ptr<const PatternFamily> patterns, int maximumLevel)
  : Family(std::move(patterns))
  , MaximumLevel(maximumLevel)
{
}

bool MicroFaces::Take(MetricMesh& mesh, std::string& error)
{
  vtkPolyData* polyData = mesh.GetPolyData();
  if (!TakeMicroMesh(polyData, this->Micro, error))
  {
    return false;
  }
  const SurfaceTriangles& triangles = *mesh.GetTriangles();
  const vtkIdType firstCell = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  for (std::size_t t = 0; t < triangles.GetTriangles().size(); ++t)
  {
    const SurfaceTriangles::Triangle& corners = triangles.GetTriangles()[t];
    Face face{};
    face.Cell = static_cast<int>(triangles.GetCell(static_cast<vtkIdType>(t)) - firstCell);
    face.Order = { { 0, 1, 2 } };
    std::sort(face.Order.begin(), face.Order.end(),
      [&corners](int a, int b) { return corners[a] < corners[b]; });
    face.OrderCode = GetCornerOrderCode(face.Order[0], face.Order[1], face.Order[2]);
    for (int c = 0; c < 3; ++c)
    {
      face.Merged[c] = static_cast<int>(corners[face.Order[c]]);
    }
    this->Faces.push_back(face);
  }
  this->Patterns = MeasuredPatterns(this->Family, this->MaximumLevel, this->Faces.size());
  this->FindBoxes();
  this->FindErrors(polyData);
  return true;
}

void MicroFaces::FindBoxes()
{
  this->Boxes.resize(this->Faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto f = static_cast<std::size_t>(begin); f < static_cast<std::size_t>(end); ++f)
      {
        const std::vector<dvec3> positions = this->Micro.GetPositions(
          this->Micro.Faces[static_cast<std::size_t>(this->Faces[f].Cell)]);
        PointBox& box = this->Boxes[f];
        box.Low = box.High = positions.front();
        for (const dvec3& position : positions)
        {
          box.Low = min(box.Low, position);
          box.High = max(box.High, position);
        }
      }
    });
}

void MicroFaces::FindErrors(vtkPolyData* mesh)
{
  this->Errors.resize(this->Micro.Faces.size());
  if (TakeLevelErrors(mesh, this->Errors))
  {
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Errors.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto f = static_cast<std::size_t>(begin); f < static_cast<std::size_t>(end); ++f)
      {
        const auto errors = FindLevelErrors(this->Micro, this->Micro.Faces[f]);
        std::transform(errors.begin(), errors.end(), this->Errors[f].begin(),
          [](double error) { return static_cast<float>(error); });
      }
    });
}

std::vector<int> MicroFaces::FindEdges(const SurfaceEdges& edges) const
{
  std::vector<int> found;
  found.reserve(3 * this->Faces.size());
  for (const Face& face : this->Faces)
  {
    for (const auto& ends : EdgeCorners)
    {
      found.push_back(edges.FindEdge(face.Merged[ends[0]], face.Merged[ends[1]]));
    }
  }
  return found;
}

FaceDeviations MicroFaces::Measure(int face, const std::array<float, 3>& tags)
{
  const Face& which = this->Faces[face];
  const auto level = static_cast<int>(std::floor(tags[0] + 0.5f));
  const bool isUniform = tags[0] == tags[1] && tags[1] == tags[2] && level >= 0 &&
    tags[0] == static_cast<float>(level) && level <= LargestMicroLevel &&
    level <= this->MaximumLevel && !this->Family->IsMorphing();
  if (isUniform)
  {
    FaceDeviations deviations;
    deviations.Inside = this->Errors[static_cast<std::size_t>(which.Cell)][level];
    return deviations;
  }
  return this->Patterns.Measure(face, which.OrderCode, tags,
    [&](const FacePattern& pattern)
    {
      return MeasureMicroPattern(
        this->Micro, this->Micro.Faces[static_cast<std::size_t>(which.Cell)], which.Order, pattern);
    });
}
}
