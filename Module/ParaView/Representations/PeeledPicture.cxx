// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PeeledPicture.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
float RoundToByte(float value)
{
  constexpr float White = 255.0f;
  return std::round(White * std::clamp(value, 0.0f, 1.0f)) / White;
}
}

void PeeledPicture::AddToFront(std::size_t pixel, const float color[4])
{
  float* const to = &this->Front[4 * pixel];
  const float clear = 1.0f - to[3];
  for (int c = 0; c < 4; ++c)
  {
    to[c] = RoundToByte(to[c] + clear * color[c]);
  }
}

void PeeledPicture::AddToBack(std::size_t pixel, const float color[4])
{
  float* const to = &this->Back[4 * pixel];
  const float clear = 1.0f - RoundToByte(color[3]);
  for (int c = 0; c < 4 && clear < 1.0f; ++c)
  {
    to[c] = RoundToByte(RoundToByte(color[c]) + clear * to[c]);
  }
}

ColorPicture PeeledPicture::Merge() const
{
  ColorPicture merged = this->Front;
  for (std::size_t i = 0; i < merged.size(); ++i)
  {
    merged[i] += (1.0f - this->Front[4 * (i / 4) + 3]) * this->Back[i];
  }
  return merged;
}
}
