// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   points and normals of Bézier patches, in double
 *
 * Private to the module's own sources.
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
  /// Control points of the border from a corner to the next, counted from FirstPoint.
  std::vector<int> GetBorder(int border) const;
};

/// Homogeneous points: multiplied with their weight, which is w.
using ControlPoints = std::vector<dvec4>;

/// Whether the control points do not lie on one line, but for rounding.
bool HasArea(const FacePatch& patch, const ControlPoints& points);

/// The place of a curve's point, by de Casteljau's algorithm.
dvec3 EvaluateCurve(ControlPoints points, double t);

/// `points` are those of all patches, from which a patch has those from FirstPoint on.
dvec3 EvaluatePoint(const FacePatch& patch, const ControlPoints& points, const dvec2& uv);

/// The unit normal du x dv; where it vanishes, as at a collapsed border, its limit from the
/// patch's middle; 0 if there is none.
dvec3 EvaluateNormal(const FacePatch& patch, const ControlPoints& points, const dvec2& uv);

/// What each control point counts at (u, v); the sum is 1.
std::vector<double> EvaluateShares(
  const FacePatch& patch, const ControlPoints& points, const dvec2& uv);
}

#endif
