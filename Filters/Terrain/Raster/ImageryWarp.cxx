// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/ImageryWarp.h"

#include "Geodesy/GDALSession.h"
#include "Raster/RawFile.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_utils.h>
#include <gdalwarper.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
constexpr int NumberOfColors = 3;

// Rows of the result that are warped at once, and the maximum number of source pixels for them.
constexpr double RowsPerStrip[2] = { 16.0, 256.0 };
constexpr double PixelsPerStrip = 1 << 25;

// Error tolerance in pixels of linear interpolation between exactly transformed pixels.
constexpr double TransformTolerance = 0.125;

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
using Transformer = std::unique_ptr<void, TransformerFreer>;

struct WarpOperationFreer
{
  void operator()(void* operation) const
  {
    GDALDestroyWarpOperation(static_cast<GDALWarpOperationH>(operation));
  }
};

// The bands for red, green, blue and alpha; 0 for none.
struct Bands
{
  std::array<int, NumberOfColors> Colors;
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
  std::vector<std::string> arguments;
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

// Bytes are used unchanged. Other types are scaled from their smallest and largest value.
struct Stretch
{
  double Low = 0.0;
  double High = 255.0;

  explicit Stretch(GDALDatasetH dataset)
  {
    if (GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)) == GDT_Byte)
    {
      return;
    }
    this->Low = std::numeric_limits<double>::max();
    this->High = std::numeric_limits<double>::lowest();
    for (int i = 1; i <= NumberOfColors; ++i)
    {
      double range[2] = { 0.0, 0.0 };
      GDALComputeRasterMinMax(GDALGetRasterBand(dataset, i), true, range);
      this->Low = std::min(this->Low, range[0]);
      this->High = std::max(this->High, range[1]);
    }
  }

  double operator()(double value) const
  {
    return this->High > this->Low ? 255.0 * (value - this->Low) / (this->High - this->Low) : 0.0;
  }
};

// Creates rows [first, first + rows) of a width x height image over the terrain, starting at v = 0,
// with colours and alpha as float.
GDALDatasetPointer createStrip(
  const Georeference& terrain, bool located, int width, int height, int first, int rows)
{
  GDALDatasetPointer strip(GDALCreate(
    GDALGetDriverByName("MEM"), "", width, rows, NumberOfColors + 1, GDT_Float32, nullptr));
  if (!strip)
  {
    return strip;
  }
  Georeference unitSquare;
  const Georeference& location = located ? terrain : unitSquare;
  const std::array<double, 2> corner =
    location.Coordinates(0.0, static_cast<double>(first) / height);
  double transform[6] = { corner[0], location.AlongU[0] / width, location.AlongV[0] / height,
    corner[1], location.AlongU[1] / width, location.AlongV[1] / height };
  GDALSetGeoTransform(strip.get(), transform);
  GDALSetProjection(strip.get(), location.WKT.c_str());
  GDALSetRasterColorInterpretation(
    GDALGetRasterBand(strip.get(), NumberOfColors + 1), GCI_AlphaBand);
  return strip;
}

Transformer createTransformer(GDALDatasetH source, GDALDatasetH strip)
{
  return Transformer(GDALCreateGenImgProjTransformer2(source, strip, nullptr));
}

// Number of source pixels along a line over the 1 x 1 strip; 0 if it cannot be computed.
double pixelsAlong(void* transformer, bool alongU)
{
  constexpr int count = 65;
  double x[count];
  double y[count];
  double z[count] = {};
  int success[count];
  for (int i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i) / (count - 1);
    x[i] = alongU ? t : 0.5;
    y[i] = alongU ? 0.5 : t;
  }
  GDALGenImgProjTransform(transformer, true, count, x, y, z, success);
  double length = 0.0;
  int segments = 0;
  for (int i = 1; i < count; ++i)
  {
    const double step = std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
    if (success[i - 1] && success[i] && std::isfinite(step))
    {
      length += step;
      ++segments;
    }
  }
  return segments ? length * (count - 1) / segments : 0.0;
}

int imageSize(double pixels)
{
  // 1e-3 preserves the size of an image on the same grid as the terrain.
  return static_cast<int>(std::clamp(
    std::ceil(pixels - 1e-3), 1.0, static_cast<double>(std::numeric_limits<int>::max())));
}

