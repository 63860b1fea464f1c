// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/RasterFile.h"

#include "Raster/OpenImageIORaster.h"
#if RELEVO_HAS_GDAL
#include "Raster/GDALRaster.h"
#endif

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace relevo
{
namespace
{
// One row must fit into memory: this many doubles take 512 MiB. The whole earth at 10 m per texel
// has 4 million columns.
constexpr int MaximumWidth = 1 << 26;

// Opens a file with the appropriate library.
std::unique_ptr<Raster> openAny(const std::string& fileName, std::string& error)
{
  error = FindRasterFileError(fileName);
  if (!error.empty())
  {
    return nullptr;
  }
#if RELEVO_HAS_GDAL
  std::unique_ptr<Raster> raster = GDALRaster::Open(fileName, error);
  if (GDALRaster::Claims(fileName) || (raster && raster->Describe().HasMask))
  {
    return raster;
  }
  std::string pixelError;
  auto pixels = OpenImageIORaster::Open(fileName, pixelError);
  if (pixels && (!raster || pixels->SetAlternative(raster)))
  {
    error.clear();
    return pixels;
  }
  return raster;
#else
  auto pixels = OpenImageIORaster::Open(fileName, error);
  if (!pixels)
  {
    error += "; this build of Relevo does not have GDAL, which reads georeferenced rasters, SRTM "
             ".hgt, USGS DEM and more";
  }
  return pixels;
#endif
}
}

std::string FindContainer(const std::string& name)
{
  namespace fs = std::filesystem;
  std::error_code failure;
  const auto isLetter = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
  const std::size_t prefix = name.find(':');
  if (prefix == std::string::npos || prefix < 2 || !isLetter(name[0]) ||
    !std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(prefix),
      [&](char c)
      { return isLetter(c) || std::isdigit(static_cast<unsigned char>(c)) || c == '_'; }) ||
    fs::exists(fs::u8path(name), failure))
  {
    return name;
  }
  // Find the longest part between colons that is an existing file.
  for (std::size_t begin = prefix; begin != std::string::npos; begin = name.find(':', begin + 1))
  {
    for (std::size_t end = name.size(); end != std::string::npos && end > begin + 1;
         end = name.rfind(':', end - 1))
    {
      std::string part = name.substr(begin + 1, end - begin - 1);
      if (part.size() > 2 && part.front() == '"' && part.back() == '"')
      {
        part = part.substr(1, part.size() - 2);
      }
      if (!part.empty() && fs::exists(fs::u8path(part), failure))
      {
        return part;
      }
    }
  }
  return name;
}

std::string FindRasterFileError(const std::string& fileName)
{
  namespace fs = std::filesystem;
  if (fileName.rfind("/vsi", 0) == 0)
  {
    return ""; // a virtual file of GDAL
  }
  std::error_code failure;
  const fs::path path = fs::u8path(FindContainer(fileName));
  if (!fs::exists(path, failure))
  {
    return "the file does not exist";
  }
  if (fs::is_directory(path, failure))
  {
    return "it is a folder";
  }
  if (!fs::is_regular_file(path, failure))
  {
    return "it is not a regular file"; // reading a pipe or a device might never end
  }
  if (fs::file_size(path, failure) == 0)
  {
    return "the file is empty";
  }
  return "";
}

std::unique_ptr<Raster> OpenRaster(const std::string& fileName, std::string& error)
{
  auto raster = openAny(fileName, error);
  if (raster &&
    (raster->Describe().Width < 1 || raster->Describe().Height < 1 ||
      raster->Describe().Width > MaximumWidth))
  {
    error = "it has " + std::to_string(raster->Describe().Width) + " x " +
      std::to_string(raster->Describe().Height) + " texels";
    error += raster->Describe().Width > MaximumWidth
      ? ", but rows may have at most " + std::to_string(MaximumWidth)
      : "";
    return nullptr;
  }
  return raster;
}
}
