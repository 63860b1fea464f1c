// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRasterFiles.h"

#include <fstream>
#include <iterator>

RelevoTestFolders::RelevoTestFolders(int argc, char* argv[])
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "-T")
    {
      this->Output = argv[i + 1];
    }
  }
  const char* data = std::getenv("RELEVO_TEST_DATA");
  if (data && *data && std::ifstream(std::string(data) + "/relief/rmnp-dem.tif"))
  {
    this->RealData = std::string(data) + "/relief/";
  }
  GDALAllRegister();
  CPLSetErrorHandler(CPLQuietErrorHandler);
}

double RelevoRaster::At(int band, int column, int row) const
{
  return this->Values[(static_cast<std::size_t>(band) * this->Height + row) * this->Width + column];
}

bool RelevoRaster::Write(const std::string& fileName, const char* driver) const
{
  char** options = nullptr;
  for (const std::string& option : this->Options)
  {
    options = CSLAddString(options, option.c_str());
  }
  const bool direct = std::string(driver) == "GTiff";
  CPLSetConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
  GDALDatasetH dataset =
    GDALCreate(GDALGetDriverByName(direct ? "GTiff" : "MEM"), direct ? fileName.c_str() : "",
      this->Width, this->Height, this->NumberOfBands, this->Type, direct ? options : nullptr);
  if (!dataset)
  {
    CSLDestroy(options);
    return false;
  }
  if (this->Transform.size() == 6)
  {
    GDALSetGeoTransform(dataset, const_cast<double*>(this->Transform.data()));
  }
  if (!this->CoordinateSystem.empty())
  {
    OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
    OSRSetFromUserInput(system, this->CoordinateSystem.c_str());
    OSRSetAxisMappingStrategy(system, OAMS_TRADITIONAL_GIS_ORDER);
    GDALSetSpatialRef(dataset, system);
    OSRDestroySpatialReference(system);
  }
  bool written = true;
  for (int i = 0; i < this->NumberOfBands; ++i)
  {
    GDALRasterBandH band = GDALGetRasterBand(dataset, i + 1);
    if (this->NoData)
    {
      GDALSetRasterNoDataValue(band, *this->NoData);
    }
    if (this->Scale)
    {
      GDALSetRasterScale(band, *this->Scale);
      GDALSetRasterOffset(band, this->Offset.value_or(0.0));
    }
    if (!this->Unit.empty())
    {
      GDALSetRasterUnitType(band, this->Unit.c_str());
    }
    auto* values = const_cast<double*>(
      this->Values.data() + static_cast<std::size_t>(i) * this->Width * this->Height);
    written = written &&
      GDALRasterIO(band, GF_Write, 0, 0, this->Width, this->Height, values, this->Width,
        this->Height, GDT_Float64, 0, 0) == CE_None;
  }
  if (!this->Mask.empty())
  {
    GDALCreateDatasetMaskBand(dataset, GMF_PER_DATASET);
    written = written &&
      GDALRasterIO(GDALGetMaskBand(GDALGetRasterBand(dataset, 1)), GF_Write, 0, 0, this->Width,
        this->Height, const_cast<unsigned char*>(this->Mask.data()), this->Width, this->Height,
        GDT_Byte, 0, 0) == CE_None;
  }
  if (!direct)
  {
    GDALDatasetH copy = GDALCreateCopy(
      GDALGetDriverByName(driver), fileName.c_str(), dataset, false, options, nullptr, nullptr);
    written = written && copy;
    if (copy)
    {
      GDALClose(copy);
    }
  }
  GDALClose(dataset);
  CSLDestroy(options);
  return written;
}

RelevoRaster RelevoRaster::MakeMetric(int width, int height, double spacing)
{
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Transform = { 500000.0, spacing, 0.0, 4300000.0, 0.0, -spacing };
  raster.CoordinateSystem = "EPSG:32632";
  return raster;
}

RelevoRaster RelevoRaster::MakeSlope(int width, int height, const std::vector<double>& transform,
  const std::string& coordinateSystem, double first)
{
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Type = GDT_Int16;
  raster.Transform = transform;
  raster.CoordinateSystem = coordinateSystem;
  raster.SetValues([=](int, int column, int row) { return first + column + row; });
  return raster;
}

RelevoRaster RelevoRaster::Read(const std::string& fileName)
{
  RelevoRaster raster;
  GDALDatasetH dataset = GDALOpen(fileName.c_str(), GA_ReadOnly);
  if (!dataset)
  {
    return raster;
  }
  raster.Width = GDALGetRasterXSize(dataset);
  raster.Height = GDALGetRasterYSize(dataset);
  raster.Values.resize(static_cast<std::size_t>(raster.Width) * raster.Height);
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  raster.Type = GDALGetRasterDataType(band);
  int declared = 0;
  const double noData = GDALGetRasterNoDataValue(band, &declared);
  if (declared)
  {
    raster.NoData = noData;
  }
  if (GDALRasterIO(band, GF_Read, 0, 0, raster.Width, raster.Height, raster.Values.data(),
        raster.Width, raster.Height, GDT_Float64, 0, 0) != CE_None)
  {
    raster.Values.clear();
  }
  GDALClose(dataset);
  return raster;
}

void RelevoTruncate(const std::string& from, const std::string& to, double share)
{
  std::ifstream in(from, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  std::ofstream(to, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(share * static_cast<double>(bytes.size())));
}
