// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/FileVersion.h"

#include "Geodesy/GDALSession.h"
#include "Raster/RasterFile.h"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>

namespace relevo
{
namespace
{
// HasChanged() is called for each tile, so that it does not ask for the version of more files.
constexpr std::size_t MaximumFilesPerCheck = 64;

constexpr char Statistics[] = ".aux.xml";

// "" for a file that does not exist.
std::string DescribeFile(const std::string& name)
{
  std::optional<GDALSession> session; // collects what GDAL reports of servers
  if (GDALSession::IsVirtual(name))
  {
    session.emplace();
  }
  VSIStatBufL status;
  if (VSIStatL(name.c_str(), &status) != 0)
  {
    return "";
  }
  std::ostringstream text;
  text << status.st_size << ' ' << status.st_mtime;
#ifdef __linux__
  text << '.' << status.st_mtim.tv_nsec << ' ' << status.st_ino;
#endif
  return text.str();
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
}

FileVersion::FileVersion(const std::string& fileName, GDALDatasetH dataset)
  : Names{ FindContainer(fileName), fileName + ".ovr" }
{
  // GDAL would ask a server for each file that could exist.
  char** const files =
    dataset && !GDALSession::IsVirtual(fileName) ? GDALGetFileList(dataset) : nullptr;
  for (int i = 0; i < CSLCount(files); ++i)
  {
    const std::string name = files[i];
    if (!EndsWith(name, Statistics) &&
      std::find(this->Names.begin(), this->Names.end(), name) == this->Names.end())
    {
      this->Names.push_back(name);
    }
  }
  CSLDestroy(files);
  for (const std::string& name : this->Names)
  {
    this->Texts.push_back(DescribeFile(name));
  }
}

bool FileVersion::HasChanged() const
{
  for (std::size_t i = 0; i < std::min(this->Names.size(), MaximumFilesPerCheck); ++i)
  {
    const std::string text = DescribeFile(this->Names[i]);
    if (!text.empty() && text != this->Texts[i])
    {
      return true;
    }
  }
  return false;
}

std::string FileVersion::DescribeCurrent() const
{
  std::string all;
  for (const std::string& name : this->Names)
  {
    all += DescribeFile(name) + ' ';
  }
  return all;
}
}
