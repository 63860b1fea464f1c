// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceTexels.h"

#include "Mesh/SurfaceTriangles.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>

namespace
{
// Returns twice the area of the triangle (a, b, p), positive if p is to the left of a -> b.
double GetDoubleArea(const double a[2], const double b[2], const double p[2])
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

// Accepts centres on a side despite rounding errors of float texture coordinates.
constexpr double MinimumWeight = -1e-5;

// Computes the barycentric coordinates of a point. Returns false outside of the triangle.
bool FindWeights(
  const double x[3], const double y[3], const double p[2], std::array<double, 3>& weights)
{
  double area = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const int i = (corner + 1) % 3;
    const int j = (corner + 2) % 3;
    const double a[2] = { x[i], y[i] };
    const double b[2] = { x[j], y[j] };
    weights[corner] = GetDoubleArea(a, b, p);
    area += weights[corner];
  }
  double sum = 0.0;
  for (double& weight : weights)
  {
    weight /= area;
    if (!(weight >= MinimumWeight)) // also true for the NaN of a triangle without area
    {
      return false;
    }
    weight = std::max(weight, 0.0);
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return true;
}
}

namespace relevo
{
SurfaceTexels::SurfaceTexels(
  const int size[2], const SurfaceTriangles& surface, vtkDataArray* coordinates)
  : Size{ size[0], size[1] }
  , Surface(surface)
  , Coordinates(coordinates)
  , Triangles(static_cast<std::size_t>(size[0]) * size[1], -1)
{
  for (std::size_t triangle = 0; triangle < surface.GetTriangles().size(); ++triangle)
  {
    this->Cover(static_cast<int>(triangle));
  }
}

// Computes the corners in texels, relative to the centre of the first texel.
bool SurfaceTexels::GetCorners(int triangle, Corners& corners) const
{
  bool finite = true;
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType point = this->Surface.GetPoints(triangle)[i];
    corners.X[i] = this->Coordinates->GetComponent(point, 0) * this->Size[0] - 0.5;
    corners.Y[i] = this->Coordinates->GetComponent(point, 1) * this->Size[1] - 0.5;
    finite = finite && std::isfinite(corners.X[i]) && std::isfinite(corners.Y[i]);
  }
  return finite;
}

void SurfaceTexels::Cover(int triangle)
{
  Corners corners;
  if (!this->GetCorners(triangle, corners))
  {
    return;
  }
  const auto first = [](const double* x) {
    return std::ceil(std::max(std::min({ x[0], x[1], x[2] }) + MinimumWeight, 0.0));
  };
  const auto last = [](const double* x, int size) {
    return std::floor(std::min(std::max({ x[0], x[1], x[2] }) - MinimumWeight, size - 1.0));
  };
  const double lastColumn = last(corners.X, this->Size[0]);
  const double lastRow = last(corners.Y, this->Size[1]);
  for (double row = first(corners.Y); row <= lastRow; ++row)
  {
    for (double column = first(corners.X); column <= lastColumn; ++column)
    {
      const double centre[2] = { column, row };
      int& owner =
        this->Triangles[static_cast<vtkIdType>(row) * this->Size[0] + static_cast<int>(column)];
      Weights weights;
      if (owner < 0 && FindWeights(corners.X, corners.Y, centre, weights))
      {
        owner = triangle;
        ++this->NumberOfCoveredTexels;
      }
    }
  }
}

SurfaceTexels::Weights SurfaceTexels::GetWeights(vtkIdType texel) const
{
  Corners corners{};
  this->GetCorners(this->Triangles[texel], corners);
  const double centre[2] = { static_cast<double>(texel % this->Size[0]),
    static_cast<double>(texel / this->Size[0]) };
  Weights weights;
  FindWeights(corners.X, corners.Y, centre, weights);
  return weights;
}

// Two sweeps propagate the nearest covered texel between neighbours (Danielsson, "Euclidean
// Distance Mapping", 1980).
std::vector<vtkIdType> SurfaceTexels::FindNearestCovered() const
{
  const vtkIdType width = this->Size[0];
  const vtkIdType height = this->Size[1];
  std::vector<vtkIdType> nearest(this->Triangles.size());
  for (std::size_t texel = 0; texel < nearest.size(); ++texel)
  {
    nearest[texel] = this->Triangles[texel] < 0 ? -1 : static_cast<vtkIdType>(texel);
  }
  const auto squaredDistance = [=](vtkIdType a, vtkIdType b)
  {
    const vtkIdType dx = a % width - b % width;
    const vtkIdType dy = a / width - b / width;
    return dx * dx + dy * dy;
  };
  const auto updateNearest = [&](vtkIdType x, vtkIdType y, int dx, int dy)
  {
    if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height)
    {
      return;
    }
    const vtkIdType texel = y * width + x;
    const vtkIdType candidate = nearest[(y + dy) * width + x + dx];
    if (candidate >= 0 &&
      (nearest[texel] < 0 ||
        squaredDistance(texel, candidate) < squaredDistance(texel, nearest[texel])))
    {
      nearest[texel] = candidate;
    }
  };
  for (int sweep = 0; sweep < 2; ++sweep)
  {
    const int back = sweep ? 1 : -1; // to the previous row of the sweep
    for (vtkIdType i = 0; i < height; ++i)
    {
      const vtkIdType y = sweep ? height - 1 - i : i;
      for (vtkIdType x = 0; x < width; ++x)
      {
        updateNearest(x, y, -1, 0);
        updateNearest(x, y, -1, back);
        updateNearest(x, y, 0, back);
        updateNearest(x, y, 1, back);
      }
      for (vtkIdType x = width - 1; x >= 0; --x)
      {
        updateNearest(x, y, 1, 0);
      }
    }
  }
  return nearest;
}
}
