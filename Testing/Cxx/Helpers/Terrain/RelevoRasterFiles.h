// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Writes raster files with GDAL and reads them back.
#ifndef RelevoRasterFiles_h
#define RelevoRasterFiles_h

#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <optional>
#include <string>
#include <vector>

// A test's folders: for output, and with the larger real data ("" if not available).
struct RelevoTestFolders
{
  std::string Output = ".";
  std::string RealData;

  RelevoTestFolders(int argc, char* argv[]);
  std::string File(const std::string& name) const { return this->Output + "/" + name; }
};

struct RelevoRaster
{
  int Width = 0;
  int Height = 0;
  int NumberOfBands = 1;
  GDALDataType Type = GDT_Float32;
  std::vector<double> Values; // band by band, row 0 of the file first
  std::vector<double> Transform;
  std::string CoordinateSystem; // as OSRSetFromUserInput() accepts it
  std::vector<std::string> Options;
  std::optional<double> NoData;
  std::optional<double> Scale;
  std::optional<double> Offset;
  std::string Unit;
  std::vector<unsigned char> Mask;

  double At(int band, int column, int row) const;

  template <typename Function>
  void SetValues(Function value) // by band, column and row
  {
    this->Values.clear();
    for (int band = 0; band < this->NumberOfBands; ++band)
    {
      for (int row = 0; row < this->Height; ++row)
      {
        for (int column = 0; column < this->Width; ++column)
        {
          this->Values.push_back(value(band, column, row));
        }
      }
    }
  }

  bool Write(const std::string& fileName, const char* driver = "GTiff") const;

  // A raster in metres, in a UTM zone, without values.
  static RelevoRaster MakeMetric(int width, int height, double spacing);

  // Integer heights in metres that rise by one with every column and row.
  static RelevoRaster MakeSlope(int width, int height, const std::vector<double>& transform,
    const std::string& coordinateSystem, double first = 0.0);

  // The first band as GDAL reads it.
  static RelevoRaster Read(const std::string& fileName);
};

// Copies the first `share` of a file's bytes.
void RelevoTruncate(const std::string& from, const std::string& to, double share);

#endif
