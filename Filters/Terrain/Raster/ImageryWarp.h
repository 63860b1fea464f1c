// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   resampling of imagery with GDAL's warper
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef ImageryWarp_h
#define ImageryWarp_h

#include "Raster/Imagery.h"

namespace relevo
{
/**
 * Implements DrapeImagery() for files that GDAL can open. `opened` returns whether it could.
 */
bool WarpImagery(const ImagerySource& source, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, bool& opened, std::string& error);
}

#endif
