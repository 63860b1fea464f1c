// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  DiscreteCurvature
 * @brief   discrete Gaussian and mean curvature of a triangulated surface
 *
 * The operators of Meyer, Desbrun, Schroeder and Barr 2002 ("Discrete differential-geometry
 * operators for triangulated 2-manifolds"), with their mixed area (the Voronoi area, made safe for
 * obtuse triangles):
 *
 *     Gaussian  K = (2 pi - sum of the angles at the point) / A_mixed                      (eq. 9)
 *     mean      H = |sum over edges (cot a + cot b) (x_i - x_j)| / (4 A_mixed)             (eq. 8)
 *
 * H is positive where the surface bends away from its normal, as a sphere with outward normals
 * does. Polygons are taken as the fans (0, i, i + 1) that VTK's mappers draw, strips as their
 * triangles. Points that coincide are one point, so seams are no borders.
 *
 * The operators need a closed ring of triangles. A point on a border, or on an edge of more than
 * two triangles, takes the mean of its neighbours, ring by ring from the nearest points that have
 * a closed ring; 0 where there are none. Triangles of no area keep their angles and add nothing
 * else; triangles with two corners at one place or with a corner that is not finite are no part of
 * the surface. A point of no triangle has curvature 0.
 */
#ifndef DiscreteCurvature_h
#define DiscreteCurvature_h

#include "Mathematics/RefinementMathematics.h" // for vectors
#include "vtkType.h"                           // for vtkIdType

#include <vector> // for members

namespace relevo
{
class SurfaceTriangles;

struct DiscreteCurvature
{
  /// Curvatures of every point of the surface's mesh, always finite.
  std::vector<double> Gaussian;
  std::vector<double> Mean;
  /// Ids of the points of the surface, each place once.
  std::vector<vtkIdType> MergedPoints;
};

DiscreteCurvature ComputeDiscreteCurvature(const SurfaceTriangles& surface);

/**
 * The curvatures of one point in a closed ring of triangles.
 */
class RingCurvature
{
public:
  explicit RingCurvature(const glm::dvec3& point)
    : Point(point)
  {
  }

  /// Add the triangle (point, p, q). All wind alike.
  void Add(const glm::dvec3& p, const glm::dvec3& q);

  //@{
  /// Always finite.
  double GetGaussian() const;
  double GetMean() const;
  //@}

private:
  glm::dvec3 Point;
  double Angle = 0.0;
  double MixedArea = 0.0;
  glm::dvec3 Laplacian{ 0.0, 0.0, 0.0 };
  glm::dvec3 Normal{ 0.0, 0.0, 0.0 };
};
}

#endif
