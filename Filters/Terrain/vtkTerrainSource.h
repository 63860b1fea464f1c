// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainSource
 * @brief   coarse mesh, displacement and texture of a georeferenced height map
 *
 * The output is a flat grid of triangles at z = 0 that covers the raster from pixel edge to pixel
 * edge. Triangles are counter-clockwise seen from above. The points have normals ("Normals", +z)
 * and texture coordinates ("TextureCoordinates" in [0, 1]^2, u to the east, v to the north). Pass
 * GetDisplacement() to vtkAdaptiveRefinement::SetDisplacement() to add the relief: z = height *
 * Exaggeration. The field data arrays "Origin" (3 doubles) and "CoordinateSystem" (a string) hold
 * the location, see GetOrigin() and GetCoordinateSystem(). Refinement and files preserve them.
 *
 * Points are in terrain coordinates: metres, x east, y north, with the origin at the centre of the
 * raster.
 *
 * - Longitude and latitude: x and y are those of GeographicLib::LocalCartesian at the centre, at
 *   height 0 of the ellipsoid. z is the height above the ellipsoid, so that z ignores the curvature
 *   of the earth.
 * - Projected and local systems: coordinates of the system minus the centre. Other linear units,
 *   and heights in another declared unit, are converted to metres.
 * - No georeference: one texel is one unit, and one unit of height is one unit of z.
 *
 * The points lie exactly on the map. Between points the map is linear. A raster that is one texel
 * wide or high produces a strip of that width.
 *
 * Where there is no data, the policy Hole (default) omits coarse faces without any valid sample,
 * and the displacement omits refined triangles without data. The policy Fill keeps all faces, with
 * heights interpolated from the surroundings.
 *
 * GetImagery() returns an image for vtkTexture (use EdgeClampOn() and InterpolateOn()). It is
 * resampled to the footprint of the terrain according to its georeference and coordinate system, at
 * about its original resolution up to MaximumImagerySize. It is neutral grey (128, 128, 128) where
 * imagery is missing. If the imagery or the terrain has no georeference, the imagery is stretched
 * over the whole footprint. If only one of them declares a coordinate system, both are assumed to
 * use it.
 *
 * This object reports an error (ErrorEvent) and produces an empty output if
 *
 * - vtkHeightMap reports an error;
 * - the raster is in geocentric coordinates;
 * - the raster is in degrees and reaches beyond the horizon of its centre, about 84 degrees away
 *   (project it first);
 * - the imagery is missing, unreadable, does not overlap the terrain or lacks one of the
 *   ImageryBands.
 *
 * Builds without GDAL read no georeference, and issue a warning.
 *
 * ProgressEvent reports the progress and GetProgressText() the current step, "reading heights" or
 * "draping imagery". An observer can call AbortExecuteOn() to stop, with an empty output and no
 * error.
 *
 * @sa vtkHeightMap vtkDisplacement vtkAdaptiveRefinement
 */
#ifndef vtkTerrainSource_h
#define vtkTerrainSource_h

#include "RelevoFiltersTerrainModule.h" // for export macro
#include "vtkNew.h"                     // for the height map
#include "vtkPolyDataAlgorithm.h"
#include "vtkTimeStamp.h" // for the imagery's cache

#include <memory> // for the frame
#include <string> // for the coordinate system

class vtkDisplacement;
class vtkHeightMap;
class vtkImageData;
namespace relevo
{
struct Georeference;
class TerrainFrame;
}

