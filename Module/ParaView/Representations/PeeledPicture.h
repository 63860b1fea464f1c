// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PeeledPicture
 * @brief   blends colours from the front and from the back, as VTK's dual depth peeling does
 *
 * VTK's pass has textures of 8 bits, so that colours are rounded after each step. This class rounds
 * like it, for the picture of one rank.
 *
 * Private to the module.
 */
#ifndef PeeledPicture_h
#define PeeledPicture_h

#include "WindowOverlay.h"

#include <cstddef>

namespace relevo
{
class PeeledPicture
{
public:
  explicit PeeledPicture(std::size_t pixels)
    : Front(4 * pixels, 0.0f)
    , Back(4 * pixels, 0.0f)
  {
  }

  /// Add a premultiplied colour and its opacity behind the front part of a pixel.
  void AddToFront(std::size_t pixel, const float color[4]);

  /// Add a premultiplied colour and its opacity in front of the back part of a pixel.
  void AddToBack(std::size_t pixel, const float color[4]);

  /// Return the front part over the back part.
  ColorPicture Merge() const;

private:
  ColorPicture Front;
  ColorPicture Back;
};
}

#endif
