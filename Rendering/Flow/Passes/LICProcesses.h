// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICProcesses
 * @brief   what processes that draw one picture together tell each other about its streaks
 *
 * Every method is called by all processes, in the same order, and gives all the same. Private to
 * the module's own sources.
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

  /// The largest of each value.
  void Maximize(std::vector<double>& values) const;

  /// The range that has all ranges in it: (least, largest) of each process.
  void MergeRange(float range[2]) const;

  /**
   * The nearest of the vectors that processes have drawn, as relevoLICVectorsFS.glsl makes them:
   * four numbers a pixel, of a rectangle of each process's own (lower left corner and size), which
   * becomes one that has all of them in it. Of equally near ones those of the first process.
   */
  void Composite(int rectangle[4], std::vector<float>& vectors) const;

private:
  vtkMultiProcessController* Controller;
};
}

#endif
