// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Image/LICPlane.h"

#include "vtkImageData.h"

#include <algorithm>
#include <sstream>

namespace relevo
{
namespace
{
// Positions at the centres of samples are exact in float up to this size.
constexpr int LargestSide = 1 << 22;
}

bool LICPlane::Find(vtkImageData* image, std::string& error)
{
  int size[3];
  image->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] < 1)
  {
    error = "is empty";
    return false;
  }
  if (*std::max_element(size, size + 3) > LargestSide)
  {
    error = "has more than " + std::to_string(LargestSide) + " points per side";
    return false;
  }
  const int flat = size[2] == 1 ? 2 : size[1] == 1 ? 1 : 0;
  if (size[flat] != 1)
  {
    std::ostringstream text;
    text << "has " << size[0] << " x " << size[1] << " x " << size[2]
         << " points, but one of these numbers must be 1";
    error = text.str();
    return false;
  }
  this->Axes[0] = flat == 0 ? 1 : 0;
  this->Axes[1] = flat == 2 ? 1 : 2;
  this->Columns = size[this->Axes[0]];
  this->Rows = size[this->Axes[1]];
  return true;
}
}
