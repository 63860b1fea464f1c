// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that truncated files are errors for heights and imagery, even if GDAL fills the rest with
// zeros or libjpeg with grey.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTerrainSource.h"

#include <cpl_conv.h>
#include <iostream>

namespace
{
struct Format
{
  const char* Driver;
  const char* Extension;
  GDALDataType Type;
};

constexpr Format HeightFormats[] = { { "PNM", ".pgm", GDT_Byte }, { "PNM", ".pgm", GDT_UInt16 },
  { "ENVI", ".img", GDT_Int16 }, { "EHdr", ".bil", GDT_Float32 }, { "JPEG", ".jpg", GDT_Byte },
  { "BMP", ".bmp", GDT_Byte } };
constexpr Format ImageryFormats[] = { { "PNM", ".ppm", GDT_Byte }, { "ENVI", ".img", GDT_Byte },
  { "JPEG", ".jpg", GDT_Byte }, { "BMP", ".bmp", GDT_Byte } };

bool Write(const std::string& fileName, const Format& format, int bands)
{
  RelevoRaster raster;
  raster.Width = 50;
  raster.Height = 40;
  raster.NumberOfBands = bands;
  raster.Type = format.Type;
  raster.SetValues([](int band, int column, int row)
    { return (7 * band + 31 * column + 17 * column * row) % 200 + 20; });
  return raster.Write(fileName, format.Driver);
}

// With this option, which GDAL 3.10 sets for large reads of raw files, GDAL reads beyond the end of
// the file. Writing may then crash (3.6).
class LargeReads
{
public:
  LargeReads() { CPLSetThreadLocalConfigOption("GDAL_ONE_BIG_READ", "YES"); }
  ~LargeReads() { CPLSetThreadLocalConfigOption("GDAL_ONE_BIG_READ", nullptr); }
  LargeReads(const LargeReads&) = delete;
  void operator=(const LargeReads&) = delete;

  // Whether the option of this thread is still as the user set it.
  bool AreKept() const
  {
    return CPLGetThreadLocalConfigOption("GDAL_ONE_BIG_READ", "") == std::string("YES");
  }
};

// Whether the whole file is read, and truncated copies are errors that name the file.
template <typename Reader>
void TestParts(RelevoCheck& check, const std::string& name, const Format& format, int bands)
{
  for (double share : { 1.0, 0.98, 0.5 })
  {
    CHECK_CASE(share);
    CHECK(Write(name, format, bands));
    RelevoTruncate(name, name, share);
    const LargeReads large;
    Reader reader;
    const bool read = reader.Read(name);
    if (!CHECK_EQUAL(read, (share == 1.0)) ||
      !CHECK(read ? reader.Errors.None() : reader.Errors.Said(name)))
    {
      std::cerr << share << " of " << name << "\n";
    }
    CHECK(large.AreKept());
  }
}

struct HeightReader
{
  vtkNew<vtkHeightMap> Map;
  RelevoErrors Errors{ this->Map };

  bool Read(const std::string& name)
  {
    this->Map->SetFileName(name.c_str());
    return this->Map->Update();
  }
};

struct ImageryReader
{
  vtkNew<vtkTerrainSource> Source;
  RelevoErrors Errors{ this->Source };
  RelevoErrors OfExecutive{ this->Source->GetExecutive() }; // repeats every error

  bool Read(const std::string& name)
  {
    vtkNew<vtkImageData> heights;
    heights->SetDimensions(3, 3, 1);
    heights->AllocateScalars(VTK_FLOAT, 1);
    heights->GetPointData()->GetScalars()->Fill(0.0);
    this->Source->GetHeightMap()->SetImageData(heights);
    this->Source->SetImageryFileName(name.c_str());
    return this->Source->GetExecutive()->Update() == 1;
  }
};
}

int TestTruncatedRasters(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  for (const Format& format : HeightFormats)
  {
    const std::string type = GDALGetDataTypeName(format.Type);
    TestParts<HeightReader>(
      check, folders.File("TruncatedHeights" + type + format.Extension), format, 1);
  }
  for (const Format& format : ImageryFormats)
  {
    TestParts<ImageryReader>(
      check, folders.File(std::string("TruncatedImagery") + format.Extension), format, 3);
  }
  return check.GetResult();
}
