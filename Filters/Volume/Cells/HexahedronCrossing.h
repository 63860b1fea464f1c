// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HexahedronCrossing
 * @brief   fast intersection of many rays with a hexahedron that they cross once
 *
 * Faces are bilinear. Wedges and pyramids are hexahedra with coincident corners. Positions are
 * computed in the coordinates of a ray, where it is an axis, so that the parameters of a point of
 * the ray follow from few steps of Newton's method. CurvedCell handles the other cases.
 *
 * Private to the module.
 */
#ifndef HexahedronCrossing_h
#define HexahedronCrossing_h

#include "Cells/CellShape.h"
#include "Integral/AcrossRay.h"
#include "Integral/Ray.h"

#include <array>

namespace relevo
{
class HexahedronCrossing
{
public:
  static constexpr int NumberOfCorners = 8;
  using Corners = std::array<int, NumberOfCorners>;

  /// Returns which corners of a shape are the corners of the hexahedron, or null for other shapes.
  static const Corners* FindCorners(const CellShape* shape);

  void SetCorner(int i, const dvec3& point) { this->Points[i] = point; }

  enum class Result
  {
    Missed,
    Crossed,
    Unclear // the ray touches an edge, or crosses the cell several times
  };
  /// The ray is inside between Begin and End. Parts that are not longer than `shortest` are missed.
  Result Cross(const Ray& ray, const AcrossRay& across, double shortest);
  double GetBegin() const { return this->Begin; }
  double GetEnd() const { return this->End; }

  /**
   * Computes parameters at the beginning, at thirds and at the end of the last part. Returns false
   * if they are ambiguous, as in tangled cells.
   */
  bool FindParameters(std::array<dvec3, 4>& parameters);
  /// Finds the parameters at a depth from those of a nearby point.
  bool Locate(double depth, dvec3& parameters) const;

  /// Interpolates values of the corners.
  static double Interpolate(
    const std::array<double, NumberOfCorners>& values, const dvec3& parameters);

private:
  struct Hit
  {
    double Depth;
    dvec3 Parameters;
  };
  void CrossFace(int face);
  void FindTerms();

  std::array<dvec3, NumberOfCorners> Points;
  std::array<dvec3, NumberOfCorners> Seen;  // in coordinates of the ray
  std::array<dvec3, NumberOfCorners> Terms; // coefficients of 1, u, v, w, uv, vw, wu and uvw
  std::array<Hit, 12> Hits;
  int NumberOfHits = 0;
  double Begin = 0.0;
  double End = 0.0;
  std::array<Hit, 2> Ends;
};
}

#endif
