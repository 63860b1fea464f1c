// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   opens imagery for terrains
 *
 * Private to the modules for terrains.
 */
#ifndef OpenImagery_h
#define OpenImagery_h

#include "Imagery/ImageryOptions.h"
#include "Lattice/ImageryLattice.h"
#include "Raster/RasterDescription.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <memory>
#include <string>

namespace relevo
{
/**
 * Open an image by any name that GDAL knows, for a terrain. Without a georeference of both, the
 * image is stretched over the raster, and `warning` is set if the raster has one. It is also set
 * for a large image without overviews. Returns nullptr and sets `error` on failure; both texts
 * continue the name of the file.
 */
RELEVOFILTERSTERRAIN_EXPORT std::shared_ptr<const ImageryLattice> OpenImagery(
  const ImageryOptions& options, const RasterDescription& terrain, std::string& warning,
  std::string& error);
}

#endif
