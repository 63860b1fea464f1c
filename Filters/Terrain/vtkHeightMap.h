// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightMap
 * @brief   heights from a raster file or from a vtkImageData
 *
 * Files (SetFileName): GeoTIFF, TIFF, PNG, OpenEXR and whatever else OpenImageIO reads, and, in
 * builds with GDAL, SRTM .hgt, USGS DEM and GDAL's other formats. The first band counts. Heights
 * are the stored samples, never normalized to [0, 1], times the scale and plus the offset that the
 * file declares for them (rarely any); they are kept as floats, so that whole numbers are exact up
 * to 2^24. Georeferenced rasters are turned so that u runs east and v north; else, and for north-up
 * rasters, v = 0 is the last row of the file.
 *
 * Images (SetImageData): the active point scalars of any type, first component, of an image that is
 * n x m x 1 points; v = 0 is its first row. Blanked points have no data. Origin, spacing and extent
 * do not matter. An image, once set, takes precedence over the file; Update() follows its
 * modification time.
 *
 * Sizes: more than MaximumDimension texels a side are reduced, with a warning, to the largest size
 * of the same proportions that has no more; each height is then the mean of those with data that it
 * covers, by area. The file is read row by row, or its overview or mip level that is just large
 * enough, so that memory depends on the reduced size: 4 bytes per texel, 5 where there may be no
 * data, and 1.7 more while gaps are filled.
 *
 * No data: samples equal, in the raster's own type, to the value that the file declares (through
 * GDAL) or to NoDataValue, and those that the file's mask excludes. They take smooth heights from
 * the valid neighbours (vtkHeightField::GetValidity tells them apart).
 *
 * Errors (ErrorEvent, Update() returns false): no file and no image; a missing, empty, truncated or
 * unreadable file; heights that are NaN or infinite without being declared as no data; no sample
 * with data; an image that is not flat or has no scalars.
 *
 * ProgressEvent reports the share read so far; AbortExecuteOn(), from an observer, stops it.
 * Filters in several threads may share a height map: the first that needs it reads it, and the
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
   * The raster file.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * The image to take heights from in place of a file; nullptr returns to the file.
   */
  virtual void SetImageData(vtkImageData* image);
  vtkImageData* GetImageData();
  //@}

  //@{
  /**
   * A sample value that means "no data", besides what the file itself declares. NaN declares NaN
   * samples as such. GetNoDataValue gives the value that was set, or, after Update(), the one that
   * the file declares, or NaN. UnsetNoDataValue leaves it to the file (default).
   */
  virtual void SetNoDataValue(double value);
  virtual double GetNoDataValue();
  virtual void UnsetNoDataValue();
  //@}

  //@{
  /**
   * The most texels that are kept per side, 0 for any number. Default 16384, which every texture of
   * OpenGL 4.1 and later can have; a graphics card may take more or, before 4.1, less
   * (vtkTextureObject::GetMaximumTextureSize()). Less than 0 is an error and changes nothing.
   */
  virtual void SetMaximumDimension(int dimension);
  vtkGetMacro(MaximumDimension, int);
  //@}

  //@{
  /**
   * Stops a running Update(), which returns false without an error.
   */
  vtkSetMacro(AbortExecute, bool);
  vtkGetMacro(AbortExecute, bool);
  vtkBooleanMacro(AbortExecute, bool);
  //@}

  bool Update() override;

  /**
   * Frees the heights. Until the next Update(), which reads them again, there are none.
   */
  void ReleaseHeights();

  /**
   * Opens the file and reads its header: GetFullDimensions(). The file stays open for the next
   * Update(), which does not open it again. Returns false, after an ErrorEvent, when the file
   * cannot be opened.
   */
  bool UpdateInformation();

  //@{
  /**
   * What the ErrorEvent or WarningEvent of the last Update() or UpdateInformation() said, without
   * class and source line; "" when there was none.
   */
  const char* GetErrorMessage() override { return this->ErrorMessage.c_str(); }
  const char* GetWarningMessage() { return this->WarningMessage.c_str(); }
  //@}

  //@{
  /**
   * Number of columns and rows; (0, 0) before a successful Update().
   */
  void GetDimensions(int dimensions[2]) override;
  int* GetDimensions() VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * Number of columns and rows of the file or the image, before any reduction; (0, 0) before a
   * successful Update() or UpdateInformation().
   */
  void GetFullDimensions(int dimensions[2]);
  int* GetFullDimensions() VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * Smallest and largest valid height in the raster's own unit; (0, 0) before a successful
   * Update().
   */
  void GetRange(double range[2]) override;
  double* GetRange() VTK_SIZEHINT(2);
  //@}

  /**
   * The height in a column and row as the displacement samples them: row 0 at v = 0. The fill
   * where there is no data; 0 outside or without a successful Update().
   */
  double GetSample(int column, int row);

  bool HasNoData() override;
  vtkMTimeType GetSamplesMTime() override;
  //@{
  /**
   * All samples, row after row, as GetSample() has them, and whether they are valid (nullptr, None
   * in Python, where all are); in Python tuples. nullptr without a successful Update().
   */
  const float* GetSamples() VTK_SIZEHINT(GetNumberOfSamples()) override;
  const unsigned char* GetValidity() VTK_SIZEHINT(GetNumberOfSamples()) override;
  //@}
  /// Columns times rows; 0 before a successful Update().
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
  double NoDataValue;
  bool NoDataValueSet;
  double DeclaredNoDataValue;
  int MaximumDimension;
  bool AbortExecute;

private:
  vtkHeightMap(const vtkHeightMap&) = delete;
  void operator=(const vtkHeightMap&) = delete;

  friend class vtkHeightMapToRelief; // for the description
  friend class vtkTerrainSource;

  bool Open();
  void Clear();
  bool Read();
  bool ReadFile(relevo::HeightGrid& grid, std::string& error);
  bool ReadImage(relevo::HeightGrid& grid, std::string& error);

  /// What the file or the image is, after a successful UpdateInformation().
  const relevo::RasterDescription& Describe() const
  {
    return *this->Description;
  }

  std::unique_ptr<relevo::Raster> Raster; // from its opening until it is read
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
  std::recursive_mutex UpdateMutex; // recursive: observers of an update may ask for heights
};

#endif
