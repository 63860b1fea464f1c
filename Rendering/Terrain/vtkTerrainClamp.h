// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainClamp
 * @brief   lays lines, polygons and points on a terrain
 *
 * The input is a vtkPolyData, such as a GPS track, roads, or areas. Its z coordinates are ignored.
 *
 * With SetMapper(), the output lies on the triangles that the mapper has drawn last, so that a line
 * neither floats nor sinks. It is recomputed when these triangles change. To draw it, connect the
 * output to a vtkPolyDataMapper, and add its actor to the renderer after that of the terrain: it is
 * then computed in each frame after the terrain is drawn. If its actor comes first, it shows the
 * triangles of the frame before. If the actor of the terrain has a matrix, set the same matrix for
 * the actor of the output. Before the first frame, the output is flat. Parts of the input that are
 * out of sight are laid on coarse heights.
 *
 * With SetPyramid(), the output lies on the surface of full resolution, which is bilinear between
 * the centres of samples, within SetMaximumError(). If both are set, the mapper is used.
 *
 * Lines get a point wherever they cross an edge of the surface, so that they lie on it everywhere.
 * Polygons are projected vertically, triangulated, and cut along the edges of the surface. The
 * output has the parts as convex polygons, counter-clockwise seen from above. For the outline of a
 * polygon, add it to the input as a line. Triangle strips become polygons, too. Between the points
 * of the input, lines and edges are straight in the coordinates of the raster. In longitude and
 * latitude, they take the shorter way around the earth.
 *
 * Parts outside of the raster (which ends at the centres of the outermost samples) or over missing
 * data are left out; a line can become several. A WarningEvent tells so, once.
 *
 * Points are doubles in the frame of the mapper; with SetPyramid(), in the map frame. Point data
 * are interpolated, and cell data are copied to the parts of a cell, both without normals. The
 * point array "Height" (double) is the height of the terrain in the unit of the raster, without
 * offset and exaggeration; it replaces an array of that name.
 *
 * To avoid that a line is hidden by the terrain because of rounding errors of the depth buffer,
 * lift it by SetOffset(), or use vtkMapper::SetResolveCoincidentTopology().
 *
 * Errors (ErrorEvent, empty output): neither a mapper nor a pyramid; an error of the pyramid; a
 * raster with one row or column; a coordinate system that is not supported; longitude and latitude
 * for a raster without a coordinate system; more than 2^24 cells. Tiles that cannot be read are
 * reported, and count as missing data.
 *
 * @sa vtkTerrainMapper vtkTerrainPyramid
 */
#ifndef vtkTerrainClamp_h
#define vtkTerrainClamp_h

#include "RelevoRenderingTerrainModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <array>  // for positions
#include <string> // for errors
#include <vector> // for positions

class vtkTerrainMapper;
class vtkTerrainPyramid;

class RELEVORENDERINGTERRAIN_EXPORT vtkTerrainClamp : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainClamp* New();
  vtkTypeMacro(vtkTerrainClamp, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the mapper whose last frame has the surface. Its Exaggeration is used.
   */
  void SetMapper(vtkTerrainMapper* mapper);
  vtkTerrainMapper* GetMapper();
  //@}

  //@{
  /**
   * Set the raster whose full resolution is the surface. It is opened if necessary.
   */
  void SetPyramid(vtkTerrainPyramid* pyramid);
  vtkTerrainPyramid* GetPyramid();
  //@}

  //@{
  /**
   * Set the distance by which the output is lifted, in world units: along z, or perpendicular to
   * the ellipsoid in the geocentric frame; default 0. NaN and infinity are errors and change
   * nothing.
   */
  virtual void SetOffset(double distance);
  vtkGetMacro(Offset, double);
  //@}

  enum CoordinateTypes
  {
    WORLD = 0,
    RASTER,
    GEOGRAPHIC
  };

  //@{
  /**
   * Set the coordinates of the input. WORLD (0, the default): the frame of the mapper; with
   * SetPyramid(), the map frame, in metres from the centre of the raster. RASTER (1): the raster's
   * own coordinate system. GEOGRAPHIC (2): longitude and latitude in degrees, on the ellipsoid of
   * the raster's coordinate system, as for GPS tracks. A value out of range is an error and changes
   * nothing.
   */
  virtual void SetCoordinateType(int type);
  vtkGetMacro(CoordinateType, int);
  void SetCoordinateTypeToWorld() { this->SetCoordinateType(WORLD); }
  void SetCoordinateTypeToRaster() { this->SetCoordinateType(RASTER); }
  void SetCoordinateTypeToGeographic() { this->SetCoordinateType(GEOGRAPHIC); }
  //@}

  //@{
  /**
   * Set the factor of heights with SetPyramid(); default 1. NaN and infinity are errors and change
   * nothing.
   */
  virtual void SetExaggeration(double factor);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Set the largest vertical distance from the surface of full resolution with SetPyramid(), before
   * exaggeration, in metres (in the unit of the heights without a georeference); default 0.1. A
   * line that crosses the cells between samples diagonally is curved there. It is split until it is
   * within this distance, and cells are split into triangles for polygons, up to 64 parts per side.
   * Values that are not above 0 are errors and change nothing.
   */
  virtual void SetMaximumError(double meters);
  vtkGetMacro(MaximumError, double);
  //@}

  /// Includes the triangles that the mapper has drawn.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainClamp();
  ~vtkTerrainClamp() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Offset = 0.0;
  int CoordinateType = WORLD;
  double Exaggeration = 1.0;
  double MaximumError = 0.1;

private:
  vtkTerrainClamp(const vtkTerrainClamp&) = delete;
  void operator=(const vtkTerrainClamp&) = delete;

  std::string Clamp(vtkPolyData* input, vtkPolyData* output);
  std::string ClampToMapper(vtkPolyData* input, vtkPolyData* output);
  std::string ClampToPyramid(vtkPolyData* input, vtkPolyData* output);
  struct vtkTerrain;
  std::string ClampTo(const vtkTerrain& terrain, vtkPolyData* input, vtkPolyData* output);
  bool FindPositions(const vtkTerrain& terrain, vtkPolyData* input,
    std::vector<std::array<double, 2>>& positions) const;

  vtkSmartPointer<vtkTerrainMapper> Mapper;
  vtkSmartPointer<vtkTerrainPyramid> Pyramid;
  std::string Warning; // reported last
};

#endif
