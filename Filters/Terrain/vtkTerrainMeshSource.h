// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainMeshSource
 * @brief   mesh of a terrain, as it is drawn for a camera or within a vertical tolerance
 *
 * With a camera, the output is the mesh that vtkTerrainMapper draws once all tiles are loaded: at
 * every point, its vertical distance from the surface of full resolution is at most
 * ScreenSpaceError pixels. Parts of the terrain that are out of sight are left out.
 *
 * With a MaximumError above 0, the camera does not matter. The output covers the region, and its
 * vertical distance from the surface of full resolution is at most MaximumError everywhere. It is
 * computed with few triangles: longest-edge bisection (Rivara refinement) where the distance is too
 * large, then edge collapses.
 *
 * The surface of full resolution is bilinear between the centres of samples. It ends at the
 * outermost centres. Cells with a sample without data are holes. Heights are floats, so that the
 * distance can exceed MaximumError by the rounding of a float.
 *
 * Points are doubles in the map frame of vtkTerrainMapper: x east, y north, in metres from the
 * centre of the raster, and z the height in metres times Exaggeration. Longitude and latitude are
 * scaled by the lengths of a degree at the centre. Without a georeference, one sample and one unit
 * of height are one unit. Triangles are counter-clockwise seen from above. The point data have the
 * arrays "Height" (double, the unit of the raster) and "TextureCoordinates" (float, [0, 1]^2 over
 * the raster from pixel edge to pixel edge, u east, v north). The field data have "Origin" and
 * "CoordinateSystem" as those of vtkTerrainSource.
 *
 * SetFrameToGeocentric() gives earth-centred coordinates instead, without "Origin" and
 * "CoordinateSystem"; see vtkTerrainMapper. A raster that covers all longitudes is closed.
 * Triangles with two corners at a pole are left out.
 *
 * GetImagery() returns an image for vtkTexture in the texture coordinates of the mesh, if
 * SetImageryFileName() is set.
 *
 * Errors (ErrorEvent, empty output): no pyramid; an error of the pyramid; neither a camera nor a
 * MaximumError; a region that does not overlap the raster; a region that has too many samples for
 * its MaximumError; a base that is not below the mesh or beyond the centre of the globe; a mesh of
 * more than 2^26 triangles within MaximumError; a raster with one row or column; a coordinate
 * system that is not supported; imagery that is missing, unreadable, does not overlap the raster or
 * lacks one of the ImageryBands. A tile that cannot be read is reported, too; with a camera it is
 * drawn coarser.
 *
 * ProgressEvent reports the progress, and AbortExecuteOn() stops with an empty output and no error.
 *
 * @sa vtkTerrainPyramid vtkTerrainMapper
 */
#ifndef vtkTerrainMeshSource_h
#define vtkTerrainMeshSource_h

#include "RelevoFiltersTerrainModule.h" // for export macro
#include "vtkNew.h"                     // for the imagery
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for the terrain
#include <string> // for errors

class vtkCamera;
class vtkImageData;
class vtkTerrainPyramid;
namespace relevo
{
class AdaptiveTerrain;
}

