// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICProcesses
 * @brief   the exchange of streaks between processes that draw one image together
 *
 * All processes call each method in the same order and get the same result. Private to the module's
 * own sources.
 */
#ifndef LICProcesses_h
#define LICProcesses_h

#include <vector> // for values

class vtkMultiProcessController;

namespace relevo
{
class LICProcesses
{
public:
  explicit LICProcesses(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  /// Replace each value by its maximum over all processes.
  void Maximize(std::vector<double>& values) const;

  /// Replace a range (smallest, largest) by the union of the ranges of all processes.
  void MergeRange(float range[2]) const;

  /**
   * Composite the vectors of all processes by depth, in the format of relevoLICVectorsFS.glsl with
   * four floats per pixel. Each process passes its own rectangle (lower left corner and size),
   * which is replaced by one that contains all. At equal depths, the vectors of the first process
   * are used.
   */
  void Composite(int rectangle[4], std::vector<float>& vectors) const;

private:
  vtkMultiProcessController* Controller;
};
}

#endif
