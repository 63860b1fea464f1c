// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  Imagery
 * @brief   an image resampled to the texture coordinates of a terrain
 *
 * Private to the module.
 */
#ifndef Imagery_h
#define Imagery_h

#include "Geodesy/Georeference.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

namespace relevo
{
/**
 * RGB pixels over (u, v) in [0, 1]^2 of a terrain, with row 0 at v = 0.
 */
struct Imagery
{
  int Width = 0;
  int Height = 0;
  std::unique_ptr<unsigned char[]> Pixels; // 3 bytes per pixel
  int FullSize[2] = { 0, 0 };              ///< size at the resolution of the file, before any limit

  std::size_t GetNumberOfValues() const
  {
    return static_cast<std::size_t>(this->Width) * this->Height * 3;
  }
};

struct ImagerySource
{
  std::string FileName;
  std::array<int, 3> Bands; ///< from 1; all 0 to use those that the file declares
  int MaximumSize;          ///< of the result, pixels per side
};

/// The colour where imagery is missing.
constexpr unsigned char NeutralGrey = 128;

/// Receives the progress from 0 to 1. Returns false to stop.
using ImageryProgress = std::function<bool(double)>;

/**
 * Returns the bands, starting at 1, for red, green and blue of a file that declares none. Fewer
 * than three bands are grey, three and four are RGB. Five and more bands are a multispectral scene
 * in order of wavelength (Landsat, Sentinel-2), so that the order is third, second and first.
 */
std::array<int, 3> DefaultBands(int numberOfBands);
}

#endif
