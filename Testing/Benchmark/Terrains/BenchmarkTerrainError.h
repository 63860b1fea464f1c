// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkTerrainError
 * @brief   vertical distances of meshes from the bilinear surface of a raster
 *
 * Twelve points of each triangle are evaluated in double precision.
 */
#ifndef BenchmarkTerrainError_h
#define BenchmarkTerrainError_h

#include "Geodesy/TerrainPlacement.h"

#include <array>

class BenchmarkRaster;
class vtkCamera;
class vtkPolyData;
class vtkTerrainPyramid;

class BenchmarkTerrainError
{
public:
  BenchmarkTerrainError(const BenchmarkRaster& raster, vtkTerrainPyramid* pyramid);

  const relevo::TerrainPlacement& GetPlacement() const { return this->Placement; }

  /// Measure in pixels for this camera instead of world units.
  void SetCamera(vtkCamera* camera, const int viewport[2]);

  /// The largest distance of a mesh of triangles.
  double Measure(vtkPolyData* mesh) const;

  struct Grid
  {
    double Error;     // the largest in view
    double Triangles; // in view
  };
  /// The same for a grid with two triangles per square, whose sides are `spacing` samples. The
  /// measurement ends early once the error exceeds `limit`.
  Grid MeasureGrid(double spacing, double limit) const;

private:
  using Point = std::array<double, 3>;
  using Triangle = std::array<Point, 3>;

  bool IsInView(const Point& point) const;
  double MeasurePoint(const Point& point) const;
  double MeasureTriangle(const Triangle& triangle, bool onlyInView, bool& isInView) const;

  const BenchmarkRaster& Raster;
  relevo::TerrainPlacement Placement;
  bool HasCamera = false;
  Point Eye{};
  double Factor = 1.0; // pixels per unit at a distance of one
  double Planes[24] = {};
};

#endif
