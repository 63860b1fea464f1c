// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PointDataInterpolation
 * @brief   interpolates point data of the coarse mesh linearly to a refined mesh
 *
 * Numeric arrays keep their type: integers are rounded. Strings, bits and ghost flags are copied
 * from the nearest corner. Global and pedigree ids identify coarse points and are skipped.
 * Interpolation with a missing value gives a missing value.
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
   * Allocate in `to` an array of numberOfPoints tuples for each array of `from`, with the same name
   * and attribute type. Arrays with fewer than numberOfInputPoints tuples are skipped. For
   * noDataMagnitude, see NoDataTuples.
   */
  PointDataInterpolation(vtkPointData* from, vtkIdType numberOfInputPoints, vtkPointData* to,
    vtkIdType numberOfPoints, double noDataMagnitude);
  ~PointDataInterpolation();

  /// Names of the arrays that are skipped because they are too short.
  const std::vector<std::string>& GetShortArrays() const { return this->ShortArrays; }

  /// Can be called from several threads for different points.
  void Interpolate(const int corners[3], const std::vector<RefinedPoint>& points) const;
  void Copy(vtkIdType inputPoint, vtkIdType point) const;

  /// Does the same for arrays that only one thread may write.
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
