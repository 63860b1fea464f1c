// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   points and normals of Bézier patches, in double precision
 *
 * Private to the module.
 */
#ifndef PatchEvaluation_h
#define PatchEvaluation_h

#include "Mesh/PatchArrays.h"

#include <vector>

namespace relevo
{
struct FacePatch : Patch
{
  vtkIdType Cell;
  int InnerBorders = 0; // see PatchArrays

  int GetNumberOfCorners() const { return this->IsTriangle ? 3 : 4; }
  dvec2 GetCorner(int corner) const;
  dvec2 GetMiddle() const { return this->IsTriangle ? dvec2(0.25) : dvec2(0.5); }
  /// Returns the indices, relative to FirstPoint, of the control points between a corner and the
  /// next.
  std::vector<int> GetBorder(int border) const;
};

/// Homogeneous points: coordinates are multiplied by the weight, which is w.
using ControlPoints = std::vector<dvec4>;

/// Whether the control points are not collinear, except for rounding.
bool HasArea(const FacePatch& patch, const ControlPoints& points);

/// Evaluates a point of a curve with de Casteljau's algorithm.
dvec3 EvaluateCurve(ControlPoints points, double t);

/// Evaluates a point. `points` has the control points of all patches.
dvec3 EvaluatePoint(const FacePatch& patch, const ControlPoints& points, const dvec2& uv);

/// Evaluates the unit normal du x dv. Where it vanishes, as at a degenerate border, returns its
/// limit from the interior of the patch, or 0 if there is none.
dvec3 EvaluateNormal(const FacePatch& patch, const ControlPoints& points, const dvec2& uv);

/// Returns the weights of all control points at (u, v), with sum 1.
std::vector<double> EvaluateShares(
  const FacePatch& patch, const ControlPoints& points, const dvec2& uv);
}

#endif
