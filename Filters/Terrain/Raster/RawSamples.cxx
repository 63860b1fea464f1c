// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/RawSamples.h"

#include <cpl_conv.h>
#include <cpl_minixml.h>
#include <gdal_priv.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace relevo
{
namespace
{
// Finds the layout of a VRT that describes a file of raw samples.
bool FindVRTLayout(GDALDatasetH dataset, GDALDataset::RawBinaryLayout& layout)
{
  CSLConstList text = GDALGetMetadata(dataset, "xml:VRT");
  const std::unique_ptr<CPLXMLNode, void (*)(CPLXMLNode*)> root(
    text && text[0] ? CPLParseXMLString(text[0]) : nullptr, CPLDestroyXMLNode);
  CPLXMLNode* band = root ? CPLGetXMLNode(root.get(), "=VRTDataset.VRTRasterBand") : nullptr;
  if (!band || !EQUAL(CPLGetXMLValue(band, "subClass", ""), "VRTRawRasterBand") ||
    !EQUAL(CPLGetXMLValue(band, "band", "1"), "1"))
  {
    return false;
  }
  const std::string name = CPLGetXMLValue(band, "SourceFilename", "");
  const bool isRelative = std::atoi(CPLGetXMLValue(band, "SourceFilename.relativeToVRT", "1")) != 0;
  layout.osRawFilename = isRelative
    ? CPLFormFilename(CPLGetPath(GDALGetDescription(dataset)), name.c_str(), nullptr)
    : name.c_str();
  layout.eDataType = GDALGetRasterDataType(GDALGetRasterBand(dataset, 1));
  const int size = GDALGetDataTypeSizeBytes(layout.eDataType);
  const std::string samples = std::to_string(size);
  const std::string line =
    std::to_string(static_cast<long long>(size) * GDALGetRasterXSize(dataset));
  const char* order = CPLGetXMLValue(band, "ByteOrder", CPL_IS_LSB ? "LSB" : "MSB");
  layout.bLittleEndianOrder = EQUAL(order, "LSB") != 0;
  layout.nImageOffset = std::strtoull(CPLGetXMLValue(band, "ImageOffset", "0"), nullptr, 10);
  layout.nPixelOffset = std::atoi(CPLGetXMLValue(band, "PixelOffset", samples.c_str()));
  layout.nLineOffset = std::strtoll(CPLGetXMLValue(band, "LineOffset", line.c_str()), nullptr, 10);
  return EQUAL(order, "LSB") || EQUAL(order, "MSB");
}

bool FindLayout(GDALDatasetH dataset, GDALDataset::RawBinaryLayout& layout)
{
  const std::string driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  if (driver == "VRT")
  {
    return FindVRTLayout(dataset, layout);
  }
  // TIFF files can be sparse, and have a cache of blocks that neighbouring windows share.
  return driver != "GTiff" && GDALDataset::FromHandle(dataset)->GetRawBinaryLayout(layout);
}
}

std::unique_ptr<RawSamples> RawSamples::Open(GDALDatasetH dataset)
{
  GDALDataset::RawBinaryLayout layout;
  if (!FindLayout(dataset, layout) || GDALDataTypeIsComplex(layout.eDataType) ||
    layout.nPixelOffset < GDALGetDataTypeSizeBytes(layout.eDataType))
  {
    return nullptr;
  }
  std::unique_ptr<RawSamples> samples(new RawSamples);
  samples->File = VSIFOpenL(layout.osRawFilename.c_str(), "rb");
  if (!samples->File)
  {
    return nullptr;
  }
  samples->Type = layout.eDataType;
  samples->IsSwapped = layout.bLittleEndianOrder != (CPL_IS_LSB != 0);
  samples->Start = static_cast<long long>(layout.nImageOffset);
  samples->PixelOffset = layout.nPixelOffset;
  samples->LineOffset = layout.nLineOffset;
  return samples;
}

RawSamples::~RawSamples()
{
  if (this->File)
  {
    VSIFCloseL(this->File);
  }
}

bool RawSamples::Read(
  int column, int row, int width, int height, GDALDataType type, unsigned char* samples)
{
  const int size = GDALGetDataTypeSizeBytes(this->Type);
  const int resultSize = GDALGetDataTypeSizeBytes(type);
  this->Line.resize(static_cast<std::size_t>(this->PixelOffset * (width - 1) + size));
  for (int i = 0; i < height; ++i)
  {
    const long long position =
      this->Start + this->LineOffset * (row + i) + this->PixelOffset * column;
    if (VSIFSeekL(this->File, static_cast<vsi_l_offset>(position), SEEK_SET) != 0 ||
      VSIFReadL(this->Line.data(), 1, this->Line.size(), this->File) != this->Line.size())
    {
      return false;
    }
    if (this->IsSwapped)
    {
      GDALSwapWords(this->Line.data(), size, width, static_cast<int>(this->PixelOffset));
    }
    GDALCopyWords(this->Line.data(), this->Type, static_cast<int>(this->PixelOffset),
      samples + static_cast<std::size_t>(i) * width * resultSize, type, resultSize, width);
  }
  return true;
}
}
