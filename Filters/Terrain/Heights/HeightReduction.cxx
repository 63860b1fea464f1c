// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/HeightReduction.h"

#include <algorithm>

namespace relevo
{
void GetReducedSize(const int size[2], int maximum, int reduced[2])
{
  const long long longer = std::max(size[0], size[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    const long long side = maximum > 0 && longer > maximum
      ? std::max(1LL, (static_cast<long long>(size[axis]) * maximum + longer / 2) / longer)
      : size[axis];
    reduced[axis] = static_cast<int>(side);
  }
}

// Positions are integers in units of 1 / (From * To) of the side, so that overlaps are exact. A
// texel of `From` is To units long, one of `To` is From units.

HeightReduction::HeightReduction(const int from[2], const int to[2])
  : Sums(to[0], 0.0)
  , Areas(to[0], 0.0)
{
  std::copy_n(from, 2, this->From);
  std::copy_n(to, 2, this->To);
}

void HeightReduction::ReduceRow(
  const float* heights, const unsigned char* validity, double* sums, double* widths) const
{
  const long long from = this->From[0];
  const long long to = this->To[0];
  for (long long i = 0; i < to; ++i)
  {
    const long long begin = i * from;
    const long long end = begin + from;
    double sum = 0.0;
    long long width = 0;
    for (long long column = begin / to; column * to < end; ++column)
    {
      const long long overlap = std::min(end, (column + 1) * to) - std::max(begin, column * to);
      sum += static_cast<double>(overlap) * heights[column];
      width += !validity || validity[column] ? overlap : 0;
    }
    sums[i] = sum;
    widths[i] = static_cast<double>(width);
  }
}

void HeightReduction::Accumulate(const double* sums, const double* widths, long long overlap)
{
  const double weight = static_cast<double>(overlap);
  for (int i = 0; i < this->To[0]; ++i)
  {
    this->Sums[i] += weight * sums[i];
    this->Areas[i] += weight * widths[i];
  }
}

void HeightReduction::AddRow(const double* sums, const double* widths, const Sink& sink)
{
  const long long begin = static_cast<long long>(this->NextRow++) * this->To[1];
  const long long end = begin + this->To[1];
  const long long row = begin / this->From[1];
  const long long border = (row + 1) * this->From[1];
  this->Accumulate(sums, widths, std::min(end, border) - begin);
  if (end >= border)
  {
    sink(static_cast<int>(row), this->Sums.data(), this->Areas.data());
    std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
    std::fill(this->Areas.begin(), this->Areas.end(), 0.0);
  }
  if (end > border)
  {
    this->Accumulate(sums, widths, end - border);
  }
}
}
