// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeographicVectors
 * @brief   convert east and north vectors, such as wind, to terrain coordinates
 *
 * Weather and ocean data store vectors as components to the east, to the north and sometimes
 * upwards. East and north differ from the x and y axes of a terrain: a projected grid is rotated by
 * its grid convergence, a local tangent frame by the curvature of the earth. This filter rotates
 * the vectors. Its output is the input mesh with the rotated vectors as active point vectors
 * (float, 3 components). The input is the mesh of a vtkTerrainSource or a mesh refined from one.
 *
 * x and y of the output give the direction on the map. Their length is that of the east and north
 * components, so that speeds are preserved. z is the third component times Exaggeration, or 0 for
 * vectors of two components. To make the vectors follow the relief, project them on it, as
 * vtkAdaptiveLICMapper does. The rotation depends on the coordinate system of the terrain:
 *
 * - Longitude and latitude: the matrix of GeographicLib::LocalCartesian rotates the vector from the
 *   local horizon into the frame at the origin. The component out of the tangent plane, which the
 *   curvature of the earth causes, is dropped.
 * - Projected: vectors follow the projected parallel and meridian. This includes the grid
 *   convergence and, in projections that are not conformal, the ratio of the scales.
 * - Local or unknown: x is east and y is north.
 *
 * The vectors are a point array of the mesh or of an optional image at the second input port. The
 * image covers the same extent as the height map and is sampled at the points of the mesh with
 * bilinear interpolation, using the texture coordinates (see vtkHeightField: row 0 is south at v =
 * 0, texel centres are at (i + 0.5) / n). Use a mesh with about as many points as the image (see
 * vtkTerrainSource::SetResolution()). Origin, spacing and extent of the image are ignored. To
 * choose the array, call SetInputArrayToProcess(0, port, 0,
 * vtkDataObject::FIELD_ASSOCIATION_POINTS, name) with port 0 for the mesh and 1 for the image. By
 * default, the image is used if there is one. In either data set, the default array is the active
 * vectors, or else the first point array of 2 or 3 components that is neither normals nor texture
 * coordinates.
 *
 * A vector is missing if a component is not finite or at least 1e8 in absolute value, or if the
 * image point is blanked. A sample is missing if one of the texels that it interpolates is missing.
 * Missing vectors are NaN in the output. So are vectors at positions outside of the map projection
 * and at the poles, where east is undefined.
 *
 * The filter reports an error and produces an empty output if
 *
 * - the array does not exist, or has a wrong number of components (not 2 or 3) or tuples;
 * - there is an image, but the mesh has no texture coordinates, or the image is not n x m x 1
 *   points;
 * - the coordinate system is geocentric or unknown to GDAL (without GDAL, all are unknown);
 * - the terrain cannot be read.
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
   * Set the terrain whose coordinates the mesh uses; none by default. Its coordinate system, origin
   * and exaggeration replace those set here. The filter updates it.
   */
  virtual void SetTerrain(vtkTerrainSource* terrain);
  vtkTerrainSource* GetTerrain();
  //@}

  //@{
  /**
   * Set the coordinate system for use without a terrain: WKT or any other definition that GDAL
   * accepts, for example "EPSG:32633". If empty (the default), the field data arrays
   * "CoordinateSystem" and "Origin" of the mesh are used, which vtkTerrainSource writes. Without
   * these arrays, x is east.
   */
  virtual void SetCoordinateSystem(const char* definition);
  const char* GetCoordinateSystem() { return this->CoordinateSystem.c_str(); }
  //@}

  //@{
  /**
   * Set the coordinates (longitude first) of x = y = 0 in the CoordinateSystem; default (0, 0, 0).
   * z is ignored. A value that is not finite is an error and changes nothing.
   */
  virtual void SetOrigin(double x, double y, double z);
  void SetOrigin(const double origin[3]) { this->SetOrigin(origin[0], origin[1], origin[2]); }
  vtkGetVector3Macro(Origin, double);
  //@}

  //@{
  /**
   * Set the factor for the third component, for use without a terrain; default 1. NaN, or more than
   * 1e38 in absolute value, is an error and changes nothing.
   */
  virtual void SetExaggeration(double exaggeration);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Set the name of the output array. If empty (the default), the output has the name of the input
   * array, and replaces that array if it belongs to the mesh.
   */
  virtual void SetOutputArrayName(const char* name);
  const char* GetOutputArrayName() { return this->OutputArrayName.c_str(); }
  //@}

  /**
   * Set the image with the vectors, the second input; nullptr for none.
   */
  void SetRasterData(vtkImageData* image);

  /**
   * Set the output of a pipeline that provides the image. See SetRasterData().
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
