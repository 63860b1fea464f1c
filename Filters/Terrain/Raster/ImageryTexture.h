// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   images for vtkTexture in the texture coordinates of a terrain
 *
 * Private to the module.
 */
#ifndef ImageryTexture_h
#define ImageryTexture_h

#include "Raster/Imagery.h"

#include <string>

class vtkImageData;

namespace relevo
{
/**
 * Fills an image as DrapeImagery() does. `warning` says that it has fewer pixels than the file, or
 * is empty.
 */
bool MakeImageryTexture(const ImagerySource& source, const Georeference& terrain,
  vtkImageData* texture, const ImageryProgress& progress, std::string& warning, std::string& error);
}

#endif
