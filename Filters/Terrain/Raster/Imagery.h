// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  Imagery
 * @brief   a picture brought onto a terrain's texture coordinates
 *
 * Private to the module's own sources.
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
 * RGB pixels over (u, v) in [0, 1]^2 of a terrain, row 0 at v = 0.
 */
struct Imagery
{
  int Width = 0;
  int Height = 0;
  std::unique_ptr<unsigned char[]> Pixels; // 3 per pixel
  int FullSize[2] = { 0, 0 };              ///< at the picture's own resolution, before any limit

  std::size_t GetNumberOfValues() const
  {
    return static_cast<std::size_t>(this->Width) * this->Height * 3;
  }
};

struct ImagerySource
{
  std::string FileName;
  std::array<int, 3> Bands; ///< from 1; all 0: by the file's own declaration
  int MaximumSize;          ///< of the result, per side
};

/// The colour where a picture has no data.
constexpr unsigned char NeutralGrey = 128;

/// Called with the share that is done; returns false to stop.
using ImageryProgress = std::function<bool(double)>;

/**
 * The bands, from 1, for red, green and blue where a file does not declare them: the first three;
 * the first as grey where there are fewer; the third, second and first of five and more, which are
 * a multispectral scene in order of wavelength (Landsat, Sentinel-2).
 */
std::array<int, 3> DefaultBands(int numberOfBands);
}

#endif
