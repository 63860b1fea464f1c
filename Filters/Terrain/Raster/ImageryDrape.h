// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   drapes a picture over a terrain
 *
 * Private to the module's own sources.
 */
#ifndef ImageryDrape_h
#define ImageryDrape_h

#include "Raster/Imagery.h"

#include <string>

namespace relevo
{
/**
 * Resamples a picture by its own georeference to the terrain's footprint, at about its own
 * resolution; one without georeference, or for a terrain without, is stretched over the footprint.
 * False, and why in `error`, when there is nothing to drape; false with an empty error when
 * stopped. Throws std::bad_alloc.
 */
bool DrapeImagery(const ImagerySource& source, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, std::string& error);
}

#endif