class RELEVOFILTERSTERRAIN_EXPORT vtkTerrainSource : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainSource* New();
  vtkTypeMacro(vtkTerrainSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the raster file, in any format that vtkHeightMap reads.
   */
  virtual void SetFileName(VTK_FILEPATH const char* fileName);
  virtual VTK_FILEPATH char* GetFileName();
  //@}

  //@{
  /**
   * Set the name of the image file to drape over the terrain; none by default.
   */
  vtkSetFilePathMacro(ImageryFileName);
  vtkGetFilePathMacro(ImageryFileName);
  //@}

  //@{
  /**
   * Set the bands of the imagery, starting at 1, for red, green and blue. By default, (0, 0, 0),
   * the bands that the file declares as red, green and blue are used. Without a declaration, an
   * image of fewer than three bands uses the first one as grey, one of three or four uses the first
   * three, and one of five or more uses the third, second and first, as in multispectral scenes of
   * Landsat and Sentinel-2. Bytes are used unchanged. Georeferenced imagery of other types is
   * scaled from its smallest and largest value. A number below 1, except for all 0, is an error and
   * changes nothing.
   */
  virtual void SetImageryBands(int red, int green, int blue);
  void SetImageryBands(const int bands[3]) { this->SetImageryBands(bands[0], bands[1], bands[2]); }
  vtkGetVector3Macro(ImageryBands, int);
  //@}

  //@{
  /**
   * Set the maximum number of pixels per side of the resampled imagery, 1 to 65536, default 4096.
   * Larger imagery is reduced, from its overviews if available, with a warning. Another value is an
   * error and changes nothing.
   */
  virtual void SetMaximumImagerySize(int pixels);
  vtkGetMacro(MaximumImagerySize, int);
  //@}

  //@{
  /**
   * Set the number of squares, of two coarse faces each, along the longer side; default 128,
   * limited to one per texel. The number along the shorter side is chosen to make them about
   * square. Less than 1 is an error and changes nothing.
   */
  virtual void SetResolution(int squares);
  vtkGetMacro(Resolution, int);
  //@}

  //@{
  /**
   * Set whether the corners of the squares are centres of texels, a power of two texels apart; off
   * by default. Refined vertices then lie on samples, so that vtkHeightErrorDepthTagMetric needs
   * far fewer triangles. The number of squares differs from Resolution by up to a factor of 1.5,
   * and a border of half a texel has squares of this width.
   */
  vtkSetMacro(AlignToSamples, bool);
  vtkGetMacro(AlignToSamples, bool);
  vtkBooleanMacro(AlignToSamples, bool);
  //@}

  //@{
  /**
   * Set the factor for heights, default 1. NaN, or more than 1e38 in absolute value, is an error
   * and changes nothing.
   */
  virtual void SetExaggeration(double exaggeration);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Set a sample value that means "no data", in addition to the one that the file declares. NaN
   * marks NaN samples as missing. See vtkHeightMap::SetNoDataValue() and
   * UnsetNoDataValue().
   */
  virtual void SetNoDataValue(double value);
  virtual double GetNoDataValue();
  virtual void UnsetNoDataValue();
  //@}

  //@{
  /**
   * Set the maximum number of heights per side, default 16384, 0 for no limit. Larger rasters are
   * reduced with a warning, see vtkHeightMap::SetMaximumDimension(). Extent and coordinates do not
   * change. A negative number is an error and changes nothing.
   */
  virtual void SetMaximumDimension(int dimension);
  virtual int GetMaximumDimension();
  //@}

  //@{
  /**
   * Set how to treat missing data: vtkDisplacement::HOLE (default) omits it, vtkDisplacement::FILL
   * interpolates it. Another value is an error and changes nothing.
   */
  virtual void SetNoDataPolicy(int policy);
  virtual int GetNoDataPolicy();
  void SetNoDataPolicyToHole();
  void SetNoDataPolicyToFill();
  //@}

  //@{
  /**
   * Set whether the height map keeps its heights after the mesh is generated; on by default. Turn
   * this off to save memory if you use the mesh only. See vtkHeightMap::ReleaseHeights().
   */
  vtkSetMacro(KeepHeights, bool);
  vtkGetMacro(KeepHeights, bool);
  vtkBooleanMacro(KeepHeights, bool);
  //@}

  /**
   * Return the displacement: direction +z, Scale = Exaggeration times the metres per unit of
   * height, Offset 0. It is always the same object.
   */
  vtkDisplacement* GetDisplacement();

  /**
   * Return the height map. Call SetImageData() on it, and set no file name, to use heights from
   * memory.
   */
  vtkHeightMap* GetHeightMap();

  /**
   * Return the imagery in the texture coordinates of the terrain, RGB unsigned char. Update() fills
   * it. Returns nullptr without ImageryFileName.
   */
  vtkImageData* GetImagery();

  //@{
  /**
   * Get the centre of the raster in its coordinate system (longitude first), with z = 0; in texels
   * without georeference. Available after Update().
   */
  vtkGetVector3Macro(Origin, double);
  //@}

  /**
   * Return the coordinate system of the raster as WKT, "" if unknown. Available after Update().
   */
  const char* GetCoordinateSystem();

  /**
   * Return whether the coordinates of the raster are longitude and latitude. Available after
   * Update().
   */
  bool IsGeographic();

  //@{
  /**
   * Convert between terrain coordinates (metres, z = height * Exaggeration) and map coordinates: x
   * and y in the coordinate system of the raster (longitude first), and z the height in the unit of
   * the raster, or 0 if Exaggeration is 0. Without georeference, x and y are in texels from the
   * south-west corner. Returns false and writes nothing before a successful Update() and beyond the
   * horizon of the centre of the raster.
   */
  bool TerrainToMap(const double terrain[3], double map[3]);
  bool MapToTerrain(const double map[3], double terrain[3]);
  //@}

  /**
   * Convert longitude and latitude (degrees, on the ellipsoid of the coordinate system of the
   * raster) and a height in the unit of the raster to terrain coordinates. Returns false and writes
   * nothing if the coordinate system is unknown, before a successful Update(), and beyond the
   * horizon of the centre of the raster.
   */
  bool GeographicToTerrain(const double geographic[3], double terrain[3]);

  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainSource();
  ~vtkTerrainSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* ImageryFileName;
  int ImageryBands[3];
  int MaximumImagerySize;
  int Resolution;
  bool AlignToSamples;
  double Exaggeration;
  double Origin[3];

private:
  vtkTerrainSource(const vtkTerrainSource&) = delete;
  void operator=(const vtkTerrainSource&) = delete;

  bool Build(vtkPolyData* output, std::string& error);
  void WarnOfLocation(const relevo::Georeference& location);
  bool CheckLocation(const relevo::Georeference& location, std::string& error);
  bool CheckImagery(std::string& error);
  bool UpdateImagery(const relevo::Georeference& location, std::string& error);
  void ForwardError(vtkObject* caller, unsigned long event, void* message);
  void ForwardWarning(vtkObject* caller, unsigned long event, void* message);
  void ForwardProgress(vtkObject* caller, unsigned long event, void* progress);

  vtkNew<vtkHeightMap> HeightMap;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkImageData> Imagery;
  std::unique_ptr<relevo::TerrainFrame> Frame; // null before a successful update
  std::string CoordinateSystem;
  bool KeepHeights;
  double VerticalUnit; // metres per unit of height
  vtkTimeStamp ImageryTime;
  std::string ImageryState; // settings of the cached imagery
};

#endif
