// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/OpenImageIORaster.h"

#if RELEVO_HAS_GDAL
#include "Geodesy/GDALSession.h"
#endif
#include "vtkType.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

namespace relevo
{
struct OpenImageIORaster::Internals
{
  std::unique_ptr<OIIO::ImageInput> Input;
  OIIO::TypeDesc Format; // the type to read
  OIIO::ImageSpec Spec;  // of the current level
  int Subimage = 0;
  int MipLevel = 0;
  bool Reads = true; // false if the alternative reads
};

namespace
{
// Values of section 8 of the TIFF specification.
constexpr int MinIsWhite = 0;
constexpr int Palette = 3;
constexpr int ReducedResolution = 1; // a bit of NewSubfileType

struct SampleType
{
  OIIO::TypeDesc Stored;
  OIIO::TypeDesc Read; // wider if VTK has no equivalent type; never normalized
  int VTKType;
};

const SampleType SampleTypes[] = {
  { OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT8, VTK_UNSIGNED_CHAR },
  { OIIO::TypeDesc::INT8, OIIO::TypeDesc::INT8, VTK_SIGNED_CHAR },
  { OIIO::TypeDesc::UINT16, OIIO::TypeDesc::UINT16, VTK_UNSIGNED_SHORT },
  { OIIO::TypeDesc::INT16, OIIO::TypeDesc::INT16, VTK_SHORT },
  { OIIO::TypeDesc::UINT32, OIIO::TypeDesc::UINT32, VTK_UNSIGNED_INT },
  { OIIO::TypeDesc::INT32, OIIO::TypeDesc::INT32, VTK_INT },
  { OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, VTK_FLOAT },
  { OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::FLOAT, VTK_FLOAT },
  { OIIO::TypeDesc::DOUBLE, OIIO::TypeDesc::DOUBLE, VTK_DOUBLE },
};
}

OpenImageIORaster::OpenImageIORaster()
  : Implementation(new Internals)
{
}

OpenImageIORaster::~OpenImageIORaster() = default;

std::unique_ptr<OpenImageIORaster> OpenImageIORaster::Open(
  const std::string& fileName, std::string& error)
{
  // Read samples unchanged, without premultiplication or colour conversion.
  OIIO::ImageSpec configuration;
  configuration.attribute("oiio:UnassociatedAlpha", 1);
  configuration.attribute("oiio:RawColor", 1);
  auto input = OIIO::ImageInput::open(fileName, &configuration);
  if (!input)
  {
    error = OIIO::geterror();
    return nullptr;
  }
  // Targa has no signature, so that the reader accepts other files.
  const std::string extension = std::filesystem::path(fileName).extension().string();
  if (std::string(input->format_name()) == "targa" && extension != ".tga" && extension != ".TGA")
  {
    error = "its format is not recognised";
    return nullptr;
  }

  const OIIO::ImageSpec& spec = input->spec();
  const OIIO::TypeDesc format = spec.channelformat(0);
  const auto type = std::find_if(std::begin(SampleTypes), std::end(SampleTypes),
    [&](const SampleType& candidate) { return candidate.Stored == format; });
  const int bits = spec.get_int_attribute("oiio:BitsPerSample");
  if (type == std::end(SampleTypes) || spec.depth > 1 || spec.deep)
  {
    error = std::string("samples of type ") + format.c_str() + " are not supported";
    return nullptr;
  }
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
  if (photometric == MinIsWhite || photometric == Palette)
  {
    error = "palette and min-is-white files can only be read with GDAL";
    return nullptr;
  }
  if (format == OIIO::TypeDesc::DOUBLE && spec.tile_width > 0)
  {
    error = "tiles of 64-bit samples cannot be read: OpenImageIO 2.4 leaves them undefined";
    return nullptr;
  }
  if (bits > 0 && bits != static_cast<int>(8 * format.size()))
  {
    error = "samples of " + std::to_string(bits) + " bits can only be read with GDAL";
    return nullptr;
  }

  auto raster = std::make_unique<OpenImageIORaster>();
  raster->Contents.Width = spec.width;
  raster->Contents.Height = spec.height;
  raster->Contents.RowsPerBlock = std::max(1, spec.tile_height);
  raster->Contents.SamplesPerTexel = spec.nchannels;
  raster->Contents.Type = type->VTKType;
  raster->Contents.Location.SetSize(spec.width, spec.height);
  raster->Implementation->Spec = spec;
  raster->Implementation->Input = std::move(input);
  raster->Implementation->Format = type->Read;
  return raster;
}

bool OpenImageIORaster::SetAlternative(std::unique_ptr<Raster>& alternative)
{
  const RasterDescription& other = alternative->Describe();
  if (other.Width != this->Contents.Width || other.Height != this->Contents.Height ||
    other.Type != this->Contents.Type)
  {
    return false;
  }
  const RasterDescription own = this->Contents;
  this->Contents = other;
  this->Contents.RowsPerBlock = own.RowsPerBlock;
  this->Contents.SamplesPerTexel = own.SamplesPerTexel;
  this->Alternative = std::move(alternative);
  return true;
}

void OpenImageIORaster::SelectLevel(int width, int height)
{
  Internals& own = *this->Implementation;
  if (this->Alternative)
  {
    this->Alternative->SelectLevel(width, height);
    const RasterDescription& other = this->Alternative->Describe();
    own.Reads = other.Width == this->Contents.Width && other.Height == this->Contents.Height;
    if (!own.Reads)
    {
      this->Contents = other;
    }
    return;
  }
  const auto select = [&](int subimage, int mipLevel)
  {
    if (!own.Input->seek_subimage(subimage, mipLevel))
    {
      return false; // otherwise spec() may describe another subimage
    }
    const OIIO::ImageSpec spec = own.Input->spec(subimage, mipLevel);
    const bool isVersion =
      subimage == 0 || spec.get_int_attribute("tiff:subfiletype") == ReducedResolution;
    if (isVersion && spec.channelformat(0) == own.Spec.channelformat(0) &&
      this->IsBetterLevel(spec.width, spec.height, width, height))
    {
      own.Spec = spec;
      own.Subimage = subimage;
      own.MipLevel = mipLevel;
      this->Contents.Width = spec.width;
      this->Contents.Height = spec.height;
      this->Contents.RowsPerBlock = std::max(1, spec.tile_height);
    }
    return spec.width > 0;
  };
  for (int subimage = 0; select(subimage, 0); ++subimage)
  {
    for (int mipLevel = 1; select(subimage, mipLevel); ++mipLevel)
    {
    }
  }
  own.Input->geterror(); // clears the error about the missing subimage
}

bool OpenImageIORaster::ReadRows(int first, int count, void* samples, std::string& error)
{
  const Internals& own = *this->Implementation;
  if (!own.Reads)
  {
    return this->Alternative->ReadRows(first, count, samples, error);
  }
#if RELEVO_HAS_GDAL
  GDALSession session; // suppresses errors of libtiff, which GDAL prints even for calls of other
                       // libraries
#endif
  OIIO::ImageInput& input = *own.Input;
  const OIIO::ImageSpec& spec = own.Spec;
  const int begin = spec.y + first;
  const bool read = spec.tile_width > 0
    ? input.read_tiles(own.Subimage, own.MipLevel, spec.x, spec.x + spec.width, begin,
        begin + count, spec.z, spec.z + 1, 0, 1, own.Format, samples)
    : input.read_scanlines(
        own.Subimage, own.MipLevel, begin, begin + count, spec.z, 0, 1, own.Format, samples);
  // OpenImageIO 2.4 reports truncated strips, but may return success.
  if (read && !input.has_error())
  {
    return true;
  }
  const std::string messages = input.geterror();
  if (this->Alternative)
  {
    return this->Alternative->ReadRows(first, count, samples, error);
  }
  error = messages.substr(0, messages.find('\n'));
  return false;
}
}
