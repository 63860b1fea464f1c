// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Raster.h"

namespace relevo
{
bool Raster::IsBetterLevel(int levelWidth, int levelHeight, int width, int height) const
{
  return levelWidth >= width && levelHeight >= height && levelWidth <= this->Contents.Width &&
    levelHeight <= this->Contents.Height &&
    (levelWidth < this->Contents.Width || levelHeight < this->Contents.Height);
}

bool Raster::ReadMask(int, int, unsigned char*, std::string& error)
{
  error = "there is no mask";
  return false;
}
}
