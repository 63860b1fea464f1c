// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICArray
 * @brief   a mapper's array of vectors: checked, and without what is no-data
 *
 * Private to the module's own sources.
 */
#ifndef LICArray_h
#define LICArray_h

#include "vtkSmartPointer.h" // for results

#include <string> // for problems

class vtkDataArray;
class vtkFloatArray;
class vtkPolyData;

namespace relevo
{
struct LICArray
{
  vtkDataArray* Array = nullptr;
  bool IsOfCells = false;
  /// Why the array cannot be used, as a sentence; empty if it can or there is none.
  std::string Error;

  /**
   * Check what an algorithm's SetInputArrayToProcess(0, ...) has chosen.
   */
  static LICArray Check(vtkDataArray* chosen, int association, vtkPolyData* input);

  /// Length of the longest vector that is data; -1 for none.
  double FindLongest(double noDataMagnitude) const;

  /// Four components: the vector in units of `unit` and 1, or zeros for no-data.
  vtkSmartPointer<vtkFloatArray> Prepare(double noDataMagnitude, double unit) const;
};
}

#endif
