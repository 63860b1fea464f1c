// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   which tuples of point data stand for "no data", and what they do to those between
 *
 * Between points there are data only where all the points that a value is interpolated from have
 * some. The rule is vtkAdaptiveRefinement::SetNoDataMagnitude()'s.
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
/// Normals, tangents and texture coordinates always count as data.
RELEVOFILTERSCORE_EXPORT bool CanLackData(vtkDataSetAttributes* data, vtkDataArray* array);

class RELEVOFILTERSCORE_EXPORT NoDataTuples
{
public:
  NoDataTuples() = default;
  NoDataTuples(vtkDataArray* array, double noDataMagnitude);

  /// Whether all tuples are data.
  bool IsEmpty() const { return this->Marks.empty(); }

  /// A byte per tuple, 1 for no data; empty when all are data.
  const std::vector<unsigned char>& GetMarks() const { return this->Marks; }

  /**
   * The corner that has no data and the largest weight, -1 when all with a weight have some. The
   * weights are no corner's alone.
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
