// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reasons to doubt that the samples of a raster are heights
 *
 * Private to the module. Each function returns a continuation of the raster's name with a remedy in
 * parentheses or at the end, or "".
 */
#ifndef SampleDoubts_h
#define SampleDoubts_h

#include "Lattice/HeightLattice.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <string>

namespace relevo
{
/**
 * Whether a sample is one of the numbers that commonly stand for missing data: all of its digits
 * are 9 (at least three), it is an end of an integer type, or as large as the largest floats.
 */
RELEVOFILTERSTERRAIN_EXPORT bool IsMarker(double sample);

/**
 * Whether the raster is probably a photo: it has three or more bands of bytes or is a JPEG file, or
 * it has bytes without a georeference that vary from sample to sample more than heights do.
 */
RELEVOFILTERSTERRAIN_EXPORT std::string FindPhotoWarning(const HeightLattice& lattice);

/**
 * Whether the lowest or the highest height probably stands for missing data, but is not declared:
 * it is a marker, and farther from all other heights than these are from each other.
 *
 * @param range of the heights
 * @param heights of some samples, NaN without data
 */
RELEVOFILTERSTERRAIN_EXPORT std::string FindMarkerWarning(const RasterDescription& contents,
  const std::array<double, 2>& range, const float* heights, std::size_t count);
}

#endif
