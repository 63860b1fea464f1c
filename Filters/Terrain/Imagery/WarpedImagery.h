// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpedImagery
 * @brief   an image file, warped tile by tile to the lattices of a height raster
 *
 * GDAL warps each tile from the coarsest overview of the file that is at least as fine as the tile.
 * A GDAL dataset belongs to one thread at a time, so each thread gets datasets of its own. If the
 * file changes while it is open, all reads fail, so that old and new pixels never mix.
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef WarpedImagery_h
#define WarpedImagery_h

#include "Imagery/ImageryOptions.h"
#include "Lattice/ImageryLattice.h"
#include "Raster/FileVersion.h"
#include "Raster/ImageryPicture.h"
#include "Raster/RasterDescription.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT WarpedImagery : public ImageryLattice
{
public:
  /// See OpenImagery().
  static std::shared_ptr<const WarpedImagery> Open(const ImageryOptions& options,
    const RasterDescription& terrain, std::string& warning, std::string& error);
  ~WarpedImagery() override;

  bool HasNumbers() const override { return this->Options.HasNumbers; }
  std::array<double, 2> GetRange() const override { return this->Range; }
  std::string GetName() const override { return this->Name; }
  std::string GetUnit() const override { return this->Unit; }
  int GetFinestLevel() const override { return this->FinestLevel; }
  bool Covers(int level, int column, int row) const override;
  bool Read(ImageryTile& tile, std::string& error) const override;

private:
  struct Handle;
  class Lease;

  WarpedImagery() = default;
  const ImageryPicture* GetPicture(
    Handle& handle, int overview, const GDALSession& session, std::string& error) const;
  GDALDatasetPointer CreateTarget(int level, double column, double row, int size) const;
  double FindPeriod() const;
  void SetExtent(const std::array<double, 2>& columns, const std::array<double, 2>& rows);
  void SetFinestLevel(double pixelsPerSample);
  void DescribeNumbers(const ImageryPicture& picture);
  void Convert(const std::vector<float>& values, ImageryTile& tile) const;
  std::string Measure(const ImageryPicture& picture, const GDALSession& session);
  std::array<double, 2> MeasureReduction(
    const ImageryPicture& picture, GDALDatasetH target, const std::array<int, 4>& window) const;
  std::array<int, 4> GetWindow(const ImageryTile& tile) const;

  bool ReadTile(
    Handle& handle, const GDALSession& session, ImageryTile& tile, std::string& error) const;

  ImageryOptions Options;
  FileVersion Version;
  Georeference Location; // of the raster, or the unit square
  std::array<int, 2> Size = { { 0, 0 } };
  bool IsTerrainLocated = false;
  ImageryPicture::Stretch Stretch; // of colours
  // A number is Scale * value + Offset.
  double Scale = 1.0;
  double Offset = 0.0;
  std::array<double, 2> Range = { { 0.0, 0.0 } };
  std::string Name;
  std::string Unit;
  int FinestLevel = 0;
  // The columns and rows of the raster that imagery may cover. Columns repeat after 360 degrees.
  std::vector<std::array<double, 2>> Columns;
  std::array<double, 2> Rows = { { 0.0, 0.0 } };

  mutable std::mutex Mutex;
  mutable std::vector<std::unique_ptr<Handle>> Free; // handles that no thread uses
};
}

#endif
