// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/ImageryPicture.h"

#include "Raster/ImageryTransformer.h"
#include "Raster/RawFile.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_utils.h>
#include <gdalwarper.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace relevo
{
namespace
{
// Error tolerance in pixels of linear interpolation between exactly transformed pixels.
constexpr double TransformTolerance = 0.125;

// Bytes of pixels that GDAL has in memory for a window; larger ones are divided.
constexpr double MemoryOfWindow = 1 << 23;

template <typename Options, void (*Free)(Options*)>
struct Freer
{
  void operator()(Options* options) const { Free(options); }
};
using TranslateOptions =
  std::unique_ptr<GDALTranslateOptions, Freer<GDALTranslateOptions, GDALTranslateOptionsFree>>;
using WarpOptions =
  std::unique_ptr<GDALWarpOptions, Freer<GDALWarpOptions, GDALDestroyWarpOptions>>;

struct TransformerFreer
{
  void operator()(void* transformer) const { GDALDestroyTransformer(transformer); }
};

struct WarpOperationFreer
{
  void operator()(void* operation) const
  {
    GDALDestroyWarpOperation(static_cast<GDALWarpOperationH>(operation));
  }
};

// Windows of at most this size are not divided further.
constexpr int SmallestWindow = 8;

// The columns of an image that a window of a target needs are within a distance of the middle.
struct WarpColumns
{
  double Middle = 0.0;
  double Distance = 0.0;
};

// Points outside of a projection do not count.
WarpColumns FindColumns(const ImageryTransformer& transformer, const std::array<int, 4>& window)
{
  constexpr int points = 5; // per side
  std::vector<double> found;
  for (int i = 0; i < points * points; ++i)
  {
    const ImageryTransformer::Point point =
      transformer.ToImage({ { window[0] + window[2] * (i % points) / (points - 1.0),
        window[1] + window[3] * (i / points) / (points - 1.0) } });
    if (point.IsKnown)
    {
      found.push_back(point.Position[0]);
    }
  }
  WarpColumns columns;
  columns.Middle = found.empty() ? 0.0 : found[found.size() / 2];
  for (const double column : found)
  {
    columns.Distance = std::max(
      columns.Distance, std::abs(transformer.GetNearest(column, columns.Middle) - columns.Middle));
  }
  return columns;
}

bool WarpOnce(GDALWarpOptions* options, const std::array<int, 4>& window)
{
  const std::unique_ptr<void, WarpOperationFreer> operation(GDALCreateWarpOperation(options));
  return operation &&
    GDALChunkAndWarpImage(static_cast<GDALWarpOperationH>(operation.get()), window[0], window[1],
      window[2], window[3]) == CE_None;
}

// Warps an image that repeats. Windows are divided until each is within a quarter of a turn around
// its middle: GDAL would miss a jump of the columns. A window at the seam of the image needs it
// twice.
bool WarpTurns(
  GDALWarpOptions* options, ImageryTransformer& transformer, const std::array<int, 4>& window)
{
  const double period = transformer.GetPeriod();
  const WarpColumns columns = FindColumns(transformer, window);
  const int axis = window[3] > window[2] ? 1 : 0;
  if (columns.Distance > 0.25 * period && window[2 + axis] > SmallestWindow)
  {
    std::array<int, 4> first = window;
    std::array<int, 4> second = window;
    first[2 + axis] /= 2;
    second[axis] += first[2 + axis];
    second[2 + axis] -= first[2 + axis];
    return WarpTurns(options, transformer, first) && WarpTurns(options, transformer, second);
  }
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", "0");
  for (int turn = -1; turn <= 1; ++turn)
  {
    const double middle = columns.Middle + turn * period;
    const double distance = std::max(columns.Distance, 0.25 * period);
    if (middle + distance < 0.0 || middle - distance > GDALGetRasterXSize(options->hSrcDS))
    {
      continue;
    }
    transformer.SetMiddle(middle);
    if (!WarpOnce(options, window))
    {
      return false;
    }
    // The next turn adds to the first one.
    options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", nullptr);
  }
  return true;
}

// The bands for red, green, blue and alpha; 0 for none.
struct Bands
{
  std::array<int, ImageryPicture::NumberOfColors> Colors;
  int Alpha = 0;
};

bool chooseBands(
  GDALDatasetH dataset, const std::array<int, 3>& wanted, Bands& bands, std::string& error)
{
  const int count = GDALGetRasterCount(dataset);
  bands.Colors = DefaultBands(count);
  std::array<int, 3> declared = { 0, 0, 0 };
  for (int i = 1; i <= count; ++i)
  {
    const GDALColorInterp meaning = GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset, i));
    if (meaning >= GCI_RedBand && meaning <= GCI_BlueBand)
    {
      declared[meaning - GCI_RedBand] = i;
    }
    if (meaning == GCI_AlphaBand)
    {
      bands.Alpha = i;
    }
  }
  if (std::find(declared.begin(), declared.end(), 0) == declared.end())
  {
    bands.Colors = declared;
  }
  if (wanted != std::array<int, 3>{ 0, 0, 0 })
  {
    bands.Colors = wanted;
  }
  for (int band : bands.Colors)
  {
    if (band < 1 || band > count)
    {
      error = "it has no band " + std::to_string(band) + "; it has " + std::to_string(count) +
        (count == 1 ? " band" : " bands");
      return false;
    }
  }
  return true;
}

