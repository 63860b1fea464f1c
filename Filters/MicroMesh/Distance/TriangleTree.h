// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleTree
 * @brief   search for the triangles nearest to points and on lines
 *
 * A bounding volume hierarchy of triangles. Its boxes are of floats and a little larger than the
 * triangles, whose coordinates are from -0.5 to 0.5. Distances to triangles are computed in double
 * precision.
 */
#ifndef TriangleTree_h
#define TriangleTree_h

#include "Distance/WideBoxTree.h"
#include "Mathematics/RefinementMathematics.h"

#include <array>  // for members
#include <vector> // for members

namespace relevo
{
class TriangleTree
{
public:
  using Triangle = std::array<int, 3>;

  /// Holds references to the points and triangles.
  TriangleTree(const std::vector<dvec3>& points, const std::vector<Triangle>& triangles);

  /// The square of the distance of a point to a triangle, and the nearest point.
  double GetDistance2(const dvec3& point, int triangle) const;
  dvec3 GetNearestPoint(const dvec3& point, int triangle) const;
  dvec3 GetNormal(int triangle) const;

  /// Find a triangle nearer than the root of `distance2`, which becomes the square of its distance.
  /// Otherwise `triangle` is not changed.
  void FindNearest(const dvec3& point, double& distance2, int& triangle) const;

  /// Find the intersection of the line point + t direction with a triangle that has the smallest
  /// |t| below `range`, and whose normal is along the direction. Returns whether there is one.
  bool Intersect(
    const dvec3& point, const dvec3& direction, double range, double& t, int& triangle) const;

  /// Call visit(triangle) for triangles whose boxes intersect a box, until it returns false.
  template <typename Visitor>
  void VisitIntersecting(const FloatBox& box, const Visitor& visit) const
  {
    this->Tree.VisitIntersecting(box, visit);
  }

  const dvec3& GetPoint(int triangle, int corner) const
  {
    return this->Points[static_cast<std::size_t>(
      this->Triangles[static_cast<std::size_t>(triangle)][corner])];
  }

private:
  const std::vector<dvec3>& Points;
  const std::vector<Triangle>& Triangles;
  WideBoxTree Tree;
};
}

#endif
