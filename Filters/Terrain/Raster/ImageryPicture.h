// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ImageryPicture
 * @brief   an image file, or an overview of it, from which GDAL's warper resamples imagery
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef ImageryPicture_h
#define ImageryPicture_h

#include "Geodesy/GDALSession.h"
#include "Raster/Imagery.h"

#include <array>
#include <string>

namespace relevo
{
class ImageryPicture
{
public:
  static constexpr int NumberOfColors = 3;
  static constexpr int NumberOfComponents = NumberOfColors + 1; // with alpha

  /// Maps colours to bytes. Bytes are used unchanged. Other types are scaled from their smallest
  /// and largest value.
  struct Stretch
  {
    double Low = 0.0;
    double High = 255.0;

    double operator()(double value) const
    {
      return this->High > this->Low ? 255.0 * (value - this->Low) / (this->High - this->Low) : 0.0;
    }
  };

  /**
   * Open a file, or an overview of it; -1 for the full image. If the file or the terrain has no
   * georeference, the image is stretched over the unit square. With `isExpanded`, indices of a
   * palette become colours. Returns false on failure, with an empty `error` if GDAL cannot open the
   * file.
   */
  bool Open(const std::string& fileName, const std::array<int, 3>& bands, bool isTerrainLocated,
    int overview, const GDALSession& session, std::string& error, bool isExpanded = true);

  GDALDatasetH GetFile() const { return this->Dataset.get(); }
  /// The bands for red, green and blue, then alpha if available.
  GDALDatasetH GetView() const { return this->View.get(); }
  /// Whether the georeferences of the file and of the terrain are used.
  bool IsLocated() const { return this->Located; }
  /// Whether the file has a georeference.
  bool HasLocation() const { return this->HasGeoreference; }

  /// The range of the colours. GDAL estimates it from some of the pixels.
  Stretch FindStretch() const;

  /// The index of the smallest overview with at least the required resolution; -1 for none.
  int ChooseOverview(double reduction) const;

  /// Create an image in memory for colours and alpha as floats; nullptr on failure.
  static GDALDatasetPointer CreateTarget(
    int width, int height, const std::array<double, 6>& transform, const std::string& system);

  /**
   * Resample into a window of such an image: its first column and row, its width and its height.
   * `reduction` has the pixels of the view per pixel of the target, along its columns and rows, for
   * the width of the filter; zeros if they are not known. Images of longitude and latitude repeat
   * after 360 degrees.
   */
  bool Warp(GDALDatasetH target, const std::array<int, 4>& window,
    const std::array<double, 2>& reduction = { { 0.0, 0.0 } }) const;

  /// Limit memory: GDAL would cache blocks up to a fraction of the memory of the machine. Formats
  /// that must be decoded from the start keep their cache.
  void ReleaseBlocks() const;

private:
  void StretchOverUnitSquare();

  GDALDatasetPointer Dataset;
  GDALDatasetPointer Expanded; // palette indices expanded to colours; must outlive the view
  GDALDatasetPointer View;
  bool HasAlpha = false;
  bool Located = false;
  bool HasGeoreference = false;
};
}

#endif
