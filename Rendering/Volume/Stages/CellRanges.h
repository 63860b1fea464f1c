// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellRanges
 * @brief   the stage that finds the lowest and highest scalar of each cell, and cells by them
 *
 * The graphics card finds the ranges, which are read back once for a mesh. Private to the module.
 */
#ifndef CellRanges_h
#define CellRanges_h

#include "Buffers/ActiveCells.h"
#include "Changes/Dependencies.h"

#include <vector>

namespace relevo
{
struct VolumeFrame;

class CellRanges
{
public:
  /// Find the ranges of the component of isosurfaces if they are out of date. Return false if there
  /// are too many cells, or if their corners cannot be found.
  bool Update(const VolumeFrame& frame);

  /// Select the cells whose ranges, widened by a margin, meet an interval, and mark their faces.
  /// Return false if the shader cannot be built or if there is not enough memory.
  bool Mark(const VolumeFrame& frame, const std::vector<ActiveCells::Interval>& intervals,
    float margin, ActiveCells& cells) const;

  void Clear();

private:
  bool Find(const VolumeFrame& frame);

  std::vector<ActiveCells::Interval> Ranges;
  Dependencies Known;
  bool AreFound = false;
};
}

#endif
