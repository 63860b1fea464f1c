// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainPyramid
 * @brief   a height raster of any size, read tile by tile
 *
 * SetFileName() takes any name that GDAL knows: a file, a VRT, a variable such as
 * NETCDF:file.nc:elevation, or a file in one of GDAL's virtual file systems (/vsizip/, /vsicurl/).
 * The first band is read, and its scale and offset are applied. A raster has up to 2^20 samples per
 * side. Update() reads the header only. Tiles of 256 x 256 samples are read when they are needed
 * and cached within a limit of memory. The file is never written to.
 *
 * Level 0 is the full resolution. The overviews of the file are the other levels. A raster without
 * overviews has one level.
 *
 * An index stores the range of each tile and the largest deviation of its surface from that of the
 * full resolution. Both surfaces are bilinear between the centres of samples. The index is a file
 * beside the raster, with the extension .relevo-index, or, if that folder is read-only, in
 * $XDG_CACHE_HOME/relevo (by default ~/.cache/relevo). It also stores the errors of terrain meshes,
 * and has about 1 KiB for each tile: 1 % of samples of 16 bits. If it does not exist, or if the
 * raster has changed, Update() starts threads that build it in the background. IsErrorKnown() tells
 * whether it is complete, and WaitForIndex() waits for it.
 *
 * If samples cannot be read, the index counts them as missing data, and IsErrorKnown() is true for
 * the others. Update() or WaitForIndex() reports one error. The index is not written to a file, so
 * that the next Update() of another object tries again. If samples of one of GDAL's virtual files
 * cannot be read, such as a file on a server, there is no index, and IsErrorKnown() stays false.
 *
 * If the file changes while it is open, reads fail until Update() opens it again. Heights of the
 * old and the new file never mix.
 *
 * A server that does not answer for 20 seconds is an error, and one that is busy is asked three
 * times, unless GDAL's options GDAL_HTTP_... say otherwise. The destructor waits for a read that
 * hangs for at most 5 seconds.
 *
 * A sample has no data if it equals the no-data value of the file, if the mask of the file excludes
 * it, or if it is NaN or infinite.
 *
 * Errors (ErrorEvent; Update() returns false): no file name; a file that is missing, empty,
 * truncated or not a raster; latitudes beyond the poles; a build without GDAL.
 *
 * Queries can be made by several threads at once, but not during Update() or a setter.
 *
 * @sa vtkHeightMap vtkTerrainSource
 */
#ifndef vtkTerrainPyramid_h
#define vtkTerrainPyramid_h

#include "RelevoFiltersTerrainModule.h" // for export macro
#include "vtkObject.h"

#include <array>  // for coordinates
#include <memory> // for members
#include <mutex>  // for messages
#include <string> // for messages
#include <vector> // for coordinates

class vtkDoubleArray;
class vtkImageData;
namespace relevo
{
class HeightLattice;
class RasterPyramid;
struct RasterDescription;
}

