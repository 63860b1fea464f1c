// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainSource
 * @brief   coarse mesh, displacement and texture of a georeferenced height map
 *
 * The output covers the raster from pixel edge to pixel edge with a grid of triangles at z = 0,
 * counter-clockwise from above, with point normals ("Normals", +z) and texture coordinates
 * ("TextureCoordinates", u east, v north, [0, 1]^2). The relief itself is GetDisplacement(), for
 * vtkAdaptiveRefinement::SetDisplacement: z = height x Exaggeration. Where the terrain lies is in
 * the field data, which go with the mesh through refinement and into files: "Origin", 3 doubles,
 * and "CoordinateSystem", a string, as GetOrigin() and GetCoordinateSystem() have them.
 *
 * Points are in terrain coordinates: metres, x east, y north, from the raster's centre. Longitude
 * and latitude: GeographicLib::LocalCartesian at the centre, height 0, on the ellipsoid of the
 * coordinate system; only x and y follow it, z counts from the ellipsoid, so that the earth's
 * curvature is left out of z. Projected and local systems: metres of the system minus the centre
 * (other linear units, and heights in a declared other unit, are converted to metres). No
 * georeference: one texel is one unit, and so is one unit of height. A raster one texel wide or
 * high gives a strip of that width. The mesh's points follow the raster's grid exactly; between
 * them the map is linear.
 *
 * No data: with the policy Hole (default) faces without any sample that has data are left out, and
 * the displacement leaves out refined triangles over no data; with Fill all are kept, at heights
 * interpolated from around.
 *
 * Imagery: GetImagery() is ready for vtkTexture (EdgeClampOn, InterpolateOn): it is resampled by
 * its own georeference and coordinate system to the terrain's footprint, at about its own
 * resolution, up to MaximumImagerySize. Where it has no data, or does not reach, it is neutral grey
 * (128, 128, 128). A picture without georeference, or on a terrain without, is stretched over the
 * whole footprint. If only one of the two declares a coordinate system, both are assumed to use it.
 *
 * Errors (ErrorEvent of this object, empty output): those of vtkHeightMap; a raster in geocentric
 * coordinates; one in degrees that reaches beyond the horizon of its centre (about 84 degrees away:
 * project it first); imagery that is missing, unreadable, does not overlap the terrain or lacks the
 * chosen bands. Builds without GDAL read no georeference: a warning says so.
 *
 * ProgressEvent reports the share done; GetProgressText() says with what: "reading heights",
 * "draping imagery". AbortExecuteOn(), from an observer, stops it, with an empty output and no
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
   * The raster file, of any format that vtkHeightMap reads.
   */
  virtual void SetFileName(VTK_FILEPATH const char* fileName);
  virtual VTK_FILEPATH char* GetFileName();
  //@}

  //@{
  /**
   * The picture to drape over the terrain; none by default.
   */
  vtkSetFilePathMacro(ImageryFileName);
  vtkGetFilePathMacro(ImageryFileName);
  //@}

  //@{
  /**
   * The bands of the imagery, counted from 1, that are red, green and blue. (0, 0, 0), the default:
   * those that the file declares so; else the first three, or the first alone as grey, or, of five
   * and more, the third, second and first: a multispectral scene in order of wavelength, as Landsat
   * and Sentinel-2 have them. Bytes are taken as they are, georeferenced imagery of other types is
   * stretched from its smallest to its largest value. A number below 1 among others is an error and
   * changes nothing.
   */
  virtual void SetImageryBands(int red, int green, int blue);
  void SetImageryBands(const int bands[3]) { this->SetImageryBands(bands[0], bands[1], bands[2]); }
  vtkGetVector3Macro(ImageryBands, int);
  //@}

  //@{
  /**
   * The most pixels the resampled imagery may have per side, 1 to 65536, default 4096. Imagery of
   * more is reduced, from its overviews where it has any, with a warning. Another value is an error
   * and changes nothing.
   */
  virtual void SetMaximumImagerySize(int pixels);
  vtkGetMacro(MaximumImagerySize, int);
  //@}

  //@{
  /**
   * Squares of two coarse faces along the longer side, default 128, at most one per texel; the
   * shorter side has as many as keep them about square. Less than 1 is an error and changes
   * nothing.
   */
  virtual void SetResolution(int squares);
  vtkGetMacro(Resolution, int);
  //@}

  //@{
  /**
   * Factor on the heights, default 1. NaN, or more than 1e38 in absolute value, is an error and
   * changes nothing.
   */
  virtual void SetExaggeration(double exaggeration);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * A sample value that means "no data", besides what the file declares; NaN for NaN samples. See
   * vtkHeightMap::SetNoDataValue and UnsetNoDataValue.
   */
  virtual void SetNoDataValue(double value);
  virtual double GetNoDataValue();
  virtual void UnsetNoDataValue();
  //@}

  //@{
  /**
   * The most heights that are kept per side, default 16384, 0 for any number; more are reduced,
   * with a warning: see vtkHeightMap::SetMaximumDimension. Extent and coordinates stay. Less than 0
   * is an error and changes nothing.
   */
  virtual void SetMaximumDimension(int dimension);
  virtual int GetMaximumDimension();
  //@}

  //@{
  /**
   * Leave out (vtkDisplacement::HOLE, default) or fill (vtkDisplacement::FILL) what has no data.
   * Another value is an error and changes nothing.
   */
  virtual void SetNoDataPolicy(int policy);
  virtual int GetNoDataPolicy();
  void SetNoDataPolicyToHole();
  void SetNoDataPolicyToFill();
  //@}

  //@{
  /**
   * Whether the height map keeps its heights when the mesh is made, on by default. Off saves their
   * memory where only the mesh is used; see vtkHeightMap::ReleaseHeights().
   */
  vtkSetMacro(KeepHeights, bool);
  vtkGetMacro(KeepHeights, bool);
  vtkBooleanMacro(KeepHeights, bool);
  //@}

  /**
   * The relief: direction +z, Scale = Exaggeration (times the metres in the heights' unit),
   * Offset 0. The same object from the start.
   */
  vtkDisplacement* GetDisplacement();

  /**
   * The heights. With SetImageData, and no file name, they come from memory.
   */
  vtkHeightMap* GetHeightMap();

  /**
   * The imagery over the terrain's texture coordinates, RGB, unsigned char; filled by Update().
   * nullptr without ImageryFileName.
   */
  vtkImageData* GetImagery();

  //@{
  /**
   * The raster's centre in its own coordinates (for longitude and latitude, in that order), z = 0;
   * in texels without georeference. After Update().
   */
  vtkGetVector3Macro(Origin, double);
  //@}

  /**
   * The raster's coordinate system as WKT, "" when it is not known. After Update().
   */
  const char* GetCoordinateSystem();

  /**
   * Whether the raster's own coordinates are longitude and latitude. After Update().
   */
  bool IsGeographic();

  //@{
  /**
   * Between terrain coordinates (metres; z = height x Exaggeration) and the raster's own: x and y
   * in its coordinate system (longitude, then latitude), z the height as the raster has it, 0 with
   * an Exaggeration of 0. Without georeference x and y count texels, from the corner in the
   * south-west. False, and nothing is written, before a successful Update(), and beyond the horizon
   * of the raster's centre.
   */
  bool TerrainToMap(const double terrain[3], double map[3]);
  bool MapToTerrain(const double map[3], double terrain[3]);
  //@}

  /**
   * From longitude, latitude (degrees, on the ellipsoid of the raster's coordinate system) and the
   * height as the raster has it to terrain coordinates. False, and nothing is written, where
   * MapToTerrain() is, and if the raster's coordinate system is not known.
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
  double Exaggeration;
  double Origin[3];

private:
  vtkTerrainSource(const vtkTerrainSource&) = delete;
  void operator=(const vtkTerrainSource&) = delete;

  bool Build(vtkPolyData* output, std::string& error);
  void AddFieldData(vtkPolyData* output);
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
  double VerticalUnit; // metres in one unit of the heights
  vtkTimeStamp ImageryTime;
  std::string ImageryState; // the settings that the imagery was made with
};

#endif
