// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidGround
 * @brief   the ground of a raster of any size, on a flat map
 *
 * Near the camera, samples of full resolution are read; far away, the ranges of tiles.
 */
#ifndef PyramidGround_h
#define PyramidGround_h

#include "Scene/TerrainGround.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <optional>

class vtkCamera;
class vtkPoints;
class vtkTerrainMapper;
class vtkTerrainPyramid;

class PyramidGround : public TerrainGround
{
public:
  /// Takes an open pyramid.
  explicit PyramidGround(vtkTerrainPyramid* pyramid);
  ~PyramidGround() override;

  void SetExaggeration(double factor);

  bool GetHeight(double x, double y, double& height) override;
  double GetZ(double height) override;
  bool GetHighestGround(double x, double y, double spacing, double& z) override;
  void MoveOnto(double place[2]) override;
  std::array<double, 4> GetExtent() override;
  bool HasCoordinateSystem() override;
  bool IsGeographic() override;
  double GetVerticalUnit() override;
  bool ToRaster(const double place[2], double coordinates[2]) override;
  bool FromRaster(const double coordinates[2], double place[2]) override;
  bool FromDegrees(const double degrees[2], double place[2]) override;
  bool ToDegrees(const double place[2], double degrees[2]) override;

  /// Whether coordinates are samples, because there is no georeference.
  bool CountsSamples() const;

  /// Adds points that outline the terrain to an empty set. Reads few samples of large rasters.
  void AddOutline(vtkPoints* points);

  /// The first intersection of the camera's view direction with the terrain, which has the bounds.
  std::optional<std::array<double, 3>> FindFirst(vtkCamera* camera, const double bounds[6]);

private:
  std::array<double, 2> ToSamples(double x, double y) const;
  /// The x and y of a column and row.
  std::array<double, 2> FromSamples(double column, double row) const;
  /// The height at the centre of the nearest sample, if that is very near.
  double GetNearSample(const std::array<double, 2>& place);
  double GetElevation(double x, double y);
  std::optional<std::array<double, 3>> Intersect(const double from[3], const double to[3]);

  vtkSmartPointer<vtkTerrainPyramid> Pyramid;
  vtkNew<vtkTerrainMapper> Map; // converts coordinates, but draws nothing
  int Size[2];                  // columns and rows
  // The map is linear.
  std::array<double, 2> Origin; // of column 0 and row 0
  std::array<double, 2> Column; // per column
  std::array<double, 2> Row;    // per row
};

#endif