bool hasLocation(GDALDatasetH dataset)
{
  double transform[6];
  return GDALGetGeoTransform(dataset, transform) == CE_None || GDALGetGCPCount(dataset) > 0;
}

GDALDatasetPointer translate(GDALDatasetH dataset, std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), { "-of", "VRT" });
  std::vector<char*> list;
  for (std::string& argument : arguments)
  {
    list.push_back(&argument[0]);
  }
  list.push_back(nullptr);
  const TranslateOptions options(GDALTranslateOptionsNew(list.data(), nullptr));
  return GDALDatasetPointer(options ? GDALTranslate("", dataset, options.get(), nullptr) : nullptr);
}

// Returns a view of the dataset with the colour bands first, then alpha if available.
GDALDatasetPointer selectBands(GDALDatasetH dataset, const Bands& bands)
{
  // With metadata, GDAL adds the bands to a new VRT. Otherwise it copies the XML of a dataset that
  // is a VRT, and crashes if the dataset is an overview of one (seen with GDAL 3.6).
  std::vector<std::string> arguments = { "-mo", "VIEW=imagery" };
  for (int band : bands.Colors)
  {
    arguments.insert(arguments.end(), { "-b", std::to_string(band) });
  }
  if (bands.Alpha)
  {
    arguments.insert(arguments.end(), { "-b", std::to_string(bands.Alpha) });
  }
  return translate(dataset, arguments);
}
}

bool ImageryPicture::Open(const std::string& fileName, const std::array<int, 3>& wantedBands,
  bool isTerrainLocated, int overview, const GDALSession& session, std::string& error,
  bool isExpanded)
{
  const std::string level = "OVERVIEW_LEVEL=" + std::to_string(overview);
  const char* options[] = { overview < 0 ? nullptr : level.c_str(), nullptr };
  this->Dataset.reset(
    GDALOpenEx(fileName.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, options, nullptr));
  const GDALDatasetH dataset = this->Dataset.get();
  if (!dataset || GDALGetRasterCount(dataset) < 1)
  {
    return false;
  }
  error = FindTruncation(dataset);
  if (!error.empty())
  {
    return false;
  }
  this->HasGeoreference = hasLocation(dataset);
  this->Located = this->HasGeoreference && isTerrainLocated;
  const bool hasIndices = isExpanded && GDALGetRasterCount(dataset) == 1 &&
    GDALGetRasterColorTable(GDALGetRasterBand(dataset, 1));
  this->Expanded = hasIndices ? translate(dataset, { "-expand", "rgba" }) : nullptr;
  const GDALDatasetH colors = this->Expanded ? this->Expanded.get() : dataset;
  Bands bands;
  if (!chooseBands(colors, wantedBands, bands, error))
  {
    return false;
  }
  this->HasAlpha = bands.Alpha != 0;
  this->View = selectBands(colors, bands);
  if (!this->View)
  {
    error = session.Messages("its bands cannot be selected");
    return false;
  }
  if (!this->Located)
  {
    this->StretchOverUnitSquare();
  }
  return true;
}

// Georeferences the image to the unit square.
void ImageryPicture::StretchOverUnitSquare()
{
  double unitSquare[6] = { 0.0, 1.0 / GDALGetRasterXSize(this->View.get()), 0.0, 1.0, 0.0,
    -1.0 / GDALGetRasterYSize(this->View.get()) };
  GDALSetGCPs(this->View.get(), 0, nullptr, "");
  GDALSetProjection(this->View.get(), "");
  GDALSetGeoTransform(this->View.get(), unitSquare);
}

void ImageryPicture::ReleaseBlocks() const
{
  const std::string driver = GDALGetDriverShortName(GDALGetDatasetDriver(this->Dataset.get()));
  if (driver != "PNG" && driver != "JPEG" && driver != "GIF")
  {
    GDALFlushCache(this->View.get());
    GDALFlushCache(this->Dataset.get());
  }
}