class RELEVOFILTERSTERRAIN_EXPORT vtkTerrainPyramid : public vtkObject
{
public:
  static vtkTerrainPyramid* New();
  vtkTypeMacro(vtkTerrainPyramid, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the raster.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * Set the folder for the file of the index; it is created if it does not exist. By default,
   * nullptr, the file is beside the raster or in the user's cache folder.
   */
  vtkSetFilePathMacro(CacheDirectory);
  vtkGetFilePathMacro(CacheDirectory);
  //@}

  //@{
  /**
   * Set the maximum memory of cached tiles in bytes, at least 2^20; default 2^28. Another value is
   * an error and changes nothing.
   */
  virtual void SetMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  //@}

  //@{
  /**
   * Set the maximum memory of the threads that build the index, in bytes; default 0, no limit. A
   * thread needs about 24 MiB, or eight times as much for files that store whole rows. Fewer
   * threads work within a lower limit, but at least one. Call this before Update(). A negative
   * number is an error and changes nothing.
   */
  virtual void SetIndexMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(IndexMemoryLimit, vtkTypeInt64);
  //@}

  /**
   * Open the raster, or open it again if the name or the file has changed, and start to build its
   * index if necessary. Returns false after an error. If calls in succession have the same error,
   * the first one reports it. An error of the background build is reported by the next call, once.
   */
  bool Update();

  //@{
  /**
   * Get the number of columns and rows of level 0; (0, 0) before a successful Update().
   */
  vtkGetVector2Macro(Dimensions, int);
  //@}

  /// Return the number of levels; 0 before a successful Update().
  int GetNumberOfLevels();

  //@{
  /**
   * Get the number of columns and rows of a level; (0, 0) for a level that does not exist.
   */
  void GetLevelDimensions(int level, int dimensions[2]);
  //@}

  //@{
  /**
   * Get the smallest and largest height. As long as IsErrorKnown() is false, this is an estimate
   * from few samples. (0, 0) if there are no data, and before a successful Update().
   */
  void GetRange(double range[2]);
  double* GetRange() VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * Get the bounds (xmin, xmax, ymin, ymax) in the raster's own coordinates, see GetElevation(),
   * from border to border of the outermost samples; (1, -1, 1, -1) before a successful Update().
   */
  void GetBounds(double bounds[4]);
  double* GetBounds() VTK_SIZEHINT(4);
  //@}

  /**
   * Get a range that contains all heights within a region (xmin, xmax, ymin, ymax) of the raster's
   * own coordinates. It is that of at most 3 x 3 entries of the index, so that no samples are read.
   * Before IsErrorKnown(), it is an estimate. Returns false and writes nothing if the region does
   * not overlap the raster or there are no data.
   */
  bool GetRangeOfRegion(const double region[4], double range[2]);

  /// Return whether the raster's own coordinates are longitude and latitude.
  bool IsGeographic();

  /// Return whether the raster has a georeference. Otherwise coordinates are columns and rows.
  bool HasGeoreference();

  /// Return the metres per unit of the heights; 1 if the raster does not declare a unit.
  double GetVerticalUnit();

  /**
   * Return whether the raster has three or more bands of bytes, as photos have. Its first band is
   * read as heights nevertheless. False before a successful Update().
   */
  bool IsPicture();

  /**
   * Return a reason to doubt the lengths of the raster, as a continuation of its name, or "": its
   * coordinates look like degrees, but there is no coordinate system, or its projection scales
   * lengths.
   */
  const char* GetLocationWarning();

  /**
   * Return a reason to doubt that the samples are heights, as a continuation of the raster's name,
   * or "": the raster is probably a photo, or its lowest or highest height is a number such as
   * -9999 that commonly stands for missing data, is far from all other heights and is not declared
   * as the no-data value. This depends on GetRange().
   */
  const char* GetSampleWarning();

  /// Return whether the index is complete, so that GetMaximumError() is finite. Samples that cannot
  /// be read do not count.
  bool IsErrorKnown();

  /// Return the fraction of the index that is complete, from 0 to 1.
  double GetIndexProgress();

  /// Return whether the build of the index has ended, with or without an error, so that
  /// WaitForIndex() returns immediately. True if no index is built.
  bool HasIndexEnded();

  /**
   * Wait until the index is complete. Returns false after an error, and without one after
   * AbortExecuteOn(). ProgressEvent reports the fraction that is complete.
   */
  bool WaitForIndex();

  //@{
  /**
   * Stop a running WaitForIndex(). The index is built nevertheless.
   */
  vtkSetMacro(AbortExecute, bool);
  vtkGetMacro(AbortExecute, bool);
  vtkBooleanMacro(AbortExecute, bool);
  //@}

  /**
   * Return the largest vertical distance between the surface of a level and that of level 0, in the
   * unit of the heights, over all points where both have data. Infinity if IsErrorKnown() is false
   * or the level does not exist.
   */
  double GetMaximumError(int level);

  /**
   * Return the height at a point, bilinear between the centres of the samples of level 0. x and y
   * are coordinates in the raster's own system: longitude and latitude in degrees if that is
   * geographic, where x and x + 360 are the same; columns from the left and rows from the bottom
   * border if the raster has no georeference. NaN outside of the raster and where a contributing
   * sample has no data. Reports an error if the samples cannot be read.
   */
  double GetElevation(double x, double y);

  /**
   * Return the heights at points, one tuple (x, y) each, as GetElevation(), and read each tile
   * once. The caller owns the new array. nullptr after an error: an array that is missing or does
   * not have two components.
   */
  VTK_NEWINSTANCE vtkDoubleArray* GetElevations(vtkDoubleArray* points);

  /**
   * Return the height of the sample whose centre is nearest to a point, as GetElevation(). NaN
   * outside of the raster and if the sample has no data.
   */
  double GetNearestElevation(double x, double y);

  /**
   * Return heights of the whole raster as an image of at most `size` points per side: every sample,
   * every second one, every fourth one and so on. Coarse ones are read from an overview, if there
   * is one. Point (i, j) of the image is at column i * spacing and row j * spacing, see
   * RasterToSample(); the scalars "Elevation" are floats, NaN without data. The caller owns the new
   * image. nullptr after an error: a size below 2, no successful Update(), or samples that cannot
   * be read.
   */
  VTK_NEWINSTANCE vtkImageData* GetReducedElevations(int size);

  //@{
  /**
   * Convert coordinates of the raster's own system to a column and a row, counted from the first
   * sample of the file, and back. They are whole numbers at the centres of samples. Points can be
   * outside of the raster. Longitudes are moved by 360 degrees if that moves them into the raster.
   * Returns false before a successful Update().
   */
  bool RasterToSample(const double coordinates[2], double sample[2]);
  bool SampleToRaster(const double sample[2], double coordinates[2]);
  //@}

  //@{
  /**
   * Convert coordinates of the raster's own system and a height in the unit of the raster to the
   * map frame of vtkTerrainMapper, and back: metres from the centre of the raster, with x east and
   * y north, and the height in metres, not exaggerated. Points can be outside of the raster.
   * Returns false before a successful Update().
   */
  bool RasterToMap(const double raster[3], double map[3]);
  bool MapToRaster(const double map[3], double raster[3]);
  //@}

  //@{
  /**
   * Convert longitude and latitude, in degrees on the ellipsoid of the raster's coordinate system,
   * to its coordinates x and y, and back. Returns false, without an error, if the raster has no
   * coordinate system or the point cannot be converted.
   */
  bool GeographicToRaster(const double geographic[2], double coordinates[2]);
  bool RasterToGeographic(const double coordinates[2], double geographic[2]);
  //@}

  /// Return the bytes of memory that cached tiles use.
  vtkTypeInt64 GetResidentMemorySize();

  /// Return the coordinate system as WKT; "" if there is none.
  const char* GetCoordinateSystem();

  /// Return the unit of the heights: m, ft, or its name in the file. If the file does not declare
  /// it, m if there is a coordinate system, otherwise "".
  const char* GetHeightUnit();

  /// Return the message of the last error, without class and line; "" if there was none.
  const char* GetErrorMessage() { return this->ErrorMessage.c_str(); }

#ifndef __VTK_WRAP__
  /// Convert many points, those that cannot be converted to NaN.
  bool GeographicToRaster(std::vector<std::array<double, 2>>& points);
  /// Return the heights that terrains are drawn from, for other classes of Relevo; nullptr before a
  /// successful Update().
  std::shared_ptr<const relevo::HeightLattice> GetLattice() const
  {
    return this->Lattice;
  }
#endif

protected:
  vtkTerrainPyramid();
  ~vtkTerrainPyramid() override;

  char* FileName;
  char* CacheDirectory;
  vtkTypeInt64 MemoryLimit;
  vtkTypeInt64 IndexMemoryLimit;
  bool AbortExecute;

private:
  vtkTerrainPyramid(const vtkTerrainPyramid&) = delete;
  void operator=(const vtkTerrainPyramid&) = delete;

  bool Report(const std::string& error);
  bool ReportOpening(const std::string& error); // once in succession
  bool Convert(bool (*convert)(const std::string&, std::array<double, 2>&), const double from[2],
    double to[2]);
  std::array<double, 2> ToSamples(double x, double y);
  const relevo::RasterDescription* Describe() const;
  double Evaluate(const std::array<double, 2>& place, std::string& error);

  std::shared_ptr<relevo::RasterPyramid> Pyramid;
  std::shared_ptr<const relevo::HeightLattice> Lattice;
  std::string OpenedName;
  std::string OpenedCacheDirectory;
  std::recursive_mutex ReportMutex; // observers may ask for heights
  std::string ErrorMessage;
  std::string OpeningError; // of the last Update()
  bool HasReportedIndex;
  int Dimensions[2];
  double Range[2];
  double Bounds[4];
  std::string LocationWarning;
  std::string SampleWarning;
};

#endif
