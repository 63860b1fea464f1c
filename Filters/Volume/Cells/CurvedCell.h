// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedCell
 * @brief   a cell by its shape functions: where a ray is inside, and which weights corners have
 * there
 *
 * Private to the module's own sources.
 */
#ifndef CurvedCell_h
#define CurvedCell_h

#include "Cells/CellShape.h"

#include <array>
#include <utility>
#include <vector>

namespace relevo
{
using CornerWeights = std::array<double, MaximumCorners>;

class CurvedCell
{
public:
  explicit CurvedCell(const CellShape& shape)
    : Shape(shape)
  {
  }
  void SetCorner(int i, const dvec3& point) { this->Corners[i] = point; }

  /// Of a box that the cell does not leave.
  void FindBounds(dvec3& low, dvec3& high) const;

  /// The largest volume of a cube of parameters, without a sign.
  double ComputeVolume() const;

  /// The parts of the ray in the cell, in order. Those no longer than `shortest` are left out.
  std::vector<std::pair<double, double>> FindInside(const Ray& ray, double shortest) const;

  /// Weights at a point in the cell; `parameters`, of a point nearby, become those of the point.
  CornerWeights GetWeights(const dvec3& point, dvec3& parameters) const;
  const dvec3& GetCenter() const { return this->Shape.Center; }

  /**
   * The slopes at parameters, and the determinant of the derivatives there, without a sign: as good
   * as 0, it is 0, and so are slopes.
   */
  double ComputeSlopes(const dvec3& parameters, CornerSlopes& slopes) const;

private:
  bool Locate(const dvec3& point, dvec3& parameters) const;
  bool IsInside(const dvec3& point) const;
  dvec3 At(const dvec3& parameters) const;
  dmat3 Derive(const dvec3& parameters) const;

  const CellShape& Shape;
  std::array<dvec3, MaximumCorners> Corners;
};
}

#endif
