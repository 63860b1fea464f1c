// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/ImageryWarp.h"

#include "Geodesy/GDALSession.h"
#include "Raster/ImageryPicture.h"
#include "Raster/ImageryTransformer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
constexpr int NumberOfColors = ImageryPicture::NumberOfColors;

// Rows of the result that are warped at once, and the maximum number of source pixels for them.
constexpr double RowsPerStrip[2] = { 16.0, 256.0 };
constexpr double PixelsPerStrip = 1 << 25;

// Creates rows [first, first + rows) of a width x height image over the terrain, starting at v = 0,
// with colours and alpha as float.
GDALDatasetPointer createStrip(
  const Georeference& terrain, bool located, int width, int height, int first, int rows)
{
  Georeference unitSquare;
  const Georeference& location = located ? terrain : unitSquare;
  const std::array<double, 2> corner =
    location.Coordinates(0.0, static_cast<double>(first) / height);
  return ImageryPicture::CreateTarget(width, rows,
    { { corner[0], location.AlongU[0] / width, location.AlongV[0] / height, corner[1],
      location.AlongU[1] / width, location.AlongV[1] / height } },
    location.WKT);
}

// Number of source pixels along a line over the 1 x 1 strip; 0 if it cannot be computed.
double pixelsAlong(const ImageryTransformer& transformer, bool alongU)
{
  constexpr int count = 65;
  double length = 0.0;
  int segments = 0;
  ImageryTransformer::Point last;
  for (int i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i) / (count - 1);
    const ImageryTransformer::Point point =
      transformer.ToImage({ { alongU ? t : 0.5, alongU ? 0.5 : t } });
    if (point.IsKnown && last.IsKnown)
    {
      const double x = transformer.GetNearest(point.Position[0], last.Position[0]);
      length += std::hypot(x - last.Position[0], point.Position[1] - last.Position[1]);
      ++segments;
    }
    last = point;
  }
  return segments ? length * (count - 1) / segments : 0.0;
}

int imageSize(double pixels)
{
  // 1e-3 preserves the size of an image on the same grid as the terrain.
  return static_cast<int>(std::clamp(
    std::ceil(pixels - 1e-3), 1.0, static_cast<double>(std::numeric_limits<int>::max())));
}

// Composites the strip over grey into the result, starting at row `first`. `covered` returns
// whether the strip covers any pixel.
bool composite(GDALDatasetH strip, const ImageryPicture::Stretch& stretch, int first,
  Imagery& result, bool& covered)
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

// Computes full size and size of the result.
bool chooseSize(
  const ImageryPicture& picture, const Georeference& terrain, int maximum, Imagery& result)
{
  const GDALDatasetPointer footprint = createStrip(terrain, picture.IsLocated(), 1, 1, 0, 1);
  const ImageryTransformer transformer(picture.GetView(), footprint.get());
  if (!transformer.IsValid())
  {
    return false;
  }
  result.FullSize[0] = imageSize(pixelsAlong(transformer, true));
  result.FullSize[1] = imageSize(pixelsAlong(transformer, false));
  result.Width = std::min(result.FullSize[0], maximum);
  result.Height = std::min(result.FullSize[1], maximum);
  return true;
}

int rowsPerStrip(const ImageryPicture& picture, const Imagery& result)
{
  const double pixels = std::min(static_cast<double>(result.FullSize[0]) * result.FullSize[1],
    static_cast<double>(GDALGetRasterXSize(picture.GetView())) *
      GDALGetRasterYSize(picture.GetView()));
  return static_cast<int>(
    std::clamp(PixelsPerStrip * result.Height / pixels, RowsPerStrip[0], RowsPerStrip[1]));
}

bool warp(ImageryPicture& picture, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, const GDALSession& session, std::string& error)
{
  result.Pixels.reset(new unsigned char[result.GetNumberOfValues()]);
  const ImageryPicture::Stretch stretch = picture.FindStretch();
  bool covered = false;
  // Starts in the north, like most files.
  const int rows = rowsPerStrip(picture, result);
  for (int end = result.Height; end > 0; end -= rows)
  {
    const int first = std::max(0, end - rows);
    const GDALDatasetPointer strip =
      createStrip(terrain, picture.IsLocated(), result.Width, result.Height, first, end - first);
    if (!strip || !picture.Warp(strip.get(), { { 0, 0, result.Width, end - first } }) ||
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
  const bool isLocated = terrain.System != Georeference::Kind::None;
  ImageryPicture picture;
  const bool isReady = picture.Open(source.FileName, source.Bands, isLocated, -1, session, error);
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
  const int overview = picture.ChooseOverview(reduction);
  if (overview >= 0)
  {
    ImageryPicture smaller;
    if (!smaller.Open(source.FileName, source.Bands, isLocated, overview, session, error))
    {
      error = session.Messages("its overview cannot be opened");
      return false;
    }
    return warp(smaller, terrain, result, progress, session, error);
  }
  return warp(picture, terrain, result, progress, session, error);
}
}
