// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainMapper
 * @brief   draws a height raster of any size within a number of pixels of its full resolution
 *
 * The input is a vtkTerrainPyramid. In each frame, the terrain is bisected into triangles until the
 * vertical distance between the drawn surface and the surface of full resolution, which is bilinear
 * between the centres of samples, is at most SetScreenSpaceError() pixels on the screen. Levels
 * change smoothly (geomorphing). Faces of different sizes share their edges to the bit, so that
 * there are no cracks. Triangles outside of the view are neither drawn nor loaded.
 *
 * Colours by height, contour lines, normals, slope and aspect are computed for each pixel, from the
 * overview whose samples are about as large as the pixel (a mipmap). Slopes have the formula of
 * B. K. P. Horn, "Hill shading and the reflectance map", Proceedings of the IEEE 69(1), 1981.
 *
 * Tiles of the raster are read in the background. A frame draws the best tiles that are in memory
 * and does not wait for others. Render() invokes vtkCommand::UpdateEvent if another frame would
 * show more. SetLoadingModeToComplete() waits instead, for scripts and saved pictures. Tiles and
 * their textures together take at most SetMemoryLimit() bytes; what does not fit is drawn coarser.
 * As long as the index of the pyramid is incomplete (vtkTerrainPyramid::IsErrorKnown()), errors are
 * estimated.
 *
 * World coordinates are a flat map in metres: x east and y north from the centre of the raster, and
 * z the height times SetExaggeration(). Longitude and latitude are scaled by the lengths of a
 * degree at the centre. Without a georeference, one sample and one unit of height are one unit. The
 * terrain ends at the centres of the outermost samples. Samples without data leave holes.
 *
 * SetImageryFileName() drapes an image of any size, in any coordinate system, over the terrain.
 *
 * Lights, back faces, clipping planes, opacity, depth peeling, representations, edges, render
 * passes, replacements of shaders and hardware selection work as with vtkPolyDataMapper. A
 * selection of cells returns the numbers of faces of that frame, and one of points is empty.
 *
 * VTK's pickers find the terrain as it was drawn last. vtkWorldPointPicker and vtkPropPicker read
 * the depth of the pixel. vtkAreaPicker and vtkRenderedAreaPicker find the actor. vtkCellPicker and
 * vtkPointPicker intersect the triangles in memory: their data set has the triangles and the arrays
 * of vtkTerrainMeshSource, and is built by the first pick after each change of the triangles.
 * WorldToGeographic() converts their positions to longitude, latitude and height.
 *
 * Requires OpenGL 3.3. These are errors (ErrorEvent of this object, once): no pyramid, a pyramid
 * that cannot be opened, a raster with one row or column, a coordinate system that is not
 * supported, tiles that cannot be read (a coarser level is drawn), a base that is not below the
 * terrain (it is drawn without a base), a lookup table whose range is not finite, imagery that
 * cannot be opened or does not overlap the terrain (the terrain is drawn without it), and shaders
 * that cannot be built.
 *
 * @sa vtkTerrainPyramid vtkTerrainMeshSource vtkTerrainClamp
 */
#ifndef vtkTerrainMapper_h
#define vtkTerrainMapper_h

#include "RelevoRenderingTerrainModule.h" // for export macro
#include "vtkMapper.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for Internals
#include <string> // for errors

class vtkMultiProcessController;
class vtkTerrainPyramid;
namespace relevo
{
class AdaptiveTerrain;
}

