// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/GDALRaster.h"

#include "Geodesy/CoordinateSystem.h"
#include "Geodesy/GDALSession.h"
#include "Raster/RawFile.h"
#include "vtkType.h"

#include <cpl_string.h>
#include <gdal.h>

#include <algorithm>
#include <cctype>

namespace relevo
{
struct GDALRaster::Internals
{
  GDALDatasetPointer Dataset;
  GDALRasterBandH Band = nullptr;
  GDALDataType Type = GDT_Unknown;
  int RowsPerBlock = 1;   // of the file; the description has 1 for huge blocks
  std::string Truncation; // the error to report for missing rows of a truncated file

  void SetBand(GDALRasterBandH band, RasterDescription& contents);
};

namespace
{
// Maximum number of samples in a row of blocks that are read at once.
constexpr long long LargestBlockRow = 1 << 25;

int vtkType(GDALDataType type)
{
  switch (type)
  {
    case GDT_Byte:
      return VTK_UNSIGNED_CHAR;
    case GDT_UInt16:
      return VTK_UNSIGNED_SHORT;
    case GDT_Int16:
      return VTK_SHORT;
    case GDT_UInt32:
      return VTK_UNSIGNED_INT;
    case GDT_Int32:
      return VTK_INT;
    case GDT_Float32:
      return VTK_FLOAT;
    case GDT_Float64:
      return VTK_DOUBLE;
#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 5, 0)
    case GDT_UInt64:
      return VTK_UNSIGNED_LONG_LONG;
    case GDT_Int64:
      return VTK_LONG_LONG;
#endif
#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 7, 0)
    case GDT_Int8:
      return VTK_SIGNED_CHAR;
#endif
    default:
      return VTK_VOID; // complex
  }
}

// Metres per unit of a band, according to the unit names of GDAL's drivers.
double metresPerUnit(std::string unit)
{
  std::transform(unit.begin(), unit.end(), unit.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const auto is = [&unit](std::initializer_list<const char*> names)
  { return std::find(names.begin(), names.end(), unit) != names.end(); };
  if (is({ "us-ft", "us survey foot", "us_survey_foot", "foot_us", "us survey feet" }))
  {
    return 1200.0 / 3937.0;
  }
  if (is({ "ft", "foot", "feet", "international foot" }))
  {
    return 0.3048;
  }
  if (is({ "cm", "centimeter", "centimetre" }))
  {
    return 0.01;
  }
  if (is({ "dm", "decimeter", "decimetre" }))
  {
    return 0.1;
  }
  if (is({ "km", "kilometer", "kilometre" }))
  {
    return 1000.0;
  }
  return 1.0;
}

// Lists the rasters of a container file, which has no band.
std::string DescribeContents(GDALDatasetH dataset)
{
  constexpr int most = 20; // maximum number of names
  const CSLConstList contents = GDALGetMetadata(dataset, "SUBDATASETS");
  std::string names;
  int count = 0;
  const auto getName = [&](int i)
  {
    const std::string key = "SUBDATASET_" + std::to_string(i) + "_NAME";
    return CSLFetchNameValue(contents, key.c_str());
  };
  for (const char* name = getName(1); name; name = getName(count + 1))
  {
    ++count;
    names += count > most ? "" : std::string(count > 1 ? ", " : "") + name;
  }
  return count == 0 ? "it has no raster band"
                    : "it contains " + std::to_string(count) +
      " rasters; use the name of one of them as the file name: " + names +
      (count > most ? ", ... (gdalinfo lists all)" : "");
}
}

void GDALRaster::Internals::SetBand(GDALRasterBandH band, RasterDescription& contents)
{
  this->Band = band;
  contents.Width = GDALGetRasterBandXSize(band);
  contents.Height = GDALGetRasterBandYSize(band);
  int blockWidth = 1;
  GDALGetBlockSize(band, &blockWidth, &this->RowsPerBlock);
  this->RowsPerBlock = std::max(1, this->RowsPerBlock);
  // GDAL caches a huge block while its rows are read one by one.
  const bool isHuge = static_cast<long long>(this->RowsPerBlock) * contents.Width > LargestBlockRow;
  contents.RowsPerBlock = isHuge ? 1 : this->RowsPerBlock;
}

GDALRaster::GDALRaster()
  : Implementation(new Internals)
{
}

GDALRaster::~GDALRaster()
{
  GDALSession session; // collects the messages of GDAL when it closes the file
  this->Implementation->Dataset.reset();
}

bool GDALRaster::Describe(void* dataset, RasterDescription& contents, std::string& error)
{
  if (GDALGetRasterCount(dataset) < 1)
  {
    error = DescribeContents(dataset);
    return false;
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  contents.Width = GDALGetRasterXSize(dataset);
  contents.Height = GDALGetRasterYSize(dataset);
  contents.Type = vtkType(GDALGetRasterDataType(band));
  if (contents.Type == VTK_VOID)
  {
    error = std::string("samples of type ") + GDALGetDataTypeName(GDALGetRasterDataType(band)) +
      " are not supported";
    return false;
  }
  const char* interleaving = GDALGetMetadataItem(dataset, "INTERLEAVE", "IMAGE_STRUCTURE");
  if (interleaving && std::string(interleaving) == "PIXEL")
  {
    contents.SamplesPerTexel = GDALGetRasterCount(dataset);
  }
  contents.IsPicture = GDALGetRasterCount(dataset) >= 3;
  for (int i = 1; i <= 3 && contents.IsPicture; ++i)
  {
    contents.IsPicture = GDALGetRasterDataType(GDALGetRasterBand(dataset, i)) == GDT_Byte;
  }
  const GDALDriverH driver = GDALGetDatasetDriver(dataset);
  contents.IsJPEG = driver && std::string(GDALGetDriverShortName(driver)) == "JPEG";
  contents.HasMask = (GDALGetMaskFlags(band) & (GMF_PER_DATASET | GMF_ALPHA)) != 0;

  int declared = 0;
  const double noData = GDALGetRasterNoDataValue(band, &declared);
  if (declared)
  {
    contents.NoData = noData;
  }
  contents.Scale = GDALGetRasterScale(band, nullptr);
  contents.Offset = GDALGetRasterOffset(band, nullptr);
  contents.UnitName = GDALGetRasterUnitType(band);
  contents.VerticalUnit = metresPerUnit(contents.UnitName);

  double transform[6];
  contents.Location.SetSize(contents.Width, contents.Height);
  if (GDALGetGeoTransform(dataset, transform) == CE_None)
  {
    if (!contents.Location.SetAffineTransform(transform, contents.Width, contents.Height))
    {
      error = "its georeference is singular: its pixels have no area";
      return false;
    }
    contents.Location.System = Georeference::Kind::Planar;
    if (const OGRSpatialReferenceH system = GDALGetSpatialRef(dataset))
    {
      contents.Location.WKT = GDALGetProjectionRef(dataset);
      DescribeCoordinateSystem(system, contents.Location);
    }
  }
  return true;
}

std::unique_ptr<GDALRaster> GDALRaster::Open(const std::string& fileName, std::string& error)
{
  GDALSession session;
  GDALDatasetPointer dataset(GDALOpenEx(fileName.c_str(),
    GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr));
  if (!dataset)
  {
    error = session.Messages("GDAL does not recognise it as a raster");
    return nullptr;
  }
  auto raster = std::make_unique<GDALRaster>();
  if (!GDALRaster::Describe(dataset.get(), raster->Contents, error))
  {
    return nullptr;
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  raster->Implementation->Truncation = FindTruncation(dataset.get());
  raster->Implementation->Type = GDALGetRasterDataType(band);
  raster->Implementation->SetBand(band, raster->Contents);
  raster->Implementation->Dataset = std::move(dataset);
  return raster;
}

bool GDALRaster::Claims(const std::string& fileName)
{
  GDALSession session;
  const GDALDriverH driver = GDALIdentifyDriver(fileName.c_str(), nullptr);
  const std::string name = driver ? GDALGetDriverShortName(driver) : "";
  return name == "PNG" || name == "JPEG";
}

void GDALRaster::SelectLevel(int width, int height)
{
  GDALSession session;
  const GDALRasterBandH finest = this->Implementation->Band;
  for (int i = 0; i < GDALGetOverviewCount(finest); ++i)
  {
    const GDALRasterBandH band = GDALGetOverview(finest, i);
    if (band &&
      this->IsBetterLevel(
        GDALGetRasterBandXSize(band), GDALGetRasterBandYSize(band), width, height) &&
      GDALGetRasterDataType(band) == this->Implementation->Type &&
      GDALGetMaskFlags(band) == GDALGetMaskFlags(finest))
    {
      this->Implementation->SetBand(band, this->Contents);
    }
  }
}

bool GDALRaster::ReadRows(int first, int count, void* samples, std::string& error)
{
  if (!this->Implementation->Truncation.empty())
  {
    error = this->Implementation->Truncation;
    return false;
  }
  GDALSession session;
  // Limits memory: GDAL would cache blocks up to a fraction of the memory of the machine.
  if (first % this->Implementation->RowsPerBlock == 0)
  {
    if (const GDALDatasetH dataset = GDALGetBandDataset(this->Implementation->Band))
    {
      GDALFlushCache(dataset);
    }
  }
  const CPLErr result =
    GDALRasterIO(this->Implementation->Band, GF_Read, 0, first, this->Contents.Width, count,
      samples, this->Contents.Width, count, this->Implementation->Type, 0, 0);
  // GDAL 3.13 reports truncated files, but returns CE_None.
  if (result == CE_None && !session.HasErrors())
  {
    return true;
  }
  error = session.Messages("GDAL cannot read the rows from " + std::to_string(first));
  return false;
}

bool GDALRaster::ReadMask(int first, int count, unsigned char* mask, std::string& error)
{
  GDALSession session;
  if (GDALRasterIO(GDALGetMaskBand(this->Implementation->Band), GF_Read, 0, first,
        this->Contents.Width, count, mask, this->Contents.Width, count, GDT_Byte, 0,
        0) == CE_None &&
    !session.HasErrors())
  {
    return true;
  }
  error = session.Messages("GDAL cannot read the mask of the rows from " + std::to_string(first));
  return false;
}
}
