// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   imagery through GDAL's warper
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
 */
#ifndef ImageryWarp_h
#define ImageryWarp_h

#include "Raster/Imagery.h"

namespace relevo
{
/**
 * DrapeImagery for what GDAL can open; `opened` tells whether it could.
 */
bool WarpImagery(const ImagerySource& source, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, bool& opened, std::string& error);
}

#endif
