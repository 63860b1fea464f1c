// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   opening raster files with a suitable library
 *
 * Private to the module.
 */
#ifndef RasterFile_h
#define RasterFile_h

#include "Raster/Raster.h"

#include <memory>
#include <string>

namespace relevo
{
/**
 * Returns the file in a name that GDAL gives to a raster of a container, such as
 * NETCDF:"file.nc":band or GTIFF_DIR:2:file.tif. Other names are returned unchanged.
 */
std::string FindContainer(const std::string& name);

/// Why a file cannot be a raster, without opening it with a library; "" if it may be one.
std::string FindRasterFileError(const std::string& fileName);

/**
 * Opens a file. Returns nullptr with an `error` if that fails.
 *
 * OpenImageIO reads the pixels of all formats that it supports. GDAL, if available, reads other
 * formats and provides the georeference, no-data value, scale and offset. It also reads the formats
 * of GDALRaster::Claims(), files with validity masks, and samples with fewer bits than their type,
 * which OpenImageIO does not support.
 */
std::unique_ptr<Raster> OpenRaster(const std::string& fileName, std::string& error);
}

#endif
