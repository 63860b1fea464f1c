// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the surfaces that build on PN triangles share
 *
 * A. Vlachos, J. Peters, C. Boyd, J. Mitchell, "Curved PN Triangles", I3D 2001. Edge vectors 0 and
 * 1 are the control points near an edge's first and second end, face vector 0 is the centre.
 */
#ifndef PNPatch_h
#define PNPatch_h

#include "Surfaces/SurfaceCorners.h"

#include <string>

namespace relevo
{
struct PNTriangle : SurfaceCorners
{
#include "glsl/relevoCubicPatch.glsl"
#include "glsl/relevoPNTriangle.glsl"
};

/// The same for shaders.
std::string GetPNTriangleSource();

struct QuadraticNormalSum : SurfaceCorners
{
#include "glsl/relevoNormalQuadraticSum.glsl"
};

struct QuadraticNormals : QuadraticNormalSum
{
#include "glsl/relevoNormalQuadratic.glsl"
};

/// The edge's part across the normal at its end: the control point beside the end is a third of it
/// away.
inline vec3 GetPNTangent(const vec3& edge, const vec3& normal)
{
  return edge - dot(edge, normal) * normal;
}

/// The control points of the edge beside its ends: 6 floats.
inline void StorePNEdge(
  const vtkRefinementSurface::Corner& from, const vtkRefinementSurface::Corner& to, float* points)
{
  const vec3 a = SurfaceCorners::load(from.Point);
  const vec3 b = SurfaceCorners::load(to.Point);
  // On a straight edge the thirds themselves: (2 a + b) / 3 without its rounding.
  store(a + GetPNTangent(b - a, SurfaceCorners::load(from.Normal)) / 3.0f, points);
  store(b + GetPNTangent(a - b, SurfaceCorners::load(to.Normal)) / 3.0f, points + 3);
}

/// The normal amid an edge: the sum of those at its ends, mirrored in the plane across the edge.
vec3 GetPNMiddleNormal(const vec3& edge, const vec3& normalA, const vec3& normalB);

/// The same between two corners: 3 floats.
inline void StorePNMiddleNormal(
  const vtkRefinementSurface::Corner& from, const vtkRefinementSurface::Corner& to, float* normal)
{
  store(GetPNMiddleNormal(SurfaceCorners::load(to.Point) - SurfaceCorners::load(from.Point),
          SurfaceCorners::load(from.Normal), SurfaceCorners::load(to.Normal)),
    normal);
}

/// The control point amid the face, from the six on its edges.
vec3 GetPNCenter(const SurfaceCorners& corners);

/// See vtkRefinementSurface::ComputeNormalCone().
float ComputePNNormalCone(const SurfaceCorners& corners, float axis[3]);
}

#endif
