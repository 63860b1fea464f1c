// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainProbe
 * @brief   heights of a terrain at its x and y
 */
#ifndef TerrainProbe_h
#define TerrainProbe_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkHeightField;
class vtkPolyData;
class vtkStaticCellLocator;

class TerrainProbe
{
public:
  /// Takes the flat mesh with texture coordinates, and its heights.
  TerrainProbe(vtkPolyData* mesh, vtkHeightField* heights);
  ~TerrainProbe();

  /// Gets the raster's height. Returns false outside the terrain and for missing data.
  bool GetHeight(double x, double y, double& height);
  /// The heights at which the surface may be drawn: the raster's, and those interpolated in the
  /// triangles of each level. Empty outside the terrain.
  std::vector<double> GetDrawnHeights(double x, double y, int lowestLevel, int highestLevel);
  /// Moves x and y to the nearest point of the mesh.
  void MoveOnto(double place[2]);

private:
  /// Texture coordinates, and the coordinates and weights at the corners of a triangle.
  using Coordinates = std::array<double, 2>;
  struct Corners
  {
    Coordinates Points[3];
    double Weights[3];
    Coordinates Interpolate(const double weights[3]) const;
  };
  bool FindTriangle(double x, double y, Corners& corners);
  /// Gets the height at the centre of a nearby texel with data.
  bool GetTexel(const Coordinates& uv, double& height) const;
  double GetHeight(const Corners& corners, const double weights[3]) const;
  double GetDrawnHeight(const Corners& corners, int level) const;

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkHeightField> Heights;
  vtkNew<vtkStaticCellLocator> Locator;
};

#endif
