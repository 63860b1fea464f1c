// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/ImageryDrape.h"

#if RELEVO_HAS_GDAL
#include "Raster/ImageryWarp.h"
#endif

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
// Returns the channels to show, starting at 0, or false if the image does not have them.
bool chooseChannels(
  const std::array<int, 3>& bands, int numberOfChannels, std::array<int, 3>& channels)
{
  channels = bands != std::array<int, 3>{ 0, 0, 0 } ? bands : DefaultBands(numberOfChannels);
  for (int& channel : channels)
  {
    --channel;
  }
  return std::all_of(channels.begin(), channels.end(),
    [=](int channel) { return channel >= 0 && channel < numberOfChannels; });
}

// Uses the default filter of OpenImageIO.
OIIO::ImageBuf resize(const OIIO::ImageBuf& picture, const OIIO::ROI& roi)
{
#if OIIO_VERSION_MAJOR >= 3
  return OIIO::ImageBufAlgo::resize(picture, OIIO::ParamValueSpan(), roi);
#else
  return OIIO::ImageBufAlgo::resize(picture, "", 0.0f, roi);
#endif
}

// Stretches an image over the footprint.
bool stretchPicture(const ImagerySource& source, Imagery& result, std::string& error)
{
  OIIO::ImageSpec configuration;
  configuration.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageBuf picture(source.FileName, 0, 0, nullptr, &configuration);
  if (!picture.read(0, 0, true, OIIO::TypeDesc::UNKNOWN) || picture.has_error())
  {
    error = picture.geterror();
    return false;
  }
  std::array<int, 3> channels;
  if (!chooseChannels(source.Bands, picture.nchannels(), channels))
  {
    error = "it has only " + std::to_string(picture.nchannels()) + " bands";
    return false;
  }
  const int alpha = picture.spec().alpha_channel;
  const OIIO::ROI full = picture.roi();
  result.FullSize[0] = full.width();
  result.FullSize[1] = full.height();
  if (full.width() > source.MaximumSize || full.height() > source.MaximumSize)
  {
    const OIIO::ROI roi(0, std::min(full.width(), source.MaximumSize), 0,
      std::min(full.height(), source.MaximumSize), 0, 1, 0, picture.nchannels());
    picture = resize(picture, roi);
    if (picture.has_error())
    {
      error = picture.geterror();
      return false;
    }
  }
  result.Width = picture.spec().width;
  result.Height = picture.spec().height;
  result.Pixels.reset(new unsigned char[result.GetNumberOfValues()]);
  const int numberOfChannels = picture.nchannels();
  std::vector<unsigned char> row(static_cast<std::size_t>(result.Width) * numberOfChannels);
  for (int y = 0; y < result.Height; ++y)
  {
    OIIO::ROI roi = picture.roi();
    roi.ybegin += y;
    roi.yend = roi.ybegin + 1;
    if (!picture.get_pixels(roi, OIIO::TypeDesc::UINT8, row.data()))
    {
      error = picture.geterror();
      return false;
    }
    unsigned char* pixel =
      result.Pixels.get() + static_cast<std::size_t>(result.Height - 1 - y) * result.Width * 3;
    for (int x = 0; x < result.Width; ++x)
    {
      const unsigned char* values = row.data() + static_cast<std::size_t>(x) * numberOfChannels;
      const int opacity = alpha < 0 ? 255 : values[alpha];
      for (int channel : channels)
      {
        *pixel++ = static_cast<unsigned char>(
          (values[channel] * opacity + NeutralGrey * (255 - opacity) + 127) / 255);
      }
    }
  }
  return true;
}
}

bool DrapeImagery(const ImagerySource& source, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, std::string& error)
{
#if RELEVO_HAS_GDAL
  bool opened = false;
  const bool warped = WarpImagery(source, terrain, result, progress, opened, error);
  if (opened)
  {
    return warped;
  }
#else
  static_cast<void>(terrain);
#endif
  error.clear();
  return stretchPicture(source, result, error) && progress(1.0);
}
}
