// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightMap
 * @brief   heights from a raster file or from a vtkImageData
 *
 * SetFileName() reads heights from a file: GeoTIFF, TIFF, PNG, OpenEXR and the other formats of
 * OpenImageIO, and in builds with GDAL also SRTM .hgt, USGS DEM and the other formats of GDAL. The
 * first band is read. Samples are not normalized to [0, 1]; scale and offset are applied if the
 * file declares them. Heights are stored as float, which is exact for integers up to 2^24.
 * Georeferenced rasters are oriented so that u points east and v north. In other rasters, v = 0 is
 * the last row of the file.
 *
 * SetImageData() takes heights from an image in memory instead: the first component of the active
 * point scalars of an image of n x m x 1 points, of any type. v = 0 is the first row, or the last
 * one with FlipRowsOn(). Blanked points have no data. Origin, spacing and extent are ignored. The
 * image takes precedence over the file. Update() checks its modification time.
 *
 * Rasters with more than MaximumDimension texels per side are reduced to the largest size of the
 * same aspect ratio that fits, with a warning. Each reduced height is the area-weighted mean of the
 * valid heights that it covers. The file is read row by row, from the smallest sufficient overview
 * or mip level, so that memory depends on the reduced size: 4 bytes per texel, or 5 if data may be
 * missing, and 1.7 more while gaps are filled.
 *
 * A sample is missing if it equals NoDataValue or the no-data value that the file declares (through
 * GDAL), compared in the type of the raster, or if the mask of the file excludes it. Missing
 * samples get smooth heights interpolated from their valid neighbours.
 * vtkHeightField::GetValidity() distinguishes them.
 *
 * Update() reports an error (ErrorEvent) and returns false if there is neither a file nor an image;
 * the file is missing, empty, truncated or unreadable; a height is NaN or infinite and not declared
 * as no data; no sample has data; or the image is not flat or has no scalars.
 *
 * ProgressEvent reports the fraction that has been read. An observer can call AbortExecuteOn() to
 * stop reading. Filters in several threads can share a height map: the first one reads it, and the
 * others wait.
 *
 * @sa vtkDisplacement vtkTerrainSource
 */
#ifndef vtkHeightMap_h
#define vtkHeightMap_h

#include "RelevoFiltersTerrainModule.h" // for export macro
#include "vtkHeightField.h"
#include "vtkSmartPointer.h" // for the image
#include "vtkTimeStamp.h"    // for the caches

#include <memory> // for the grid
#include <mutex>  // for updates
#include <string> // for messages

class vtkImageData;
namespace relevo
{
class HeightGrid;
class Raster;
struct RasterDescription;
}

class RELEVOFILTERSTERRAIN_EXPORT vtkHeightMap : public vtkHeightField
{
public:
  static vtkHeightMap* New();
  vtkTypeMacro(vtkHeightMap, vtkHeightField);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the raster file.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * Set an image that provides the heights instead of a file; nullptr returns to the file.
   */
  virtual void SetImageData(vtkImageData* image);
  vtkImageData* GetImageData();
  //@}

  //@{
  /**
   * Set whether the rows of the image are in the order of raster files, in which the first row is
   * the northern one, at v = 1; default off. Such an array in memory need not be copied into the
   * order of VTK. Files have an order of their own.
   */
  vtkSetMacro(FlipRows, bool);
  vtkGetMacro(FlipRows, bool);
  vtkBooleanMacro(FlipRows, bool);
  //@}

  //@{
  /**
   * Set a sample value that means "no data", in addition to the one that the file declares. NaN
   * marks NaN samples as missing. UnsetNoDataValue() restores the default: only the
   * declared value is used. GetNoDataValue() returns the value that was set; otherwise, after
   * Update(), the declared one; otherwise NaN.
   */
  virtual void SetNoDataValue(double value);
  virtual double GetNoDataValue();
  virtual void UnsetNoDataValue();
  //@}

  //@{
  /**
   * Set the maximum number of texels per side, 0 for no limit; default 16384, which every
   * implementation of OpenGL 4.1 and later supports. Other limits depend on the graphics card (see
   * vtkTextureObject::GetMaximumTextureSize()). A negative number is an error and changes nothing.
   */
  virtual void SetMaximumDimension(int dimension);
  vtkGetMacro(MaximumDimension, int);
  //@}

