// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkG1Surface.h"

#include "Mathematics/CornerOrder.h"
#include "Surfaces/PNPatch.h"
#include "vtkObjectFactory.h"

#include "relevoCubicPatch.h"
#include "relevoG1Triangle.h"
#include "relevoNormalG1.h"
#include "relevoNormalQuadratic.h"
#include "relevoNormalQuadraticSum.h"

#include <algorithm>

namespace relevo
{
namespace
{
struct G1Triangle : SurfaceCorners
{
#include "glsl/relevoCubicPatch.glsl"
#include "glsl/relevoG1Triangle.glsl"
#include "glsl/relevoNormalG1.glsl"
};

dvec3 unit(const dvec3& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : dvec3(0.0);
}

// Returns a unit vector perpendicular to v.
dvec3 perpendicular(const dvec3& v)
{
  const dvec3 a = abs(v);
  const double least = std::min({ a.x, a.y, a.z });
  return unit(
    cross(v, least == a.x ? dvec3(1, 0, 0) : (least == a.y ? dvec3(0, 1, 0) : dvec3(0, 0, 1))));
}

// The data that both faces of an edge share: the derivative of its curve, up to a factor of 3, and
// the field across it, as points of quadratic Bezier curves.
struct Ribbon
{
  Ribbon(const dvec3 curve[4], const dvec3& normalA, const dvec3& normalB)
    : Chord(curve[3] - curve[0])
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Along[k] = curve[k + 1] - curve[k];
    }
    this->Across[0] = this->GetAcross(normalA, this->Along[0]);
    this->Across[2] = this->GetAcross(normalB, this->Along[2]);
    constexpr double opposite = 1e-3; // length of the sum of unit vectors
    const dvec3 sum = this->Across[0] + this->Across[2];
    // For opposite vectors, either perpendicular is suitable.
    this->Across[1] =
      length(sum) > opposite ? unit(sum) : unit(cross(this->Chord, this->Across[0]));
  }

  // The unit vector across the edge's direction in the plane perpendicular to the normal.
  dvec3 GetAcross(const dvec3& normal, const dvec3& along) const
  {
    // If the curve leaves its end along the normal, its direction cannot be used.
    const double least = 1e-3 * length(this->Chord);
    for (const dvec3& direction : { along, this->Along[1], this->Chord })
    {
      const dvec3 across = cross(normal, direction);
      if (length(across) > least)
      {
        return unit(across);
      }
    }
    return perpendicular(normal);
  }

  // The components of a vector along (l) and across (m) the edge at one of its ends (0 or 2).
  dvec2 Split(const dvec3& v, int end) const
  {
    constexpr double small =
      0.01; // relative to the chord: the curve leaves its end along the normal
    const double least = small * length(this->Chord);
    const double squared = std::max(dot(this->Along[end], this->Along[end]), least * least);
    return { squared > 0.0 ? dot(v, this->Along[end]) / squared : 0.0, dot(v, this->Across[end]) };
  }

  dvec3 Chord;
  dvec3 Along[3];
  dvec3 Across[3];
};

