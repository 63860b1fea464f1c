// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   opens files of rasters by the library that reads them
 *
 * Private to the module's own sources.
 */
#ifndef RasterFile_h
#define RasterFile_h

#include "Raster/Raster.h"

#include <memory>
#include <string>

namespace relevo
{
/**
 * The file in a name that GDAL gives to a raster of a container, such as NETCDF:"file.nc":band or
 * GTIFF_DIR:2:file.tif. Any other name is returned as it is.
 */
std::string FindContainer(const std::string& name);

/**
 * Opens a file; nullptr, and why in `error`, when that cannot be done.
 *
 * OpenImageIO reads the pixels of every format it knows. GDAL, where it was built in, reads
 * the others and gives the georeference, the no-data value, scale and offset. It also reads the
 * formats that GDALRaster::Claims() and what OpenImageIO does not support: validity masks and
 * samples with fewer bits than their type.
 */
std::unique_ptr<Raster> OpenRaster(const std::string& fileName, std::string& error);
}

#endif
