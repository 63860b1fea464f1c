// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceStreamline
 * @brief   a place that moves along the vectors of a surface, from triangle to triangle
 *
 * In each triangle it goes by the midpoint rule, straight to the next edge or to the end of the
 * step, so that its error is that of the vectors' bending within a triangle. Where the triangles on
 * both sides of an edge send it to the edge, it slides along the edge. From a corner it goes on in
 * the triangle that its vector points into.
 *
 * Private to the module's own sources.
 */
#ifndef SurfaceStreamline_h
#define SurfaceStreamline_h

#include "RelevoFiltersFlowModule.h" // for export macro
#include "Surface/SurfaceVectors.h"  // for Weights

namespace relevo
{
class RELEVOFILTERSFLOW_EXPORT SurfaceStreamline
{
public:
  using Weights = SurfaceVectors::Weights;
  using Vector = SurfaceVectors::Vector;

  /// Downstream, or upstream if not `forward`. Steps are lengths, or, if not `normalized`, times in
  /// which the longest vector goes its length 1.
  SurfaceStreamline(const SurfaceVectors& vectors, bool forward, bool normalized)
    : Vectors(&vectors)
    , Direction(forward ? 1.0 : -1.0)
    , Normalized(normalized)
  {
  }

  /// Begin at a place of the surface's points.
  void StartAt(vtkIdType mergedPoint) { this->StartPoint = mergedPoint; }
  /// Begin in a triangle.
  void StartInside(int triangle, const Weights& weights);

  /// Move on. False at the end of the line: where there is no vector or no way on. The line has
  /// then gone as far as it could.
  bool Advance(double step);

  /// Where Advance() has come to.
  Vector GetPosition() const;

private:
  /// Where a straight line leaves the triangle.
  struct Exit
  {
    double Step;
    int Corner; // opposite to the edge
  };

  bool FindVelocity(int triangle, const Weights& weights, Weights& rates) const;
  Weights GetRatesAlongEdge(int triangle, int corner, double speed) const;
  double GetSpeedAlongEdge(int triangle, int corner, const Weights& rates) const;
  bool FindSlide(int triangle, const Weights& weights, int corner, Weights& rates) const;

  Exit FindExit(const Weights& rates) const;
  double Move(const Weights& rates, double step, const Exit& exit);
  bool MoveInside(double& step, int& corner);
  bool Cross(int corner, double& step);
  bool EnterAt(vtkIdType mergedPoint, double& step);
  void Slide(const Weights& rates, double& step);
  vtkIdType FindCornerPoint() const;

  const SurfaceVectors* Vectors;
  double Direction; // 1 downstream, -1 upstream
  bool Normalized;

  vtkIdType StartPoint = -1; // a place not yet left for a triangle
  int Triangle = -1;
  Weights CurrentWeights{};
};
}

#endif
