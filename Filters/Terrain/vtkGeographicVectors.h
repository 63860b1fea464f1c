// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeographicVectors
 * @brief   wind and other vectors to the east and north, in terrain coordinates
 *
 * Vectors of weather and ocean data have components to the east, to the north and maybe upwards.
 * East and north are not the x and y of a terrain: on a projected grid they are turned by its
 * convergence, in a local tangent frame by the earth's curvature. The output is the input mesh, of
 * a vtkTerrainSource or refined from one, with the vectors in its own coordinates as active point
 * vectors (float, 3 components).
 *
 * x and y give the direction on the map. They are as long as the vector's part to the east and
 * north, so that a speed is unchanged. z is the third component times Exaggeration, as heights are,
 * or 0 for vectors of two components. Level vectors stay level; to follow the relief, project them
 * on it, as vtkAdaptiveLICMapper does. By the terrain's coordinate system:
 *
 * - Longitude and latitude: rotated by the matrix of GeographicLib::LocalCartesian, from the
 *   place's horizon into the frame at the origin. What leans out of the tangent plane by the
 *   earth's curvature is left out, as it is of the terrain's z.
 * - Projected: along the parallel and the meridian as the system's own projection draws them
 *   (grid convergence, and in projections that are not conformal the ratio of the scales).
 * - Local, or not known: x is east, and y is north.
 *
 * The vectors are a point array of the mesh or, with an image at the second input, one of the
 * image's: a raster over the same extent as the height map, which is sampled by the mesh's texture
 * coordinates as heights are (vtkHeightField: row 0 south, at v = 0, texels' centres at (i + 0.5) /
 * n, bilinear). It is sampled at the mesh's points alone: give the mesh about as many as the image
 * has (vtkTerrainSource::SetResolution). The image's origin, spacing and own extent do not matter.
 * SetInputArrayToProcess(0, port, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name) chooses the
 * array, port 0 for the mesh's and 1 for the image's; else it is the image's, or without one the
 * mesh's active vectors, or the first point array of 2 or 3 components that is neither normals nor
 * texture coordinates.
 *
 * No data are vectors with a component that is not finite or of at least 1e8 in absolute value, and
 * blanked points of the image; of the image, samples that are interpolated from a texel without
 * data. They are NaN in the output, as where the map has no such place, and at the poles, which
 * have no east.
 *
 * Errors, with an empty output: no such array, or one of other than 2 or 3 components or as many
 * tuples as points; an image without texture coordinates of the mesh, or one that is not n x m x 1
 * points; a coordinate system that GDAL does not know, or a geocentric one; a terrain that cannot
 * be read. Builds without GDAL know no coordinate systems.
 *
 * @sa vtkTerrainSource vtkAdaptiveLICMapper
 */
#ifndef vtkGeographicVectors_h
#define vtkGeographicVectors_h

#include "RelevoFiltersTerrainModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the terrain

#include <memory> // for std::unique_ptr
#include <string> // for names

class vtkDataArray;
class vtkFloatArray;
class vtkImageData;
class vtkTerrainSource;
namespace relevo
{
class MapDirections;
}

class RELEVOFILTERSTERRAIN_EXPORT vtkGeographicVectors : public vtkPolyDataAlgorithm
{
public:
  static vtkGeographicVectors* New();
  vtkTypeMacro(vtkGeographicVectors, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The terrain whose coordinates the mesh is in: its coordinate system, origin and exaggeration
   * are taken, in place of those set here. It is brought up to date. None by default.
   */
  virtual void SetTerrain(vtkTerrainSource* terrain);
  vtkTerrainSource* GetTerrain();
  //@}

  //@{
  /**
   * Without a terrain: the coordinate system, as WKT or whatever else GDAL takes, as "EPSG:32633".
   * Empty, the default: what the mesh's field data say, "CoordinateSystem" and "Origin" as of
   * vtkTerrainSource; without them it is not known, x is east.
   */
  virtual void SetCoordinateSystem(const char* definition);
  const char* GetCoordinateSystem() { return this->CoordinateSystem.c_str(); }
  //@}

  //@{
  /**
   * With a CoordinateSystem: the coordinates in it (longitude first) of x = y = 0; z does not
   * matter. Default (0, 0, 0). A value that is not finite is an error and changes nothing.
   */
  virtual void SetOrigin(double x, double y, double z);
  void SetOrigin(const double origin[3]) { this->SetOrigin(origin[0], origin[1], origin[2]); }
  vtkGetVector3Macro(Origin, double);
  //@}

  //@{
  /**
   * Without a terrain: the factor on the third component, default 1. NaN, or more than 1e38 in
   * absolute value, is an error and changes nothing.
   */
  virtual void SetExaggeration(double exaggeration);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * The name of the output array; empty, the default: that of the input array, which it replaces
   * where that is one of the mesh.
   */
  virtual void SetOutputArrayName(const char* name);
  const char* GetOutputArrayName() { return this->OutputArrayName.c_str(); }
  //@}

  /**
   * The image with the vectors, as the second input; nullptr for none.
   */
  void SetRasterData(vtkImageData* image);

  /**
   * As SetRasterData(), of a pipeline.
   */
  void SetRasterConnection(vtkAlgorithmOutput* output);

  vtkMTimeType GetMTime() override;

protected:
  vtkGeographicVectors();
  ~vtkGeographicVectors() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkTerrainSource> Terrain;
  std::string CoordinateSystem;
  double Origin[3];
  double Exaggeration;
  std::string OutputArrayName;

private:
  vtkGeographicVectors(const vtkGeographicVectors&) = delete;
  void operator=(const vtkGeographicVectors&) = delete;

  int Convert(vtkInformationVector** inputVector, vtkPolyData* output);
  vtkDataArray* ChooseArray(vtkInformationVector** inputVector, bool& isOfRaster);
  bool Locate(
    vtkPolyData* mesh, std::unique_ptr<relevo::MapDirections>& directions, double& exaggeration);
  bool Turn(vtkPolyData* mesh, const relevo::MapDirections* directions, double exaggeration,
    vtkFloatArray* vectors);
};

#endif
