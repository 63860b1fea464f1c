// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  MapSegment
 * @brief   a straight line between two positions of the raster, in columns and rows
 *
 * Private to the modules for terrains.
 */
#ifndef MapSegment_h
#define MapSegment_h

#include <array>
#include <cmath>
#include <vector>

namespace relevo
{
/// A column and row of the raster; whole numbers are centres of samples.
using MapPosition = std::array<double, 2>;

struct MapSegment
{
  /// Shorter pieces, in samples, are rounding errors.
  static constexpr double Tolerance = 1e-7;

  MapPosition Start;
  MapPosition End;

  MapPosition Get(double t) const
  {
    return { { this->Start[0] + t * (this->End[0] - this->Start[0]),
      this->Start[1] + t * (this->End[1] - this->Start[1]) } };
  }
  double GetLength() const
  {
    return std::hypot(this->End[0] - this->Start[0], this->End[1] - this->Start[1]);
  }
};

/// A part of a segment from one parameter to another, in which a linear function is not negative.
struct SegmentRange
{
  double First = 0.0;
  double Last = 1.0;

  bool IsEmpty() const { return this->First > this->Last; }
  /// Clip by a function with these values at the ends of the segment.
  void Clip(double atStart, double atEnd)
  {
    if (atStart >= 0.0 && atEnd >= 0.0)
    {
      return;
    }
    if (atStart < 0.0 && atEnd < 0.0)
    {
      this->Last = this->First - 1.0;
      return;
    }
    const double t = atStart / (atStart - atEnd);
    (atStart < 0.0 ? this->First : this->Last) =
      atStart < 0.0 ? std::fmax(this->First, t) : std::fmin(this->Last, t);
  }
  /// Add the parameters inside of the range at which a linear function is a whole number.
  void AddCrossings(double atStart, double atEnd, std::vector<double>& parameters) const
  {
    const double change = atEnd - atStart;
    const double first = atStart + this->First * change;
    const double last = atStart + this->Last * change;
    const double end = std::fmax(first, last);
    for (double k = std::floor(std::fmin(first, last)) + 1.0; k < end; ++k)
    {
      parameters.push_back((k - atStart) / change);
    }
  }
};
}

#endif
