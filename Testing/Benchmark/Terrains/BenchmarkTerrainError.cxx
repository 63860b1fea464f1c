// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainError.h"

#include "BenchmarkRaster.h"
#include "Bisection/AdaptiveTerrain.h"
#include "vtkTerrainPyramid.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace
{
// Barycentric coordinates of the second and third corner.
constexpr double Barycentric[][2] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 }, { 0.5, 0.0 },
  { 0.0, 0.5 }, { 0.5, 0.5 }, { 1.0 / 3.0, 1.0 / 3.0 }, { 0.2, 0.2 }, { 0.6, 0.2 }, { 0.2, 0.6 },
  { 0.23, 0.41 }, { 0.71, 0.13 } };
}

BenchmarkTerrainError::BenchmarkTerrainError(
  const BenchmarkRaster& raster, vtkTerrainPyramid* pyramid)
  : Raster(raster)
  , Placement(relevo::AdaptiveTerrain(pyramid->GetLattice()).GetPlacement(1.0))
{
}

void BenchmarkTerrainError::SetCamera(vtkCamera* camera, const int viewport[2])
{
  this->HasCamera = true;
  camera->GetPosition(this->Eye.data());
  camera->GetFrustumPlanes(static_cast<double>(viewport[0]) / viewport[1], this->Planes);
  this->Factor =
    viewport[1] / (2.0 * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0));
}

bool BenchmarkTerrainError::IsInView(const Point& point) const
{
  constexpr int sides = 4; // without the near and far planes
  for (int i = 0; i < sides; ++i)
  {
    const double* plane = &this->Planes[4 * i];
    if (plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] < 0.0)
    {
      return false;
    }
  }
  return true;
}

double BenchmarkTerrainError::MeasurePoint(const Point& point) const
{
  const double column = (point[0] - this->Placement.Origin[0]) / this->Placement.Column[0];
  const double row = (point[1] - this->Placement.Origin[1]) / this->Placement.Row[1];
  const double distance =
    std::abs(point[2] - this->Raster.Interpolate(column, row) * this->Placement.HeightScale);
  return this->HasCamera ? distance * this->Factor /
      std::sqrt(vtkMath::Distance2BetweenPoints(point.data(), this->Eye.data()))
                         : distance;
}

double BenchmarkTerrainError::MeasureTriangle(
  const Triangle& triangle, bool onlyInView, bool& isInView) const
{
  double largest = 0.0;
  for (const auto& weights : Barycentric)
  {
    Point point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = triangle[0][axis] + weights[0] * (triangle[1][axis] - triangle[0][axis]) +
        weights[1] * (triangle[2][axis] - triangle[0][axis]);
    }
    if (!onlyInView || this->IsInView(point))
    {
      isInView = true;
      largest = std::max(largest, this->MeasurePoint(point));
    }
  }
  return largest;
}

double BenchmarkTerrainError::Measure(vtkPolyData* mesh) const
{
  std::vector<Triangle> triangles;
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = mesh->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners);)
  {
    triangles.emplace_back();
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(corners->GetId(i), triangles.back()[i].data());
    }
  }
  vtkSMPThreadLocal<double> largest(0.0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      double& error = largest.Local();
      bool isInView = false;
      for (vtkIdType i = begin; i < end; ++i)
      {
        error = std::max(error, this->MeasureTriangle(triangles[i], false, isInView));
      }
    });
  return *std::max_element(largest.begin(), largest.end());
}

BenchmarkTerrainError::Grid BenchmarkTerrainError::MeasureGrid(double spacing, double limit) const
{
  const auto columns = static_cast<vtkIdType>((this->Raster.GetWidth() - 1) / spacing);
  const auto rows = static_cast<vtkIdType>((this->Raster.GetHeight() - 1) / spacing);
  const auto getPoint = [&](vtkIdType column, vtkIdType row)
  {
    const double x = static_cast<double>(column) * spacing;
    const double y = static_cast<double>(row) * spacing;
    return this->Placement.ToWorld(x, y, this->Raster.Interpolate(x, y));
  };
  vtkSMPThreadLocal<Grid> parts(Grid{ 0.0, 0.0 });
  std::atomic<bool> isBeyond{ false };
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      Grid& part = parts.Local();
      for (vtkIdType row = begin; row < end && !isBeyond; ++row)
      {
        for (vtkIdType column = 0; column < columns; ++column)
        {
          const Triangle triangles[] = {
            { { getPoint(column, row), getPoint(column + 1, row), getPoint(column, row + 1) } },
            { { getPoint(column + 1, row), getPoint(column + 1, row + 1),
              getPoint(column, row + 1) } }
          };
          for (const Triangle& triangle : triangles)
          {
            bool isInView = false;
            part.Error = std::max(part.Error, this->MeasureTriangle(triangle, true, isInView));
            part.Triangles += isInView ? 1.0 : 0.0;
          }
        }
        isBeyond = isBeyond || part.Error > limit;
      }
    });
  Grid grid{ 0.0, 0.0 };
  for (const Grid& part : parts)
  {
    grid.Error = std::max(grid.Error, part.Error);
    grid.Triangles += part.Triangles;
  }
  return grid;
}
