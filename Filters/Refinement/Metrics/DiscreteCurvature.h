// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  DiscreteCurvature
 * @brief   discrete Gaussian and mean curvature of a triangulated surface
 *
 * These are the operators of Meyer, Desbrun, Schroeder and Barr 2002 ("Discrete
 * differential-geometry operators for triangulated 2-manifolds") with their mixed area, a Voronoi
 * area that is safe for obtuse triangles:
 *
 *     Gaussian  K = (2 pi - sum of the angles at the point) / A_mixed                      (eq. 9)
 *     mean      H = |sum over edges (cot a + cot b) (x_i - x_j)| / (4 A_mixed)             (eq. 8)
 *
 * H is positive where the surface bends away from its normal, as on a sphere with outward normals.
 * Polygons are split into fans (0, i, i + 1), as VTK's mappers do, and strips into triangles.
 * Coincident points are merged, so that seams are not borders.
 *
 * The operators need a closed ring of triangles. A point on a border, or on an edge of more than
 * two triangles, takes the mean of its neighbours, ring by ring from the nearest points with a
 * closed ring, or 0 if there are none. Triangles without area contribute only their angles.
 * Triangles with coincident or non-finite corners are skipped. Points without triangles have
 * curvature 0.
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
  /// Curvatures of all points of the surface's mesh, always finite.
  std::vector<double> Gaussian;
  std::vector<double> Mean;
  /// Ids of the merged points of the surface.
  std::vector<vtkIdType> MergedPoints;
};

DiscreteCurvature ComputeDiscreteCurvature(const SurfaceTriangles& surface);

/**
 * Computes the curvatures of one point from a closed ring of triangles.
 */
class RingCurvature
{
public:
  explicit RingCurvature(const glm::dvec3& point)
    : Point(point)
  {
  }

  /// Add the triangle (point, p, q). All must have the same winding.
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
