// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DistanceBound
 * @brief   an upper bound of the distance of all points of a triangle to a surface
 *
 * The distance to one triangle of the surface is a convex function, so on a triangle it is largest
 * at a corner. This is the bound if it is within the tolerance for one of the triangles that are
 * nearest to the corners. Otherwise, the triangles near the triangle are projected along its
 * normal. Where one of them covers the triangle, the distance along the normal is linear, and it
 * bounds the distance to the surface. The covered parts are cut off. The remaining parts are
 * bisected until each is within the tolerance of one triangle. Bounds therefore hold for all
 * points, not only for samples.
 *
 * Each thread needs an object of its own.
 */
#ifndef DistanceBound_h
#define DistanceBound_h

#include "Distance/TriangleTree.h"

#include <array>  // for polygons
#include <vector> // for members

namespace relevo
{
class DistanceBound
{
public:
  /// A point and a triangle of the surface near it; -1 if none is within the tolerance.
  struct Corner
  {
    dvec3 Point;
    int Nearest;
  };
  using Corners = std::array<dvec3, 3>;

  DistanceBound(const TriangleTree& surface, double tolerance)
    : Surface(surface)
    , Tolerance(tolerance)
  {
  }

  /// Find a triangle of the surface within the tolerance. `guess` is a triangle or -1.
  Corner FindCorner(const dvec3& point, int guess = -1) const;

  /// The bound. It is infinite if it may be above the tolerance. Corners are worth it for triangles
  /// that IsSmall().
  double Find(const Corner& a, const Corner& b, const Corner& c);
  double Find(const Corners& triangle);
  bool IsSmall(const Corners& triangle) const;

private:
  struct Polygon // convex, in the plane of the triangle
  {
    static constexpr std::size_t MostPoints = 12;
    std::array<dvec2, MostPoints> Points;
    std::size_t Size = 0;

    void Add(const dvec2& point) { this->Points[this->Size++] = point; }
    bool IsFull() const { return this->Size == MostPoints; }
  };
  struct HalfPlane // the points p with dot(Normal, p) + Offset >= 0
  {
    dvec2 Normal;
    double Offset;

    double Evaluate(const dvec2& p) const { return dot(this->Normal, p) + this->Offset; }
  };
  struct Frame
  {
    dvec3 Origin;
    dvec3 U;
    dvec3 V;
    dvec3 Normal;
  };
  // A triangle of the surface and the distances of three corners to it.
  struct Candidate
  {
    int Triangle;
    std::array<double, 3> Distances;
  };

  bool FindCandidates(const Corners& triangle, std::size_t most);
  double FindBoundOfHalves(const Corners& triangle, int edge);
  void Cover(const Frame& frame, int candidate);
  bool CutOff(const Polygon& polygon, std::size_t numberOfPlanes);
  double FindBoundOfRest(const Frame& frame, const Polygon& polygon);
  double Bisect(const Corners& corners, std::size_t first);
  bool IsNegligible(const Polygon& polygon) const;
  bool IsNear(const Polygon& polygon, const Polygon& shared) const;

  const TriangleTree& Surface;
  double Tolerance;
  dvec2 Low{}; // of the triangle in its plane
  dvec2 High{};
  std::vector<int> Near; // triangles of the surface
  std::vector<Polygon> Parts;
  std::vector<Polygon> NextParts;
  std::vector<Candidate> Candidates; // a stack, for all levels of bisection
  std::array<HalfPlane, 5> Planes{};
  HalfPlane Height{}; // of the candidate
  double Bound = 0.0; // of the covered parts
};
}

#endif
