// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceVectors.h"

#include "Arrays/VectorData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// Sine of the angle below which a triangle is degenerate.
constexpr double MinimumSine = 1e-10;

// Returns the corner of a triangle that is neither a nor b.
int FindThirdCorner(const relevo::SurfaceTriangles::Triangle& triangle, vtkIdType a, vtkIdType b)
{
  int corner = 0;
  while (triangle[corner] == a || triangle[corner] == b)
  {
    ++corner;
  }
  return corner;
}
}

namespace relevo
{
SurfaceVectors::SurfaceVectors(
  vtkPolyData* mesh, vtkDataArray* vectors, bool isCellData, double noDataMagnitude)
  : Edges(mesh)
{
  const SurfaceTriangles& triangles = this->GetTriangles();
  this->Points.resize(triangles.GetNumberOfPoints());
  for (std::size_t point = 0; point < this->Points.size(); ++point)
  {
    triangles.GetPoint(static_cast<vtkIdType>(point), this->Points[point].data());
  }

  this->FindLongest(vectors, noDataMagnitude);
  this->Facets.resize(triangles.GetTriangles().size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Facets.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int triangle = static_cast<int>(begin); triangle < end; ++triangle)
      {
        this->SetRates(triangle, vectors, isCellData, noDataMagnitude);
      }
    });
  this->FindNeighbors();
}

void SurfaceVectors::FindLongest(vtkDataArray* vectors, double noDataMagnitude)
{
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    if (IsVectorData(v, 3, noDataMagnitude))
    {
      this->Longest = std::max(this->Longest, vtkMath::Norm(v));
    }
  }
}

void SurfaceVectors::SetRates(
  int triangle, vtkDataArray* vectors, bool isCellData, double noDataMagnitude)
{
  Facet& facet = this->Facets[triangle];
  std::fill_n(facet.Neighbors, 3, -1);
  double a[3];
  double b[3];
  double normal[3];
  vtkMath::Subtract(this->GetCorner(triangle, 1).data(), this->GetCorner(triangle, 0).data(), a);
  vtkMath::Subtract(this->GetCorner(triangle, 2).data(), this->GetCorner(triangle, 0).data(), b);
  vtkMath::Cross(a, b, normal);
  facet.Metric[0] = vtkMath::Dot(a, a);
  facet.Metric[1] = vtkMath::Dot(a, b);
  facet.Metric[2] = vtkMath::Dot(b, b);
  const double squaredArea = vtkMath::Dot(normal, normal); // of the parallelogram
  const double longestSide = std::max({ facet.Metric[0], facet.Metric[2],
    facet.Metric[0] - 2.0 * facet.Metric[1] + facet.Metric[2] });
  const double line = MinimumSine * longestSide;
  facet.Blocked = !(squaredArea > line * line) || !std::isfinite(squaredArea);

  const SurfaceTriangles& triangles = this->GetTriangles();
  for (int corner = 0; corner < 3; ++corner)
  {
    double v[3];
    vectors->GetTuple(
      isCellData ? triangles.GetCell(triangle) : triangles.GetPoints(triangle)[corner], v);
    facet.Blocked = facet.Blocked || !IsVectorData(v, 3, noDataMagnitude);
    const bool isZero = facet.Blocked || this->Longest == 0.0;
    const double alongA = isZero ? 0.0 : vtkMath::Dot(v, a) / this->Longest;
    const double alongB = isZero ? 0.0 : vtkMath::Dot(v, b) / this->Longest;
    const double scale = isZero ? 0.0 : 1.0 / squaredArea;
    facet.Rates[corner][0] = (facet.Metric[2] * alongA - facet.Metric[1] * alongB) * scale;
    facet.Rates[corner][1] = (facet.Metric[0] * alongB - facet.Metric[1] * alongA) * scale;
  }
}

void SurfaceVectors::FindNeighbors()
{
  const auto& triangles = this->GetTriangles().GetTriangles();
  const auto& sides = this->Edges.GetSides();
  for (const SurfaceEdgeSides& side : sides)
  {
    const int* pair = side.Triangles;
    if (side.Type == SurfaceEdgeSides::OPEN || this->IsBlocked(pair[0]) || this->IsBlocked(pair[1]))
    {
      continue;
    }
    const int* mergedPoints = this->Edges.GetEdges()[side.Edge].MergedPoints;
    for (int i = 0; i < 2; ++i)
    {
      const int corner = FindThirdCorner(triangles[pair[i]], mergedPoints[0], mergedPoints[1]);
      this->Facets[pair[i]].Neighbors[corner] = pair[1 - i];
    }
  }
}

SurfaceVectors::Vector SurfaceVectors::GetPosition(int triangle, const Weights& weights) const
{
  Vector position{};
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vector& point = this->GetCorner(triangle, corner);
    for (int i = 0; i < 3; ++i)
    {
      position[i] += weights[corner] * point[i];
    }
  }
  return position;
}

SurfaceVectors::Weights SurfaceVectors::GetNeighborWeights(
  int triangle, int corner, const Weights& weights, int& third) const
{
  const auto& triangles = this->GetTriangles().GetTriangles();
  const int next = this->GetNeighbor(triangle, corner);
  const vtkIdType first = triangles[triangle][(corner + 1) % 3];
  third = FindThirdCorner(triangles[next], first, triangles[triangle][(corner + 2) % 3]);
  const bool hasSameOrder = triangles[next][(third + 1) % 3] == first;
  Weights beyond{};
  beyond[(third + (hasSameOrder ? 1 : 2)) % 3] = weights[(corner + 1) % 3];
  beyond[(third + (hasSameOrder ? 2 : 1)) % 3] = weights[(corner + 2) % 3];
  return beyond;
}

double SurfaceVectors::GetSquaredSide(int triangle, int corner) const
{
  const double* metric = this->Facets[triangle].Metric;
  return corner == 1 ? metric[2]
    : corner == 2    ? metric[0]
                     : metric[0] - 2.0 * metric[1] + metric[2];
}

double SurfaceVectors::GetHeight(int triangle, int corner) const
{
  const double* metric = this->Facets[triangle].Metric;
  const double squaredArea = metric[0] * metric[2] - metric[1] * metric[1];
  return std::sqrt(std::max(squaredArea, 0.0) / this->GetSquaredSide(triangle, corner));
}

double SurfaceVectors::GetFoot(int triangle, int corner) const
{
  // The side to the first end is opposite to the second end.
  const double toFirst = this->GetSquaredSide(triangle, (corner + 2) % 3);
  const double toSecond = this->GetSquaredSide(triangle, (corner + 1) % 3);
  const double side = this->GetSquaredSide(triangle, corner);
  return 0.5 * (toFirst - toSecond + side) / side;
}
}