// Index of the smallest overview with at least the required resolution; -1 for none.
int chooseOverview(GDALDatasetH dataset, double reduction)
{
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  int chosen = -1;
  double best = 1.0;
  for (int i = 0; i < GDALGetOverviewCount(band); ++i)
  {
    const GDALRasterBandH overview = GDALGetOverview(band, i);
    const int width = overview ? GDALGetRasterBandXSize(overview) : 0;
    const double factor =
      width > 0 ? static_cast<double>(GDALGetRasterXSize(dataset)) / width : 0.0;
    if (factor > best && factor <= reduction)
    {
      chosen = i;
      best = factor;
    }
  }
  return chosen;
}

bool warpStrip(GDALDatasetH source, bool hasAlpha, GDALDatasetH strip)
{
  Transformer exact = createTransformer(source, strip);
  if (!exact)
  {
    return false;
  }
  const Transformer approximate(
    GDALCreateApproxTransformer(GDALGenImgProjTransform, exact.get(), TransformTolerance));
  const WarpOptions options(GDALCreateWarpOptions());
  options->hSrcDS = source;
  options->hDstDS = strip;
  options->eResampleAlg = GRA_Bilinear;
  options->eWorkingDataType = GDT_Float32;
  options->pfnTransformer = GDALApproxTransform;
  options->pTransformerArg = approximate.get();
  GDALWarpInitDefaultBandMapping(options.get(), NumberOfColors);
  options->nSrcAlphaBand = hasAlpha ? NumberOfColors + 1 : 0;
  options->nDstAlphaBand = NumberOfColors + 1;
  char**& extra = options->papszWarpOptions;
  extra = CSLSetNameValue(extra, "INIT_DEST", "0");
  extra = CSLSetNameValue(extra, "DST_ALPHA_MAX", "255");
  extra = CSLSetNameValue(extra, "UNIFIED_SRC_NODATA", "YES");

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
  const std::unique_ptr<void, WarpOperationFreer> operation(GDALCreateWarpOperation(options.get()));
  return operation &&
    GDALChunkAndWarpImage(static_cast<GDALWarpOperationH>(operation.get()), 0, 0,
      GDALGetRasterXSize(strip), GDALGetRasterYSize(strip)) == CE_None;
}

// Composites the strip over grey into the result, starting at row `first`. `covered` returns
// whether the strip covers any pixel.
bool composite(
  GDALDatasetH strip, const Stretch& stretch, int first, Imagery& result, bool& covered)
{
  const int rows = GDALGetRasterYSize(strip);
  constexpr int components = NumberOfColors + 1;
  std::vector<float> values(static_cast<std::size_t>(rows) * result.Width * components);
  const int sampleSize = sizeof(float);
  if (GDALDatasetRasterIO(strip, GF_Read, 0, 0, result.Width, rows, values.data(), result.Width,
        rows, GDT_Float32, components, nullptr, components * sampleSize,
        components * sampleSize * result.Width, sampleSize) != CE_None)
  {
    return false;
  }
  unsigned char* color =
    result.Pixels.get() + static_cast<std::size_t>(first) * result.Width * NumberOfColors;
  for (std::size_t i = 0; i < values.size(); i += components)
  {
    const double opacity = std::clamp(values[i + NumberOfColors] / 255.0, 0.0, 1.0);
    covered = covered || opacity > 0.0;
    for (int j = 0; j < NumberOfColors; ++j)
    {
      const double value = opacity > 0.0 ? std::clamp(stretch(values[i + j]), 0.0, 255.0) : 0.0;
      *color++ =
        static_cast<unsigned char>(std::lround(opacity * value + (1.0 - opacity) * NeutralGrey));
    }
  }
  return true;
}

// The source of the warper: selected bands of the full image or of an overview.
struct Picture
{
  GDALDatasetPointer Dataset;
  GDALDatasetPointer Expanded; // palette indices expanded to colours; must outlive the view
  GDALDatasetPointer View;
  bool HasAlpha = false;
  bool IsLocated = false;

  // `overview` is -1 for the full image. Returns false with an empty `error` if GDAL cannot open
  // the file.
  bool Open(const ImagerySource& source, const Georeference& terrain, int overview,
    const GDALSession& session, std::string& error)
  {
    const std::string level = "OVERVIEW_LEVEL=" + std::to_string(overview);
    const char* options[] = { overview < 0 ? nullptr : level.c_str(), nullptr };
    this->Dataset.reset(GDALOpenEx(
      source.FileName.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, options, nullptr));
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
    this->IsLocated = hasLocation(dataset) && terrain.System != Georeference::Kind::None;
    const bool hasIndices =
      GDALGetRasterCount(dataset) == 1 && GDALGetRasterColorTable(GDALGetRasterBand(dataset, 1));
    this->Expanded = hasIndices ? translate(dataset, { "-expand", "rgba" }) : nullptr;
    const GDALDatasetH colors = this->Expanded ? this->Expanded.get() : dataset;
    Bands bands;
    if (!chooseBands(colors, source.Bands, bands, error))
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
    if (!this->IsLocated)
    {
      this->Stretch();
    }
    return true;
  }

