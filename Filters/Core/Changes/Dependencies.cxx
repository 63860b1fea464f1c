// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Dependencies.h"

#include <algorithm>
#include <cstring>

namespace relevo
{
void Dependencies::Add(double value)
{
  static_assert(sizeof(vtkMTimeType) == sizeof(double), "the bits of a number fit a time");
  vtkMTimeType bits;
  std::memcpy(&bits, &value, sizeof(bits));
  this->Values.push_back(bits);
}

void Dependencies::Add(const std::string& text)
{
  this->Add(text.size());
  for (std::size_t i = 0; i < text.size(); i += sizeof(vtkMTimeType))
  {
    vtkMTimeType bits = 0;
    std::memcpy(&bits, &text[i], std::min(sizeof(bits), text.size() - i));
    this->Values.push_back(bits);
  }
}
}
