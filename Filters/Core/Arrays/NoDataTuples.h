// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the tuples of point data that are missing values, and their effect on interpolation
 *
 * An interpolated value is missing if one of the points that it is interpolated from has a missing
 * value. vtkAdaptiveRefinement::SetNoDataMagnitude() describes the rule.
 */
#ifndef NoDataTuples_h
#define NoDataTuples_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkType.h"                 // for vtkIdType

#include <cstddef> // for size_t
#include <vector>  // for members

class vtkDataArray;
class vtkDataSetAttributes;

namespace relevo
{
/// Normals, tangents and texture coordinates are never missing values.
RELEVOFILTERSCORE_EXPORT bool CanLackData(vtkDataSetAttributes* data, vtkDataArray* array);

class RELEVOFILTERSCORE_EXPORT NoDataTuples
{
public:
  NoDataTuples() = default;
  NoDataTuples(vtkDataArray* array, double noDataMagnitude);

  /// Whether no tuple is missing.
  bool IsEmpty() const { return this->Marks.empty(); }

  /// One byte per tuple, 1 for missing values; empty if no tuple is missing.
  const std::vector<unsigned char>& GetMarks() const { return this->Marks; }

  /**
   * The corner with a missing value and the largest weight, or -1 if no corner with a weight has
   * one. At least two weights are not 0.
   */
  int FindCorner(const int corners[3], const float weights[3]) const
  {
    int found = -1;
    for (int i = 0; i < 3 && !this->Marks.empty(); ++i)
    {
      if (this->Marks[static_cast<std::size_t>(corners[i])] && weights[i] > 0.0f &&
        (found < 0 || weights[i] > weights[found]))
      {
        found = i;
      }
    }
    return found;
  }

private:
  std::vector<unsigned char> Marks;
};
}

#endif
