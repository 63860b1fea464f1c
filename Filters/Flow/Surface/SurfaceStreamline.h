// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceStreamline
 * @brief   traces a streamline over the triangles of a surface
 *
 * In each triangle, the midpoint rule gives a straight line to the next edge or to the end of the
 * step. The error is due to the bending of the field within a triangle. Where the vectors on both
 * sides of an edge point to the edge, the line follows the edge. At a corner, it continues in the
 * triangle that its vector points into.
 *
 * Private to the module.
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

  /// Traces downstream, or upstream if not `forward`. Steps are lengths if `normalized`. Otherwise
  /// they are times, where the speed is the vector divided by the length of the longest one.
  SurfaceStreamline(const SurfaceVectors& vectors, bool forward, bool normalized)
    : Vectors(&vectors)
    , Direction(forward ? 1.0 : -1.0)
    , Normalized(normalized)
  {
  }

  /// Starts at a merged point.
  void StartAt(vtkIdType mergedPoint) { this->StartPoint = mergedPoint; }
  /// Starts in a triangle.
  void StartInside(int triangle, const Weights& weights);

  /// Moves by a step. Returns false at the end of the line, where the vector is zero or points out
  /// of the surface. The position is then the end of the line.
  bool Advance(double step);

  /// Returns the current position.
  Vector GetPosition() const;

private:
  /// The point where a straight line leaves the triangle.
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

  vtkIdType StartPoint = -1; // merged point at the start, before a triangle is entered
  int Triangle = -1;
  Weights CurrentWeights{};
};
}

#endif
