// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the height of a raster at a longitude and latitude
 */
#ifndef TerrainHeight_h
#define TerrainHeight_h

#include <array>
#include <string>

/// Return the height in the raster's unit at longitude and latitude in degrees, bilinear between
/// samples. Throws ViewerError if there is none.
double FindTerrainHeight(const std::string& fileName, const std::array<double, 2>& degrees);

#endif
