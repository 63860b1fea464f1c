// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedCell
 * @brief   intersection of a ray with a cell, and interpolation weights, from shape functions
 *
 * Private to the module.
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

  /// Computes a box that contains the cell.
  void FindBounds(dvec3& low, dvec3& high) const;

  /// Returns the largest volume, without sign, of a unit cube of parameters.
  double ComputeVolume() const;

  /// Returns whether a quadratic tetrahedron folds over itself at one of its nodes or its centre.
  bool IsFolded() const;

  /// Returns the parts of the ray inside of the cell, in order. Parts that are not longer than
  /// `shortest` are omitted.
  std::vector<std::pair<double, double>> FindInside(const Ray& ray, double shortest) const;

  /// Returns the weights at a point in the cell. `parameters` has the parameters of a nearby point
  /// and returns those of the point.
  CornerWeights GetWeights(const dvec3& point, dvec3& parameters) const;
  const dvec3& GetCenter() const { return this->Shape.Center; }

  /**
   * Computes the slopes at the given parameters. Returns the determinant of the derivatives,
   * without sign. If it is almost 0, the result is 0 and slopes are 0.
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
