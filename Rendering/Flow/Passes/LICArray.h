// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICArray
 * @brief   a mapper's array of vectors: validated, and without no-data values
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
  /// Why the array cannot be used, as a sentence; empty if it can or if there is none.
  std::string Error;

  /**
   * Check the array that an algorithm's SetInputArrayToProcess(0, ...) has selected.
   */
  static LICArray Check(vtkDataArray* chosen, int association, vtkPolyData* input);

  /// Return the length of the longest valid vector; -1 if there is none.
  double FindLongest(double noDataMagnitude) const;

  /// Return an array of four components: the vector in units of `unit` and 1, or zeros for no data.
  vtkSmartPointer<vtkFloatArray> Prepare(double noDataMagnitude, double unit) const;
};
}

#endif
