// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPictures.h"

#include <algorithm>

namespace RelevoPictures
{
bool Equal(const RelevoPicture& a, const RelevoPicture& b)
{
  return a.Colors == b.Colors && a.Depths == b.Depths;
}

RelevoPicture Crop(const RelevoPicture& picture, int x, int y, int width, int height)
{
  RelevoPicture part(width, height);
  for (int row = 0; row < height; ++row)
  {
    const size_t from = static_cast<size_t>(y + row) * picture.Size[0] + x;
    const size_t to = static_cast<size_t>(row) * width;
    std::copy_n(&picture.Colors[3 * from], 3 * width, &part.Colors[3 * to]);
    std::copy_n(&picture.Depths[from], width, &part.Depths[to]);
  }
  return part;
}
}
