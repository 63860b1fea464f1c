// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PointDataInterpolation
 * @brief   point data of a refined mesh, interpolated linearly from its coarse one
 *
 * Numeric arrays keep their type: integers are rounded to nearest. What cannot be interpolated
 * (strings, bits, ghost flags) takes the value of the nearest corner; global and pedigree ids,
 * which name coarse points, are left out. Values that stand for no data give no data.
 */
#ifndef PointDataInterpolation_h
#define PointDataInterpolation_h

#include "Evaluation/RefinedTopology.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkPointData;

namespace relevo
{
class PointDataInterpolation
{
public:
  /**
   * Allocates in `to` an array of numberOfPoints tuples for each array of `from`, with the same
   * name and the same part as attribute. Arrays too short for numberOfInputPoints are left out.
   * For noDataMagnitude see NoDataTuples.
   */
  PointDataInterpolation(vtkPointData* from, vtkIdType numberOfInputPoints, vtkPointData* to,
    vtkIdType numberOfPoints, double noDataMagnitude);
  ~PointDataInterpolation();

  /// Names of the arrays left out because they are too short.
  const std::vector<std::string>& GetShortArrays() const { return this->ShortArrays; }

  /// May be called from several threads for different points.
  void Interpolate(const int corners[3], const std::vector<RefinedPoint>& points) const;
  void Copy(vtkIdType inputPoint, vtkIdType point) const;

  /// The same for arrays that one thread alone may write.
  bool HasSerialArrays() const { return !this->SerialArrays.empty(); }
  void InterpolateSerial(const int corners[3], const std::vector<RefinedPoint>& points) const;
  void CopySerial(vtkIdType inputPoint, vtkIdType point) const;

  class ArrayPair;

private:
  std::vector<std::unique_ptr<ArrayPair>> Arrays;
  std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>> SerialArrays;
  std::vector<std::string> ShortArrays;
};
}

#endif
