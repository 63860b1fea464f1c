// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/Imagery.h"

namespace relevo
{
std::array<int, 3> DefaultBands(int numberOfBands)
{
  if (numberOfBands < 3)
  {
    return { 1, 1, 1 };
  }
  return numberOfBands < 5 ? std::array<int, 3>{ 1, 2, 3 } : std::array<int, 3>{ 3, 2, 1 };
}
}
