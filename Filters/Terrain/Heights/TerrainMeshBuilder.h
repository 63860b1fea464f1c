// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainMeshBuilder
 * @brief   makes a polydata of triangles on the samples of a raster
 *
 * Vertices are columns and rows in a unit of 2^-subdivisions samples, so that equal vertices are
 * found exactly. Triangles without data at a vertex are left out, and so are those with two
 * vertices at a pole. Triangles beyond a window of the raster are clipped.
 *
 * Private to the module.
 */
#ifndef TerrainMeshBuilder_h
#define TerrainMeshBuilder_h

#include "Geodesy/TerrainPlacement.h"
#include "Raster/RasterDescription.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <array>
#include <cstdint>
#include <unordered_map>

class vtkPolyData;

namespace relevo
{
class TerrainMeshBuilder
{
public:
  /// Positions are those of the placement. The description gives the unit of heights and the
  /// footprint of texture coordinates.
  TerrainMeshBuilder(
    const RasterDescription& contents, const TerrainPlacement& placement, int subdivisions);

  struct Vertex
  {
    std::int64_t Column;
    std::int64_t Row;
    double Height; // in the unit of the raster
    /// World coordinates; nullptr for those of the placement. They are copied.
    const std::array<double, 3>* World = nullptr;
    /// Optional: where the builder stores the point, and finds it if it is not negative.
    vtkIdType* Point = nullptr;
  };
  /// Add a triangle; its orientation does not matter.
  void AddTriangle(const std::array<Vertex, 3>& triangle);

  /**
   * Fill in the mesh, clipped to columns[0] to columns[1] and rows[0] to rows[1], in samples.
   * Triangles are counter-clockwise seen from above. Points have the arrays "Height" and
   * "TextureCoordinates" (in [0, 1]^2 over the raster, u east, v north).
   */
  void Finish(
    const std::array<double, 2>& columns, const std::array<double, 2>& rows, vtkPolyData* output);

private:
  vtkIdType AddVertex(const Vertex& vertex);
  vtkIdType AddPoint(
    const std::array<double, 3>& position, double height, double column, double row);
  void Clip(int axis, double limit, double sign);
  vtkIdType AddEdgePoint(vtkIdType first, vtkIdType second, int axis, double limit);
  void RemoveUnusedPoints();

  const RasterDescription& Contents;
  TerrainPlacement Placement;
  double Unit; // of vertices, in samples
  bool IsMirrored;
  std::unordered_map<std::uint64_t, vtkIdType> Ids;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Heights;
  vtkNew<vtkDoubleArray> Positions; // column and row in samples
  vtkNew<vtkCellArray> Triangles;
};
}

#endif