  //@{
  /**
   * Stop a running Update(), which then returns false without an error.
   */
  vtkSetMacro(AbortExecute, bool);
  vtkGetMacro(AbortExecute, bool);
  vtkBooleanMacro(AbortExecute, bool);
  //@}

  bool Update() override;

  /**
   * Release the heights. The next Update() reads them again.
   */
  void ReleaseHeights();

  /**
   * Open the file and read its header, for GetFullDimensions(). The file stays open for the next
   * Update(). Returns false after an ErrorEvent if the file cannot be opened.
   */
  bool UpdateInformation();

  //@{
  /**
   * Return the message of the last ErrorEvent or WarningEvent of Update() or UpdateInformation(),
   * without class and source line; "" if there was none.
   */
  const char* GetErrorMessage() override { return this->ErrorMessage.c_str(); }
  const char* GetWarningMessage() { return this->WarningMessage.c_str(); }
  //@}

  //@{
  /**
   * Get the number of columns and rows; (0, 0) before a successful Update().
   */
  void GetDimensions(int dimensions[2]) override;
  int* GetDimensions() VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * Get the number of columns and rows of the file or image before any reduction; (0, 0) before a
   * successful Update() or UpdateInformation().
   */
  void GetFullDimensions(int dimensions[2]);
  int* GetFullDimensions() VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * Get the smallest and largest valid height, in the unit of the raster; (0, 0) before a
   * successful Update().
   */
  void GetRange(double range[2]) override;
  double* GetRange() VTK_SIZEHINT(2);
  //@}

  /**
   * Return the height in a column and row, with row 0 at v = 0. Where data is missing, this is the
   * interpolated height. Returns 0 outside of the raster or before a successful Update().
   */
  double GetSample(int column, int row);

  bool HasNoData() override;
  vtkMTimeType GetSamplesMTime() override;
  //@{
  /**
   * Return all samples in rows, in the order of GetSample(), and 1 or 0 for each sample that is
   * valid or not (nullptr, None in Python, if all are valid). Python receives tuples. Returns
   * nullptr before a successful Update().
   */
  const float* GetSamples() VTK_SIZEHINT(GetNumberOfSamples()) override;
  const unsigned char* GetValidity() VTK_SIZEHINT(GetNumberOfSamples()) override;
  //@}
  /// Return columns times rows; 0 before a successful Update().
  vtkIdType GetNumberOfSamples();
#ifndef __VTK_WRAP__
  std::shared_ptr<const unsigned char> ShareValidity() override;
#endif

  vtkMTimeType GetMTime() override;

protected:
  vtkHeightMap();
  ~vtkHeightMap() override;

  char* FileName;
  vtkSmartPointer<vtkImageData> ImageData;
  bool FlipRows;
  double NoDataValue;
  bool NoDataValueSet;
  double DeclaredNoDataValue;
  int MaximumDimension;
  bool AbortExecute;

private:
  vtkHeightMap(const vtkHeightMap&) = delete;
  void operator=(const vtkHeightMap&) = delete;

  friend class vtkHeightMapToRelief; // for Describe()
  friend class vtkTerrainSource;

  bool Open();
  void Clear();
  bool Read();
  bool ReadFile(relevo::HeightGrid& grid, std::string& error);
  bool ReadImage(relevo::HeightGrid& grid, std::string& error);

  /// Return the description of the file or image; needs a successful UpdateInformation().
  const relevo::RasterDescription& Describe() const
  {
    return *this->Description;
  }

  std::unique_ptr<relevo::Raster> Raster; // null except between opening and reading
  std::unique_ptr<relevo::RasterDescription> Description;
  vtkTimeStamp DescriptionTime;
  std::shared_ptr<const relevo::HeightGrid> Grid; // null after a failure
  std::string ErrorMessage;
  std::string WarningMessage;
  int Dimensions[2];
  int FullDimensions[2];
  double Range[2];
  vtkTimeStamp UpdateTime;
  vtkTimeStamp SamplesTime;
  std::recursive_mutex UpdateMutex; // recursive because observers of an update may request heights
};

#endif