// The cubic edges of a face.
struct Net
{
  explicit Net(const SurfaceCorners& corners)
    : Centre(GetPNCenter(corners))
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Points[i] = corners.cornerPoint(i);
      this->Normals[i] = corners.cornerNormal(i);
    }
    for (int e = 0; e < 3; ++e)
    {
      const int a = EdgeCorners[e][0];
      const int b = EdgeCorners[e][1];
      this->Near[a][b] = corners.edgeVector(e, 0);
      this->Near[b][a] = corners.edgeVector(e, 1);
      this->Longest = std::max(this->Longest, length(this->Points[b] - this->Points[a]));
    }
  }

  Ribbon GetRibbon(int a, int b) const
  {
    const dvec3 curve[4] = { this->Points[a], this->Near[a][b], this->Near[b][a], this->Points[b] };
    return Ribbon(curve, this->Normals[a], this->Normals[b]);
  }

  // Computes the centre points near a and near b for which the patch has the tangent planes of the
  // ribbon.
  void GetInnerPoints(int a, int b, const Ribbon& ribbon, dvec3 inner[2]) const
  {
    const int c = 3 - a - b;
    // The edge as a quartic, and the ends of the next row of control points.
    const dvec3 edge[5] = { this->Points[a], 0.25 * this->Points[a] + 0.75 * this->Near[a][b],
      0.5 * (this->Near[a][b] + this->Near[b][a]), 0.25 * this->Points[b] + 0.75 * this->Near[b][a],
      this->Points[b] };
    const dvec3 rowA = 0.25 * this->Points[a] + 0.75 * this->Near[a][c];
    const dvec3 rowB = 0.25 * this->Points[b] + 0.75 * this->Near[b][c];
    const dvec2 atA = ribbon.Split(rowA - 0.5 * (edge[0] + edge[1]), 0);
    const dvec2 atB = ribbon.Split(rowB - 0.5 * (edge[3] + edge[4]), 2);
    // Inner Bezier points of the cubic l W + m A.
    const dvec3* w = ribbon.Along;
    const dvec3* x = ribbon.Across;
    const dvec3 nearA = (2.0 * (atA.x * w[1] + atA.y * x[1]) + atB.x * w[0] + atB.y * x[0]) / 3.0;
    const dvec3 nearB = (2.0 * (atB.x * w[1] + atB.y * x[1]) + atA.x * w[2] + atA.y * x[2]) / 3.0;
    // The centre of a cubic patch has half the weight in the inner points of the quartic patch.
    inner[0] = edge[1] + edge[2] + 2.0 * nearA - 0.5 * (this->Near[a][b] + this->Near[a][c]);
    inner[1] = edge[2] + edge[3] + 2.0 * nearB - 0.5 * (this->Near[b][a] + this->Near[b][c]);
    for (int k = 0; k < 2; ++k)
    {
      inner[k] = this->Limit(inner[k]);
    }
  }

  // Limits the distance from the centre point of PN triangles.
  dvec3 Limit(const dvec3& inner) const
  {
    constexpr double farthest = 0.5; // relative to the longest edge
    const dvec3 offset = inner - this->Centre;
    const double most = farthest * this->Longest;
    return length(offset) > most ? this->Centre + most * unit(offset) : inner;
  }

  dvec3 Points[3];
  dvec3 Normals[3];
  dvec3 Centre;
  double Longest = 0.0;
  dvec3 Near[3][3]; // the control point near a corner on the edge to another corner
};
}
}

vtkStandardNewMacro(vtkG1Surface);

vtkG1Surface::vtkG1Surface() = default;
vtkG1Surface::~vtkG1Surface() = default;

void vtkG1Surface::ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors)
{
  relevo::StorePNEdge(a, b, vectors);
  if (!this->GeometricNormals)
  {
    relevo::StorePNMiddleNormal(a, b, vectors + 6);
  }
}

void vtkG1Surface::ComputeFaceVectors(const Face& face, float* vectors, float* edgeNormals[3])
{
  const relevo::Net net(relevo::SurfaceCorners{ face, 2 + this->GetNumberOfEdgeNormals() });
  for (int e = 0; e < 3; ++e)
  {
    const int a = relevo::EdgeCorners[e][0];
    const int b = relevo::EdgeCorners[e][1];
    const relevo::Ribbon ribbon = net.GetRibbon(a, b);
    for (int k = 0; this->GeometricNormals && k < 3; ++k)
    {
      relevo::store(glm::vec3(ribbon.Across[k]), edgeNormals[e] + 3 * k);
    }
    glm::dvec3 inner[2];
    net.GetInnerPoints(a, b, ribbon, inner);
    relevo::store(glm::vec3(inner[0]), vectors + 6 * e);
    relevo::store(glm::vec3(inner[1]), vectors + 6 * e + 3);
  }
}

void vtkG1Surface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  const relevo::SurfaceCorners corners{ face, 2 + this->GetNumberOfEdgeNormals() };
  relevo::G1Triangle patch{ corners };
  const glm::vec3 w = relevo::SurfaceCorners::Load(weights);
  relevo::store(patch.surfacePosition(w), position);
  relevo::store(this->GeometricNormals ? patch.surfaceNormal(w)
                                       : relevo::QuadraticNormals{ { corners } }.surfaceNormal(w),
    normal);
}

std::string vtkG1Surface::GetShaderSource()
{
  const std::string normals = this->GeometricNormals
    ? std::string(relevoNormalG1)
    : std::string(relevoNormalQuadraticSum) + relevoNormalQuadratic;
  return std::string(relevoCubicPatch) + relevoG1Triangle + normals;
}

void vtkG1Surface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GeometricNormals: " << (this->GeometricNormals ? "On\n" : "Off\n");
}
