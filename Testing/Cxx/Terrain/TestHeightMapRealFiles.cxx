// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightMap promises the heights of real files, compared with GDAL and VTK's DEM reader.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkDEMReader.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"

#include <cmath>
#include <iostream>

namespace
{
struct RealFile
{
  const char* Name;
  int Width;
  int Height;
  double Range[2];
  int NumberOfVoids;
};

// Sizes and ranges from gdalinfo -mm.
const RealFile RealFiles[] = {
  { "N57E011.hgt", 1201, 1201, { -6.0, 163.0 }, 0 },
  { "SainteHelens.dem", 327, 468, { 682.0, 2543.0 }, 4151 },
  { "earth-topology.png", 2048, 1024, { 0.0, 248.0 }, 0 },
  { "luxembourg_elev.tif", 95, 90, { 141.0, 547.0 }, 3942 },
  { "mt_rainier_90m.tif", 1201, 1201, { 263.0, 4371.0 }, 9033 },
  { "olinda_dem_utm25s.tif", 111, 111, { -1.0, 88.0 }, 0 },
  { "rmnp-dem.tif", 152, 187, { 2281.0, 4261.0 }, 0 },
};

void TestFile(RelevoCheck& check, const std::string& folder, const RealFile& file)
{
  const std::string name = folder + file.Name;
  std::cout << file.Name << "\n";
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  if (!CHECK(map->Update()))
  {
    return;
  }
  CHECK(map->GetDimensions()[0] == file.Width && map->GetDimensions()[1] == file.Height);
  CHECK(map->GetRange()[0] == file.Range[0] && map->GetRange()[1] == file.Range[1]);

  const RelevoRaster raster = RelevoRaster::Read(name);
  int different = 0;
  int voids = 0;
  int spikes = 0;
  double sampling = 0.0;
  for (int row = 0; row < file.Height; ++row)
  {
    for (int column = 0; column < file.Width; ++column)
    {
      const int v = file.Height - 1 - row;
      const std::size_t index = static_cast<std::size_t>(v) * file.Width + column;
      const double expected = raster.At(0, column, row);
      const double sample = map->GetSamples()[index];
      const bool valid = !map->GetValidity() || map->GetValidity()[index];
      different += valid != !(raster.NoData && expected == *raster.NoData);
      different += valid && sample != expected;
      voids += !valid;
      spikes += !(sample >= file.Range[0] && sample <= file.Range[1]);
      if (valid && (column + row) % 7 == 0)
      {
        const double height = map->GetHeight((column + 0.5) / file.Width, (v + 0.5) / file.Height);
        sampling = std::max(sampling, std::abs(height - expected));
      }
    }
  }
  CHECK_EQUAL(different, 0);
  CHECK_EQUAL(spikes, 0);
  CHECK_EQUAL(voids, file.NumberOfVoids);
  CHECK_EQUAL(map->HasNoData(), (voids > 0));
  CHECK_NEAR(sampling, 0.0, 0.02); // texture coordinates are floats
}

// Compares the DEM's profiles with VTK's reader, which shifts each profile by up to a few rows.
// Each must appear completely in its column.
void TestAgainstDEMReader(RelevoCheck& check, const std::string& folder)
{
  const std::string name = folder + "SainteHelens.dem";
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  CHECK(map->Update());
  vtkNew<vtkDEMReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int dimensions[3];
  image->GetDimensions(dimensions);
  CHECK_EQUAL(dimensions[0], map->GetDimensions()[0]);
  int found = 0;
  int profiles = 0;
  for (int i = 10; i < dimensions[0] - 10; ++i)
  {
    ++profiles;
    for (int shift = 0; shift < 6; ++shift)
    {
      bool same = true;
      for (int j = 20; same && j < dimensions[1] - 20; ++j)
      {
        same = image->GetScalarComponentAsDouble(i, j, 0, 0) == map->GetSample(i, j + shift);
      }
      if (same)
      {
        ++found;
        break;
      }
    }
  }
  CHECK_NEAR(found, profiles, 0);
}
}

int TestHeightMapRealFiles(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  if (folders.RealData.empty())
  {
    std::cout << "Skipped: no relief in RELEVO_TEST_DATA.\n";
    return 125;
  }
  RelevoCheck check;
  for (const RealFile& file : RealFiles)
  {
    TestFile(check, folders.RealData, file);
  }
  TestAgainstDEMReader(check, folders.RealData);
  return check.GetResult();
}
