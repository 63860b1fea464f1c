// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainProbe
 * @brief   heights of a terrain by its own x and y
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
  /// The flat mesh, with texture coordinates, and the heights over them.
  TerrainProbe(vtkPolyData* mesh, vtkHeightField* heights);
  ~TerrainProbe();

  /// The raster's height; false where there is no terrain, or no data.
  bool GetHeight(double x, double y, double& height);
  /// The heights that the surface may be drawn at: the raster's, and those between the corners of
  /// the triangles that each of the levels splits the mesh into. Empty where there is no terrain.
  std::vector<double> GetDrawnHeights(double x, double y, int lowestLevel, int highestLevel);
  /// Moves x and y to the nearest place of the mesh.
  void MoveOnto(double place[2]);

private:
  /// The corners' texture coordinates and weights of the triangle at a place; false for none.
  using Coordinates = std::array<double, 2>;
  struct Corners
  {
    Coordinates Points[3];
    double Weights[3];
    Coordinates Interpolate(const double weights[3]) const;
  };
  bool FindTriangle(double x, double y, Corners& corners);
  /// The height at the middle of a texel with data, if that is near.
  bool GetTexel(const Coordinates& uv, double& height) const;
  double GetHeight(const Corners& corners, const double weights[3]) const;
  double GetDrawnHeight(const Corners& corners, int level) const;

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkHeightField> Heights;
  vtkNew<vtkStaticCellLocator> Locator;
};

#endif