  // Limits memory: GDAL would cache blocks up to a fraction of the memory of the machine. Formats
  // that must be decoded from the start keep their cache.
  void ReleaseBlocks()
  {
    const std::string driver = GDALGetDriverShortName(GDALGetDatasetDriver(this->Dataset.get()));
    if (driver != "PNG" && driver != "JPEG" && driver != "GIF")
    {
      GDALFlushCache(this->View.get());
      GDALFlushCache(this->Dataset.get());
    }
  }

private:
  // Georeferences the image to the unit square.
  void Stretch()
  {
    double unitSquare[6] = { 0.0, 1.0 / GDALGetRasterXSize(this->View.get()), 0.0, 1.0, 0.0,
      -1.0 / GDALGetRasterYSize(this->View.get()) };
    GDALSetGCPs(this->View.get(), 0, nullptr, "");
    GDALSetProjection(this->View.get(), "");
    GDALSetGeoTransform(this->View.get(), unitSquare);
  }
};

// Computes full size and size of the result.
bool chooseSize(const Picture& picture, const Georeference& terrain, int maximum, Imagery& result)
{
  const GDALDatasetPointer footprint = createStrip(terrain, picture.IsLocated, 1, 1, 0, 1);
  const Transformer transformer = createTransformer(picture.View.get(), footprint.get());
  if (!transformer)
  {
    return false;
  }
  result.FullSize[0] = imageSize(pixelsAlong(transformer.get(), true));
  result.FullSize[1] = imageSize(pixelsAlong(transformer.get(), false));
  result.Width = std::min(result.FullSize[0], maximum);
  result.Height = std::min(result.FullSize[1], maximum);
  return true;
}

int rowsPerStrip(const Picture& picture, const Imagery& result)
{
  const double pixels = std::min(static_cast<double>(result.FullSize[0]) * result.FullSize[1],
    static_cast<double>(GDALGetRasterXSize(picture.View.get())) *
      GDALGetRasterYSize(picture.View.get()));
  return static_cast<int>(
    std::clamp(PixelsPerStrip * result.Height / pixels, RowsPerStrip[0], RowsPerStrip[1]));
}

bool warp(Picture& picture, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, const GDALSession& session, std::string& error)
{
  result.Pixels.reset(new unsigned char[result.GetNumberOfValues()]);
  const Stretch stretch(picture.View.get());
  bool covered = false;
  // Starts in the north, like most files.
  const int rows = rowsPerStrip(picture, result);
  for (int end = result.Height; end > 0; end -= rows)
  {
    const int first = std::max(0, end - rows);
    const GDALDatasetPointer strip =
      createStrip(terrain, picture.IsLocated, result.Width, result.Height, first, end - first);
    if (!strip || !warpStrip(picture.View.get(), picture.HasAlpha, strip.get()) ||
      !composite(strip.get(), stretch, first, result, covered) || session.HasFileErrors())
    {
      error = session.Messages("it cannot be resampled to the terrain");
      return false;
    }
    picture.ReleaseBlocks();
    if (!progress(1.0 - static_cast<double>(first) / result.Height))
    {
      return false;
    }
  }
  if (!covered)
  {
    error = "it does not overlap the terrain, or has no data there";
    return false;
  }
  return true;
}
}

bool WarpImagery(const ImagerySource& source, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, bool& opened, std::string& error)
{
  GDALSession session;
  Picture picture;
  const bool isReady = picture.Open(source, terrain, -1, session, error);
  opened = isReady || !error.empty();
  if (!isReady)
  {
    return false;
  }
  if (!chooseSize(picture, terrain, source.MaximumSize, result))
  {
    error = session.Messages("its coordinate system cannot be converted to the terrain's");
    return false;
  }
  // Use the coarsest overview that is as fine as the result.
  const double reduction = std::min(static_cast<double>(result.FullSize[0]) / result.Width,
    static_cast<double>(result.FullSize[1]) / result.Height);
  const int overview = chooseOverview(picture.Dataset.get(), reduction);
  if (overview >= 0)
  {
    Picture smaller;
    if (!smaller.Open(source, terrain, overview, session, error))
    {
      error = session.Messages("its overview cannot be opened");
      return false;
    }
    return warp(smaller, terrain, result, progress, session, error);
  }
  return warp(picture, terrain, result, progress, session, error);
}
}
