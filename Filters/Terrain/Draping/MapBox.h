// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  MapBox
 * @brief   a rectangle of the raster, in columns and rows
 *
 * Private to the modules for terrains.
 */
#ifndef MapBox_h
#define MapBox_h

#include "Draping/MapSegment.h"

#include <algorithm>
#include <limits>

namespace relevo
{
struct MapBox
{
  MapPosition Low = { { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() } };
  MapPosition High = { { std::numeric_limits<double>::lowest(),
    std::numeric_limits<double>::lowest() } };

  void Add(const MapPosition& position)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], position[axis]);
      this->High[axis] = std::max(this->High[axis], position[axis]);
    }
  }
  void AddBox(const MapBox& box)
  {
    this->Add(box.Low);
    this->Add(box.High);
  }

  /// Clip by the end of the raster.
  void Clip(const MapPosition& lastSample)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->High[axis] = std::min(this->High[axis], lastSample[axis]);
    }
  }

  bool Overlaps(const MapBox& box) const
  {
    return this->Low[0] <= box.High[0] && box.Low[0] <= this->High[0] &&
      this->Low[1] <= box.High[1] && box.Low[1] <= this->High[1];
  }

  /// Whether a segment meets this rectangle; true if they are within rounding errors.
  bool Overlaps(const MapSegment& segment) const
  {
    SegmentRange range;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double low = this->Low[axis] - MapSegment::Tolerance;
      const double high = this->High[axis] + MapSegment::Tolerance;
      range.Clip(segment.Start[axis] - low, segment.End[axis] - low);
      range.Clip(high - segment.Start[axis], high - segment.End[axis]);
    }
    return !range.IsEmpty();
  }
};
}

#endif
