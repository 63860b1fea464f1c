// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   resampling of images to the footprint of a terrain
 *
 * Private to the module.
 */
#ifndef ImageryDrape_h
#define ImageryDrape_h

#include "Raster/Imagery.h"

#include <string>

namespace relevo
{
/**
 * Resamples an image according to its georeference, at about its resolution. If the image or the
 * terrain has no georeference, the image is stretched over the footprint. Returns false with an
 * `error` if there is nothing to drape, and false with an empty `error` if `progress` returned
 * false. Throws std::bad_alloc.
 */
bool DrapeImagery(const ImagerySource& source, const Georeference& terrain, Imagery& result,
  const ImageryProgress& progress, std::string& error);
}

#endif
