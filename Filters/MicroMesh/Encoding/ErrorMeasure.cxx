// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/ErrorMeasure.h"

#include "Distance/DistanceBound.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
void ErrorMeasure::BuildGrids(const MicroMesh& mesh)
{
  const std::size_t number = mesh.Faces.size();
  this->FirstPoints.assign(number + 1, 0);
  this->FirstTriangles.assign(number + 1, 0);
  for (std::size_t f = 0; f < number; ++f)
  {
    const int n = 1 << mesh.Faces[f].Level;
    this->FirstPoints[f + 1] =
      this->FirstPoints[f] + static_cast<std::size_t>(GetNumberOfGridPoints(n));
    this->FirstTriangles[f + 1] = this->FirstTriangles[f] + static_cast<std::size_t>(n * n);
  }
  this->GridPoints.resize(this->FirstPoints[number]);
  this->GridTriangles.resize(this->FirstTriangles[number]);
  vtkSMPTools::For(0, static_cast<vtkIdType>(number),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        const std::vector<dvec3> positions = mesh.GetPositions(mesh.Faces[f]);
        const auto firstPoint = static_cast<std::ptrdiff_t>(this->FirstPoints[f]);
        std::copy(positions.begin(), positions.end(), this->GridPoints.begin() + firstPoint);
        std::size_t t = this->FirstTriangles[f];
        const int offset = static_cast<int>(firstPoint);
        ForEachGridTriangle(1 << mesh.Faces[f].Level,
          [&](int a, int b, int c) {
            this->GridTriangles[t++] = { { offset + a, offset + b, offset + c } };
          });
      }
    });
}

double ErrorMeasure::Reduce(const std::vector<double>& bounds2, std::vector<char>& failed)
{
  double largest = 0.0;
  failed.assign(bounds2.size(), 0);
  for (std::size_t i = 0; i < bounds2.size(); ++i)
  {
    failed[i] = std::isinf(bounds2[i]) ? 1 : 0;
    this->Failed = this->Failed || failed[i] != 0;
    largest = failed[i] != 0 ? largest : std::max(largest, bounds2[i]);
  }
  return std::sqrt(largest);
}

void ErrorMeasure::MeasureFaces(const std::function<bool()>& isAborted)
{
  const DistanceBound bound(this->Surface, this->Tolerance);
  std::vector<double>& bounds2 = this->FaceBounds2;
  vtkSMPTools::For(0, static_cast<vtkIdType>(bounds2.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<DistanceBound::Corner> corners;
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        if (bounds2[f] >= 0.0 || isAborted())
        {
          continue;
        }
        bounds2[f] = 0.0;
        corners.clear();
        const std::size_t firstPoint = this->FirstPoints[f];
        for (std::size_t p = firstPoint; p < this->FirstPoints[f + 1]; ++p)
        {
          corners.push_back(
            bound.FindCorner(this->GridPoints[p], corners.empty() ? -1 : corners.back().Nearest));
        }
        for (std::size_t t = this->FirstTriangles[f];
             t < this->FirstTriangles[f + 1] && !std::isinf(bounds2[f]); ++t)
        {
          const auto corner = [&](int c) -> const DistanceBound::Corner&
          { return corners[static_cast<std::size_t>(this->GridTriangles[t][c]) - firstPoint]; };
          bounds2[f] = std::max(bounds2[f], bound.GetBound2(corner(0), corner(1), corner(2)));
        }
      }
    });
  this->ResultToInput = this->Reduce(bounds2, this->FailedFaces);
}

void ErrorMeasure::MeasureTriangles(const BaseMesh& base, const std::function<bool()>& isAborted)
{
  const TriangleTree result(this->GridPoints, this->GridTriangles);
  const DistanceBound bound(result, this->Tolerance);
  std::vector<DistanceBound::Corner> corners(this->Dense.Points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto v = static_cast<std::size_t>(first);
           v < static_cast<std::size_t>(last) && !isAborted(); ++v)
      {
        corners[v] = bound.FindCorner(this->Dense.Points[v]);
      }
    });
  std::vector<char> isOriginal(this->Dense.Triangles.size(), 0);
  for (std::size_t f = 0; f < base.Mesh.Faces.size(); ++f)
  {
    isOriginal[static_cast<std::size_t>(base.Triangles[f])] =
      base.IsOriginal(base.Mesh.Faces[f]) ? 1 : 0;
  }
  std::vector<double> bounds2(this->Dense.Triangles.size(), 0.0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(bounds2.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto t = static_cast<std::size_t>(first); t < static_cast<std::size_t>(last); ++t)
      {
        const DenseMesh::Triangle& triangle = this->Dense.Triangles[t];
        if (isOriginal[t] == 0 && !isAborted())
        {
          bounds2[t] = bound.GetBound2(corners[static_cast<std::size_t>(triangle[0])],
            corners[static_cast<std::size_t>(triangle[1])],
            corners[static_cast<std::size_t>(triangle[2])]);
        }
      }
    });
  this->InputToResult = this->Reduce(bounds2, this->FailedTriangles);
  this->FailNearFaces(result);
}

void ErrorMeasure::FailNearFaces(const TriangleTree& result)
{
  for (std::size_t t = 0; t < this->FailedTriangles.size(); ++t)
  {
    if (this->FailedTriangles[t] == 0)
    {
      continue;
    }
    dvec3 middle(0.0);
    for (int vertex : this->Dense.Triangles[t])
    {
      middle += this->Dense.Points[static_cast<std::size_t>(vertex)] / 3.0;
    }
    double distance2 = std::numeric_limits<double>::infinity();
    int nearest = -1;
    result.FindNearest(middle, distance2, nearest);
    const auto face = std::upper_bound(
      this->FirstTriangles.begin(), this->FirstTriangles.end(), static_cast<std::size_t>(nearest));
    this->FailedFaces[static_cast<std::size_t>(face - this->FirstTriangles.begin() - 1)] = 1;
  }
}

bool ErrorMeasure::IsSameFace(const std::vector<dvec3>& lastPoints,
  const std::vector<std::size_t>& lastFirsts, std::size_t face) const
{
  const auto first =
    this->GridPoints.begin() + static_cast<std::ptrdiff_t>(this->FirstPoints[face]);
  const auto last =
    this->GridPoints.begin() + static_cast<std::ptrdiff_t>(this->FirstPoints[face + 1]);
  return last - first == static_cast<std::ptrdiff_t>(lastFirsts[face + 1] - lastFirsts[face]) &&
    std::equal(first, last, lastPoints.begin() + static_cast<std::ptrdiff_t>(lastFirsts[face]));
}

bool ErrorMeasure::Run(
  const BaseMesh& base, const MicroMesh& mesh, const std::function<bool()>& isAborted)
{
  this->Failed = false;
  const std::vector<dvec3> lastPoints = std::move(this->GridPoints);
  const std::vector<std::size_t> lastFirsts = std::move(this->FirstPoints);
  this->GridPoints = {};
  this->BuildGrids(mesh);
  this->FaceBounds2.resize(mesh.Faces.size(), -1.0); // not measured
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    if (base.IsOriginal(mesh.Faces[f]))
    {
      this->FaceBounds2[f] = 0.0;
    }
    else if (!lastFirsts.empty() && !this->IsSameFace(lastPoints, lastFirsts, f))
    {
      this->FaceBounds2[f] = -1.0;
    }
  }
  this->MeasureFaces(isAborted);
  if (!isAborted())
  {
    this->MeasureTriangles(base, isAborted);
  }
  return !isAborted();
}
}
