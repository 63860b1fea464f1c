// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   estimates for a raster whose samples are not all read
 *
 * Private to the module; only in builds with RELEVO_USE_GDAL.
 */
#ifndef RasterEstimates_h
#define RasterEstimates_h

#include "Pyramid/PyramidFile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>

namespace relevo
{
/// The range of heights by few samples; (0, 0) if none of them has data.
RELEVOFILTERSTERRAIN_EXPORT std::array<double, 2> EstimateRange(const PyramidFile& file);

/**
 * The mean distance of neighbouring samples in the unit of the heights: in metres divided by the
 * vertical unit; 1 if the raster has no coordinates of known size.
 */
RELEVOFILTERSTERRAIN_EXPORT double GetSampleDistance(const RasterDescription& contents);
}

#endif
