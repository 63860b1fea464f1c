// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   functions shared by the surfaces that extend PN triangles
 *
 * Source: A. Vlachos, J. Peters, C. Boyd, J. Mitchell, "Curved PN Triangles", I3D 2001. Edge
 * vectors 0 and 1 are the control points near the first and second end of an edge. Face vector 0 is
 * the centre.
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

/// The same functions for shaders.
std::string GetPNTriangleSource();

struct QuadraticNormalSum : SurfaceCorners
{
#include "glsl/relevoNormalQuadraticSum.glsl"
};

struct QuadraticNormals : QuadraticNormalSum
{
#include "glsl/relevoNormalQuadratic.glsl"
};

/// The part of the edge perpendicular to the normal at its end. The control point near the end is
/// at one third of it.
inline vec3 GetPNTangent(const vec3& edge, const vec3& normal)
{
  return edge - dot(edge, normal) * normal;
}

/// Compute the control points of the edge near its ends: 6 floats.
inline void StorePNEdge(
  const vtkRefinementSurface::Corner& from, const vtkRefinementSurface::Corner& to, float* points)
{
  const vec3 a = SurfaceCorners::Load(from.Point);
  const vec3 b = SurfaceCorners::Load(to.Point);
  // This is exact on straight edges, unlike (2 a + b) / 3 with its rounding.
  store(a + GetPNTangent(b - a, SurfaceCorners::Load(from.Normal)) / 3.0f, points);
  store(b + GetPNTangent(a - b, SurfaceCorners::Load(to.Normal)) / 3.0f, points + 3);
}

/// The normal at the midpoint of an edge: the sum of the normals at its ends, reflected in the
/// plane perpendicular to the edge.
vec3 GetPNMiddleNormal(const vec3& edge, const vec3& normalA, const vec3& normalB);

/// Compute this normal between two corners: 3 floats.
inline void StorePNMiddleNormal(
  const vtkRefinementSurface::Corner& from, const vtkRefinementSurface::Corner& to, float* normal)
{
  store(GetPNMiddleNormal(SurfaceCorners::Load(to.Point) - SurfaceCorners::Load(from.Point),
          SurfaceCorners::Load(from.Normal), SurfaceCorners::Load(to.Normal)),
    normal);
}

/// The control point at the centre of the face, from the six on its edges.
vec3 GetPNCenter(const SurfaceCorners& corners);

/// See vtkRefinementSurface::ComputeNormalCone().
float ComputePNNormalCone(const SurfaceCorners& corners, float axis[3]);
}

#endif