class RELEVOFILTERSTERRAIN_EXPORT vtkTerrainMeshSource : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainMeshSource* New();
  vtkTypeMacro(vtkTerrainMeshSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the raster. It is updated if necessary, and its index is waited for.
   */
  void SetPyramid(vtkTerrainPyramid* pyramid);
  vtkTerrainPyramid* GetPyramid();
  //@}

  //@{
  /**
   * Set the camera for which the terrain is refined. Its position is in the map frame.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Set the width and height of the viewport in pixels; default 1280 x 800. Less than 1 is an error
   * and changes nothing.
   */
  virtual void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  //@{
  /**
   * Set the largest vertical distance as seen on the screen, in pixels, default 1: the distance
   * times H / (2 tan(angle / 2)) divided by the distance to the eye, H the height of the viewport;
   * for parallel projections, the distance times H / (2 ParallelScale). Less than 0.01 is an error
   * and changes nothing.
   */
  virtual void SetScreenSpaceError(double pixels);
  vtkGetMacro(ScreenSpaceError, double);
  //@}

  //@{
  /**
   * Set the largest vertical distance in metres (in the unit of the heights without a
   * georeference), before Exaggeration. In the geocentric frame, it includes the curvature of the
   * ellipsoid, for slopes up to 45 degrees. 0, the default: use the camera. Negative values and NaN
   * are errors and change nothing.
   */
  virtual void SetMaximumError(double meters);
  vtkGetMacro(MaximumError, double);
  //@}

  //@{
  /**
   * Set the region (xmin, xmax, ymin, ymax) for MaximumError, in the coordinates of the raster:
   * longitude and latitude in degrees if they are geographic, columns from the left and rows from
   * the bottom border without a georeference. By default, and with xmin > xmax, it is the whole
   * raster. It is extended to whole samples. NaN and infinity are errors and change nothing.
   */
  virtual void SetRegion(double xmin, double xmax, double ymin, double ymax);
  void SetRegion(const double region[4])
  {
    this->SetRegion(region[0], region[1], region[2], region[3]);
  }
  vtkGetVector4Macro(Region, double);
  //@}

  //@{
  /**
   * Set the factor for heights, default 1. NaN and infinity are errors and change nothing.
   */
  virtual void SetExaggeration(double factor);
  vtkGetMacro(Exaggeration, double);
  //@}

  //@{
  /**
   * Set whether the mesh is a solid, for example for a 3D print: it gets vertical walls at all
   * borders, also those of holes, and a bottom at BaseHeight. Default off. The mesh is closed: each
   * edge has two triangles, and all triangles are counter-clockwise seen from outside. Points where
   * only corners touch are duplicated. The first points and triangles are those of the surface. The
   * bottom has as many triangles as the surface.
   *
   * In the geocentric frame, the walls go down along the normals of the ellipsoid. A raster that
   * covers all longitudes has no walls at its seam, and none at a pole if its rows reach 90
   * degrees. Points at the seam and at poles are duplicated, because their texture coordinates
   * differ: each edge has two triangles once points at the same position are merged. With a camera,
   * the triangles on both sides of the seam can differ, and walls are then left there.
   */
  vtkSetMacro(UseBase, bool);
  vtkGetMacro(UseBase, bool);
  vtkBooleanMacro(UseBase, bool);
  //@}

  //@{
  /**
   * Set the height of the bottom in the unit of the raster's heights, before Exaggeration; finite,
   * default 0. Another value is an error and changes nothing. A height that is not below the mesh
   * is an error of the update, and so is one that Exaggeration moves beyond the centre of the
   * globe.
   */
  virtual void SetBaseHeight(double height);
  vtkGetMacro(BaseHeight, double);
  //@}

  //@{
  /**
   * Set the maximum memory of tiles in bytes; default 2^29. With a camera, parts whose tiles do not
   * fit are coarser; see GetScreenSpaceErrorInUse(). Less than 2^22 is an error and changes
   * nothing.
   */
  virtual void SetMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  //@}

  enum Frames
  {
    MAP = 0,
    GEOCENTRIC
  };

  //@{
  /**
   * Set the frame of the points, and of the camera: MAP (0, the default) or GEOCENTRIC (1), as
   * vtkTerrainMapper::SetFrame(). A value out of range is an error and changes nothing.
   */
  virtual void SetFrame(int frame);
  vtkGetMacro(Frame, int);
  void SetFrameToMap() { this->SetFrame(MAP); }
  void SetFrameToGeocentric() { this->SetFrame(GEOCENTRIC); }
  //@}

  /// Return the largest error of the output in pixels, at most; 0 with MaximumError.
  double GetScreenSpaceErrorInUse() const { return this->ErrorInUse; }

  /// Return the largest vertical distance of the output in metres, at most; 0 with a camera.
  double GetMaximumErrorInUse() const { return this->MetersInUse; }

  //@{
  /**
   * Set the name of an image to drape over the terrain, and its bands for red, green and blue, as
   * vtkTerrainSource. By default there is none.
   */
  vtkSetFilePathMacro(ImageryFileName);
  vtkGetFilePathMacro(ImageryFileName);
  virtual void SetImageryBands(int red, int green, int blue);
  void SetImageryBands(const int bands[3]) { this->SetImageryBands(bands[0], bands[1], bands[2]); }
  vtkGetVector3Macro(ImageryBands, int);
  //@}

  //@{
  /**
   * Set the maximum number of pixels per side of the imagery, 1 to 65536, default 4096. Larger
   * imagery is reduced, from its overviews if available, with a warning. Another value is an error
   * and changes nothing.
   */
  virtual void SetMaximumImagerySize(int pixels);
  vtkGetMacro(MaximumImagerySize, int);
  //@}

  /**
   * Return the imagery over the whole raster, RGB unsigned char, for vtkTexture (use EdgeClampOn()
   * and InterpolateOn()). It is (128, 128, 128) where the image has no data. Update() fills it.
   * Returns nullptr without ImageryFileName.
   */
  vtkImageData* GetImagery();

  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainMeshSource();
  ~vtkTerrainMeshSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int ViewportSize[2];
  double ScreenSpaceError;
  double MaximumError;
  double Region[4];
  double Exaggeration;
  bool UseBase;
  double BaseHeight;
  vtkTypeInt64 MemoryLimit;
  int Frame;
  char* ImageryFileName;
  int ImageryBands[3];
  int MaximumImagerySize;

private:
  vtkTerrainMeshSource(const vtkTerrainMeshSource&) = delete;
  void operator=(const vtkTerrainMeshSource&) = delete;

  std::string Build(vtkPolyData* output);
  std::string BuildView(vtkPolyData* output);
  std::string BuildRegion(vtkPolyData* output);
  std::string BuildBase(vtkPolyData* output);
  std::string DrapeImagery();
  std::string FindSamples(double columns[2], double rows[2]) const;
  std::string FindLevelError(
    int level, const double columns[2], const double rows[2], double& largest) const;

  vtkSmartPointer<vtkTerrainPyramid> Pyramid;
  vtkSmartPointer<vtkCamera> Camera;
  std::unique_ptr<relevo::AdaptiveTerrain> Terrain;
  double ErrorInUse;
  double MetersInUse;
  vtkNew<vtkImageData> Imagery;
};

#endif