ImageryPicture::Stretch ImageryPicture::FindStretch() const
{
  Stretch stretch;
  if (GDALGetRasterDataType(GDALGetRasterBand(this->View.get(), 1)) == GDT_Byte)
  {
    return stretch;
  }
  stretch.Low = std::numeric_limits<double>::max();
  stretch.High = std::numeric_limits<double>::lowest();
  for (int i = 1; i <= NumberOfColors; ++i)
  {
    double range[2] = { 0.0, 0.0 };
    GDALComputeRasterMinMax(GDALGetRasterBand(this->View.get(), i), true, range);
    stretch.Low = std::min(stretch.Low, range[0]);
    stretch.High = std::max(stretch.High, range[1]);
  }
  return stretch;
}

int ImageryPicture::ChooseOverview(double reduction) const
{
  const GDALRasterBandH band = GDALGetRasterBand(this->Dataset.get(), 1);
  int chosen = -1;
  double best = 1.0;
  for (int i = 0; i < GDALGetOverviewCount(band); ++i)
  {
    const GDALRasterBandH overview = GDALGetOverview(band, i);
    const int width = overview ? GDALGetRasterBandXSize(overview) : 0;
    const double factor =
      width > 0 ? static_cast<double>(GDALGetRasterXSize(this->Dataset.get())) / width : 0.0;
    if (factor > best && factor <= reduction)
    {
      chosen = i;
      best = factor;
    }
  }
  return chosen;
}

GDALDatasetPointer ImageryPicture::CreateTarget(
  int width, int height, const std::array<double, 6>& transform, const std::string& system)
{
  GDALDatasetPointer target(GDALCreate(
    GDALGetDriverByName("MEM"), "", width, height, NumberOfComponents, GDT_Float32, nullptr));
  if (target)
  {
    std::array<double, 6> coefficients = transform;
    GDALSetGeoTransform(target.get(), coefficients.data());
    GDALSetProjection(target.get(), system.c_str());
    GDALSetRasterColorInterpretation(
      GDALGetRasterBand(target.get(), NumberOfComponents), GCI_AlphaBand);
  }
  return target;
}

bool ImageryPicture::Warp(GDALDatasetH target, const std::array<int, 4>& window,
  const std::array<double, 2>& reduction) const
{
  const GDALDatasetH source = this->View.get();
  ImageryTransformer exact(source, target);
  if (!exact.IsValid())
  {
    return false;
  }
  const std::unique_ptr<void, TransformerFreer> approximate(
    GDALCreateApproxTransformer(ImageryTransformer::Transform, &exact, TransformTolerance));
  const WarpOptions options(GDALCreateWarpOptions());
  options->hSrcDS = source;
  options->hDstDS = target;
  options->eResampleAlg = GRA_Bilinear;
  options->eWorkingDataType = GDT_Float32;
  options->pfnTransformer = GDALApproxTransform;
  options->pTransformerArg = approximate.get();
  GDALWarpInitDefaultBandMapping(options.get(), NumberOfColors);
  options->nSrcAlphaBand = this->HasAlpha ? NumberOfColors + 1 : 0;
  options->nDstAlphaBand = NumberOfColors + 1;
  char**& extra = options->papszWarpOptions;
  extra = CSLSetNameValue(extra, "INIT_DEST", "0");
  extra = CSLSetNameValue(extra, "DST_ALPHA_MAX", "255");
  extra = CSLSetNameValue(extra, "UNIFIED_SRC_NODATA", "YES");

  if (reduction[0] > 0.0 && reduction[1] > 0.0)
  {
    options->dfWarpMemoryLimit = MemoryOfWindow;
    // Otherwise GDAL estimates these from the window, and the filter differs between windows.
    extra = CSLSetNameValue(extra, "XSCALE", std::to_string(1.0 / reduction[0]).c_str());
    extra = CSLSetNameValue(extra, "YSCALE", std::to_string(1.0 / reduction[1]).c_str());
  }

  int declared = 0;
  GDALGetRasterNoDataValue(GDALGetRasterBand(source, 1), &declared);
  if (declared)
  {
    options->padfSrcNoDataReal = static_cast<double*>(CPLMalloc(NumberOfColors * sizeof(double)));
    for (int i = 0; i < NumberOfColors; ++i)
    {
      options->padfSrcNoDataReal[i] =
        GDALGetRasterNoDataValue(GDALGetRasterBand(source, i + 1), nullptr);
    }
  }
  return exact.GetPeriod() > 0.0 ? WarpTurns(options.get(), exact, window)
                                 : WarpOnce(options.get(), window);
}
}