class RELEVORENDERINGTERRAIN_EXPORT vtkTerrainMapper : public vtkMapper
{
public:
  static vtkTerrainMapper* New();
  vtkTypeMacro(vtkTerrainMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the raster. Required. The mapper opens it when it is first needed.
   */
  void SetPyramid(vtkTerrainPyramid* pyramid);
  vtkTerrainPyramid* GetPyramid();
  //@}

  //@{
  /**
   * Set the largest vertical distance to the surface of full resolution, in pixels; at least 0.01,
   * default 1. A value out of range is an error and changes nothing.
   */
  void SetScreenSpaceError(double pixels);
  vtkGetMacro(ScreenSpaceError, double);
  //@}

  //@{
  /**
   * Set the maximum memory of heights, imagery, their textures and, in the geocentric frame, the
   * positions of vertices together in bytes; at least 2^22, default 2^29. An eighth of it, but at
   * most 12 MiB, is for the threads that read them. A value out of range is an error and changes
   * nothing.
   */
  void SetMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  //@}

  //@{
  /**
   * Set the factor of heights; at least 0.001, default 1. Colours and contour lines show the
   * heights and slopes of the raster. A value out of range is an error and changes nothing.
   */
  void SetExaggeration(double factor);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Set whether the terrain is drawn as a solid: with vertical walls at all borders, also those of
   * holes, and a bottom at BaseHeight. Default off. The solid is that of vtkTerrainMeshSource and
   * has no gaps: walls and surface share their edges to the bit. Walls and the bottom have the
   * colour of the actor and no contour lines. In the geocentric frame, walls go down along the
   * normals of the ellipsoid, and a closed raster has none at its seam and poles. The bottom has as
   * many triangles as the surface.
   */
  vtkSetMacro(UseBase, bool);
  vtkGetMacro(UseBase, bool);
  vtkBooleanMacro(UseBase, bool);
  //@}

  //@{
  /**
   * Set the height of the bottom in the unit of the raster's heights, before Exaggeration; finite,
   * default 0. Another value is an error and changes nothing. A height that is not below the
   * terrain is an error, and so is one that Exaggeration moves beyond the centre of the globe. The
   * terrain is then drawn without a base.
   */
  void SetBaseHeight(double height);
  vtkGetMacro(BaseHeight, double);
  //@}

  enum LoadingModes
  {
    BACKGROUND = 0,
    COMPLETE
  };

  //@{
  /**
   * Set whether frames wait for tiles. BACKGROUND (0, the default): they do not. COMPLETE (1): each
   * frame waits until it is complete. A value out of range is an error and changes nothing.
   */
  void SetLoadingMode(int mode);
  vtkGetMacro(LoadingMode, int);
  void SetLoadingModeToBackground() { this->SetLoadingMode(BACKGROUND); }
  void SetLoadingModeToComplete() { this->SetLoadingMode(COMPLETE); }
  //@}

  //@{
  /**
   * Set the name of an image to drape over the terrain: a file, or any other name that GDAL knows.
   * This also calls SetColorModeToImagery(). nullptr, the default, removes the image.
   *
   * The image is read in tiles, in the background and within SetMemoryLimit(), with about one texel
   * per pixel of the screen. It is converted from its coordinate system to that of the raster, and
   * lies within half of its pixel. Longitudes repeat after 360 degrees, so imagery from 0 to 360
   * covers a raster from -180 to 180. It has one band (grey or a palette), three or four; of five
   * and more bands, the third, second and first are red, green and blue. Other types than bytes are
   * scaled from their smallest to their largest value. An image of more than 8000 x 8000 pixels
   * needs overviews (gdaladdo) to be fast; without them there is a warning. Lights shine on it as
   * on other colours. The terrain has the colour of the actor where the image has no data, and in
   * proportion where it is translucent.
   *
   * An image without a georeference is stretched over the raster. If the raster has one, this is a
   * warning.
   */
  void SetImageryFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetImageryFileName();
  //@}

  //@{
  /**
   * Set the bands for red, green and blue of imagery, counted from 1. The default, (0, 0, 0), uses
   * the bands that the file declares. Other values are an error and change nothing.
   */
  void SetImageryBands(int red, int green, int blue);
  vtkGetVector3Macro(ImageryBands, int);
  //@}

  //@{
  /**
   * Set the name of a raster whose values SetColorModeToRaster() maps to colours: any raster that
   * GDAL reads, in any coordinate system and resolution. Its first band is read as imagery is, and
   * its scale and offset are applied. Palettes are not used. This also calls
   * SetColorModeToRaster(). nullptr, the default, removes the raster.
   */
  void SetColorRasterFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetColorRasterFileName();
  //@}

  enum TerrainColorModes
  {
    COLOR_SOLID = 0,
    COLOR_BY_ELEVATION,
    COLOR_BY_SLOPE,
    COLOR_BY_ASPECT,
    COLOR_BY_HILLSHADE,
    COLOR_BY_IMAGERY,
    COLOR_BY_RASTER
  };

  //@{
  /**
   * Set the colours. COLOR_SOLID (0, the default): those of the actor. COLOR_BY_ELEVATION (1): the
   * height in the unit of the raster, mapped by the lookup table. COLOR_BY_SLOPE (2): the angle
   * between the surface and the horizontal plane, from 0 to 90 degrees, mapped by the lookup table.
   * COLOR_BY_ASPECT (3): the direction in which the surface falls, from 0 to 360 degrees clockwise
   * from the y axis, mapped by the lookup table; the colour for NaN where it is flat.
   * COLOR_BY_HILLSHADE (4): grey, with the sun at an azimuth of 315 degrees and an altitude of 45
   * degrees, without the lights of the scene. COLOR_BY_IMAGERY (5): SetImageryFileName().
   * COLOR_BY_RASTER (6): the values of SetColorRasterFileName(), mapped by the lookup table; the
   * colour for NaN where it has no data.
   *
   * SetLookupTable() sets the table, whose own range is used. The default table has the range of
   * the raster's heights, of the values of the other raster, or all angles. VTK's SetColorMode()
   * and SetScalarRange() have no effect. A value out of range is an error and changes nothing.
   */
  void SetTerrainColorMode(int mode);
  vtkGetMacro(TerrainColorMode, int);
  void SetColorModeToSolid() { this->SetTerrainColorMode(COLOR_SOLID); }
  void SetColorModeToElevation() { this->SetTerrainColorMode(COLOR_BY_ELEVATION); }
  void SetColorModeToSlope() { this->SetTerrainColorMode(COLOR_BY_SLOPE); }
  void SetColorModeToAspect() { this->SetTerrainColorMode(COLOR_BY_ASPECT); }
  void SetColorModeToHillshade() { this->SetTerrainColorMode(COLOR_BY_HILLSHADE); }
  void SetColorModeToImagery() { this->SetTerrainColorMode(COLOR_BY_IMAGERY); }
  void SetColorModeToRaster() { this->SetTerrainColorMode(COLOR_BY_RASTER); }
  //@}

  //@{
  /**
   * Set whether SetColorModeToElevation() shows water: heights up to SetSeaLevel() have the colours
   * of GetWaterLookupTable(), and the lookup table colours the heights above. Default off. The
   * default lookup table then has the colours of land on maps, from the sea level to the largest
   * height.
   */
  vtkSetMacro(UseSeaLevel, bool);
  vtkGetMacro(UseSeaLevel, bool);
  vtkBooleanMacro(UseSeaLevel, bool);
  //@}

  //@{
  /**
   * Set the sea level in the unit of the raster's heights; finite, default 0. Another value is an
   * error and changes nothing.
   */
  void SetSeaLevel(double height);
  vtkGetMacro(SeaLevel, double);
  //@}

  //@{
  /**
   * Set the lookup table of water, whose own range is used. nullptr, the default, means a table of
   * blues from the smallest height, which is dark, to the sea level.
   */
  void SetWaterLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetWaterLookupTable();
  //@}

  //@{
  /**
   * Return the lookup table and the title of a legend, for example a vtkScalarBarActor: the colours
   * of the raster with water and land, or greys from 0 to 1 for a hillshade. The title names the
   * unit, such as "Height [m]". The table follows later changes of the settings, except of the
   * colour mode; then call this again. nullptr and "" for COLOR_SOLID and COLOR_BY_IMAGERY, and if
   * there is no raster.
   */
  vtkScalarsToColors* GetLegendLookupTable();
  std::string GetLegendTitle();
  //@}

  //@{
  /**
   * Set the interval of contour lines in the unit of the raster's heights; at least 0. The default,
   * 0, draws none. A value out of range is an error and changes nothing.
   */
  void SetContourInterval(double interval);
  vtkGetMacro(ContourInterval, double);
  //@}

  //@{
  /**
   * Set the width of contour lines in pixels, from 0 to 100; default 1. A value out of range is an
   * error and changes nothing.
   */
  void SetContourWidth(double pixels);
  vtkGetMacro(ContourWidth, double);
  //@}

  //@{
  /**
   * Set the colour of contour lines: red, green and blue, each from 0 to 1; default black. A value
   * out of range is an error and changes nothing.
   */
  void SetContourColor(double red, double green, double blue);
  void SetContourColor(const double color[3])
  {
    this->SetContourColor(color[0], color[1], color[2]);
  }
  vtkGetVector3Macro(ContourColor, double);
  //@}

  enum Frames
  {
    MAP = 0,
    GEOCENTRIC
  };

  //@{
  /**
   * Set the frame of the world coordinates. MAP (0, the default): a flat map in metres, see the
   * class. GEOCENTRIC (1): metres from the centre of the ellipsoid of the raster's coordinate
   * system, with z to the north pole and x to longitude 0. SetExaggeration() stretches heights
   * above the ellipsoid. Heights above EGM2008, EGM96 or EGM84 are converted to those above the
   * ellipsoid if the data of GeographicLib::Geoid are installed. Otherwise, and with other vertical
   * datums, a warning says that they are drawn as heights above the ellipsoid. What is behind the
   * horizon of the ellipsoid is not drawn, unless the actor is translucent. A raster of longitude
   * and latitude that covers all longitudes is closed: the first column follows the last. An opaque
   * globe overlaps by a column there; a translucent one has a single layer, except for a few pixels
   * where the sides have triangles of different sizes. If it ends half a sample before a pole, it
   * is continued to it, and samples of the first row are moved to it. The screen-space error
   * includes the curvature of the ellipsoid, for slopes up to 45 degrees before the exaggeration.
   * Positions of vertices take 6 kB per face, within a quarter of SetMemoryLimit() or 1 MiB. If a
   * view needs more faces, the error grows. A value out of range is an error and changes nothing.
   */
  void SetFrame(int frame);
  vtkGetMacro(Frame, int);
  void SetFrameToMap() { this->SetFrame(MAP); }
  void SetFrameToGeocentric() { this->SetFrame(GEOCENTRIC); }
  //@}

  /**
   * Divide the next frame between the processes of a controller. Each of them has the same raster,
   * settings and camera, and draws a share of the triangles, with the tiles that they need. The
   * shares have about the same number of triangles and may change from frame to frame; their
   * pictures, composited by depth, are that of one process. If the tiles of a process exceed its
   * memory limit, or a view needs more faces than it can draw, all processes draw coarser
   * triangles, so that there are no cracks between them. In LoadingMode BACKGROUND there may be
   * cracks until IsComplete() returns true. Without `isDivided`, and with a base, each process
   * draws the whole terrain.
   *
   * The call is collective: all processes make it before the frame, with the OpenGL context of the
   * renderer's window. IsComplete(), GetScreenSpaceErrorInUse() and UpdateEvent then include the
   * other processes. Without a controller (nullptr, the default) or with one process, this process
   * draws the whole terrain.
   */
  void AgreeWithProcesses(vtkMultiProcessController* controller, vtkRenderer* renderer,
    vtkActor* actor, bool isDivided = true);

  /// Return whether the last frame was drawn within SetScreenSpaceError(), with all of its tiles.
  bool IsComplete();

  /// Return the largest error of the last frame in pixels. It is more than SetScreenSpaceError()
  /// while tiles are missing, or if they do not fit into SetMemoryLimit().
  double GetScreenSpaceErrorInUse();

  /// Return the bytes that SetMemoryLimit() counts, and those of tables and patterns on the GPU.
  vtkTypeInt64 GetResidentMemorySize();

  /// Return the number of triangles of the last frame, without walls and bottoms.
  vtkIdType GetNumberOfDrawnTriangles();

  /// Return the time of the last change of the triangles that are drawn.
  vtkMTimeType GetDrawnMTime();

  //@{
  /**
   * Convert longitude and latitude in degrees, on the ellipsoid of the raster's coordinate system,
   * and a height in metres to world coordinates, and back. The actor's matrix is not applied.
   * Return false if there is no open raster with a coordinate system, or the point cannot be
   * converted.
   */
  bool GeographicToWorld(const double geographic[3], double world[3]);
  bool WorldToGeographic(const double world[3], double geographic[3]);
  //@}

  //@{
  /**
   * Convert coordinates of the raster's own system, see vtkTerrainPyramid::GetElevation(), and a
   * height in the unit of the raster to world coordinates, and back. The actor's matrix is not
   * applied. The point does not have to be on the raster or on the terrain. Return false if there
   * is no open raster or the point cannot be converted.
   */
  bool RasterToWorld(const double raster[3], double world[3]);
  bool WorldToRaster(const double world[3], double raster[3]);
  //@}

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Return the bounds of the raster: its samples, the range of its heights and the base. No tiles
   * are read.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override;
  //@}

  //@{
  /// Return whether the colours are opaque or translucent. The actor's opacity is not included.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  //@}

  /// Create a table with the range of the current colours.
  void CreateDefaultLookupTable() override;
  bool GetSupportsSelection() override { return true; }
  void ShallowCopy(vtkAbstractMapper* mapper) override;
#ifndef __VTK_WRAP__
  /// Return the terrain, with the faces that were drawn last, for other classes of Relevo; nullptr
  /// if no raster is open.
  const relevo::AdaptiveTerrain* GetDrawnTerrain() const;
#endif
  /// Includes the modification time of the pyramid.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainMapper();
  ~vtkTerrainMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  vtkSmartPointer<vtkTerrainPyramid> Pyramid;
  double ScreenSpaceError = 1.0;
  vtkTypeInt64 MemoryLimit = vtkTypeInt64(1) << 29;
  double Exaggeration = 1.0;
  bool UseBase = false;
  double BaseHeight = 0.0;
  int LoadingMode = BACKGROUND;
  int TerrainColorMode = COLOR_SOLID;
  std::string ImageryFileName;
  int ImageryBands[3] = { 0, 0, 0 };
  std::string ColorRasterFileName;
  bool UseSeaLevel = false;
  double SeaLevel = 0.0;
  vtkSmartPointer<vtkScalarsToColors> WaterLookupTable;
  double ContourInterval = 0.0;
  double ContourWidth = 1.0;
  double ContourColor[3] = { 0.0, 0.0, 0.0 };
  int Frame = MAP;

private:
  vtkTerrainMapper(const vtkTerrainMapper&) = delete;
  void operator=(const vtkTerrainMapper&) = delete;

  /// Open the raster if it is not open. Return whether it is open.
  bool UpdateTerrain();
  std::string OpenTerrain();
  void OpenImagery();
  std::string FindBaseError();
  void SetColorFile(std::string& current, const char* name, int mode);
  void UpdateDefaultTable();
  vtkScalarsToColors* UpdateColorTable();
  bool HasWater() const
  {
    return this->UseSeaLevel && this->TerrainColorMode == COLOR_BY_ELEVATION;
  }
  vtkDataObject* ReplaceInput(vtkDataObject* input);
  void SelectFaces(vtkRenderer* renderer, vtkActor* actor);
  void Divide(vtkMultiProcessController* controller, vtkRenderer* renderer, vtkActor* actor);
  void DrawFaces(vtkRenderer* renderer, vtkActor* actor);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
