// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScalarTaggedSurface.h"

#include "Arrays/PointArray.h"
#include "Surfaces/PNPatch.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "relevoNormalQuadraticSum.h"
#include "relevoNormalTagged.h"

#include <algorithm>
#include <cstddef>

namespace relevo
{
namespace
{
constexpr int VectorsPerEdge = 3;

// The position of each tag in a point's values.
enum TagOffset
{
  SHARPNESS,
  TENSION,
  BIAS,
  DIRECTION,
  VALUES_PER_POINT = DIRECTION + 3
};

struct TaggedNormals : QuadraticNormalSum
{
#include "glsl/relevoNormalTagged.glsl"
};

// The tangent and normal of an edge at one of its ends.
struct EdgeEnd
{
  vec3 Tangent;
  vec3 Normal;
  /// How far the edge runs along the direction of a sharp end, from 0 to 1.
  float Along;
};

bool isBent(const float* tags)
{
  return tags[SHARPNESS] != 0.0f || tags[BIAS] != 0.0f;
}

EdgeEnd leaveEnd(const vec3& edge, const vec3& normal, const vec3& otherNormal, const float* tags)
{
  const float slack = 1.0f - tags[TENSION];
  const vec3 tangent = GetPNTangent(edge, normal);
  if (!isBent(tags))
  {
    return { slack * tangent, normal, 0.0f };
  }
  // Lengths are relative to the edge, so that squares are in the range of floats.
  const vec3 chord = unitVector(edge);
  const float height = dot(chord, normal);
  const vec3 flat = chord - height * normal;
  const float flatSquared = dot(flat, flat);
  const vec3 tag = SurfaceCorners::Load(tags + DIRECTION);
  const vec3 direction = tag - dot(tag, normal) * normal;
  constexpr float parallel = 1e-3f; // to the normal, in radians
  const bool directed = dot(direction, direction) > parallel * parallel;
  const vec3 axis = directed ? unitVector(direction) : vec3(0.0f);
  const vec3 aside = flat - dot(flat, axis) * axis;
  const float asideSquared = dot(aside, aside);
  constexpr float opposite = 0.1f; // normals 154 degrees apart
  const float asideHeight = height +
    dot(flat, axis) * dot(otherNormal, axis) / std::max(1.0f + dot(normal, otherNormal), opposite);

  // This is 0, as is |flat|, if the edge runs along the normal.
  const float room = std::max(asideSquared, 0.5f * flatSquared);
  const float share = room > 0.0f ? asideSquared / room : 1.0f; // 1 - a
  const float bend = 1.0f + tags[BIAS];
  const float sharp = bend * tags[SHARPNESS] * asideHeight;
  const float raised = dot(edge, chord) * (share * sharp - tags[BIAS] * height);
  EdgeEnd end;
  end.Tangent = slack * (tangent + raised * normal);
  end.Normal = room > 0.0f
    ? unitVector(normal - sharp / room * aside + tags[BIAS] * height / flatSquared * flat)
    : normal;
  end.Along = tags[SHARPNESS] > 0.0f ? 1.0f - share : 0.0f;
  return end;
}

// The two edges at a sorted corner, to the lower and to the higher of the other corners.
struct CornerEdges
{
  int Edges[2];
  int Others[2];
};

constexpr CornerEdges EdgesOfCorners[3] = { { { 0, 2 }, { 1, 2 } }, { { 0, 1 }, { 0, 2 } },
  { { 2, 1 }, { 0, 1 } } };
}
}

vtkStandardNewMacro(vtkScalarTaggedSurface);

vtkScalarTaggedSurface::vtkScalarTaggedSurface() = default;
vtkScalarTaggedSurface::~vtkScalarTaggedSurface() = default;

void vtkScalarTaggedSurface::SetName(std::string& name, const char* value)
{
  const std::string given = value ? value : "";
  if (name != given)
  {
    name = given;
    this->Modified();
  }
}

void vtkScalarTaggedSurface::SetSharpnessArrayName(const char* name)
{
  this->SetName(this->SharpnessArrayName, name);
}

const char* vtkScalarTaggedSurface::GetSharpnessArrayName()
{
  return this->SharpnessArrayName.c_str();
}

void vtkScalarTaggedSurface::SetTensionArrayName(const char* name)
{
  this->SetName(this->TensionArrayName, name);
}

const char* vtkScalarTaggedSurface::GetTensionArrayName()
{
  return this->TensionArrayName.c_str();
}

void vtkScalarTaggedSurface::SetBiasArrayName(const char* name)
{
  this->SetName(this->BiasArrayName, name);
}

const char* vtkScalarTaggedSurface::GetBiasArrayName()
{
  return this->BiasArrayName.c_str();
}

void vtkScalarTaggedSurface::SetDirectionArrayName(const char* name)
{
  this->SetName(this->DirectionArrayName, name);
}

const char* vtkScalarTaggedSurface::GetDirectionArrayName()
{
  return this->DirectionArrayName.c_str();
}

bool vtkScalarTaggedSurface::GetPointValues(vtkPolyData* mesh, float* values, std::string& error)
{
  using namespace relevo;
  const struct
  {
    const std::string& Name;
    TagOffset Offset;
    int Components;
  } arrays[] = { { this->SharpnessArrayName, SHARPNESS, 1 }, { this->TensionArrayName, TENSION, 1 },
    { this->BiasArrayName, BIAS, 1 }, { this->DirectionArrayName, DIRECTION, 3 } };
  for (const auto& array : arrays)
  {
    if (!array.Name.empty() && mesh->GetPointData()->HasArray(array.Name.c_str()) &&
      !TakePointArray(
        mesh, array.Name, array.Components, values + array.Offset, VALUES_PER_POINT, error))
    {
      return false;
    }
  }
  const auto clampTo = [](float& value, float low)
  { value = std::min(std::max(value, low), 1.0f); };
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    float* tags = values + VALUES_PER_POINT * static_cast<std::size_t>(point);
    clampTo(tags[SHARPNESS], 0.0f);
    clampTo(tags[TENSION], -1.0f);
    clampTo(tags[BIAS], -1.0f);
    // Choose one of the two signs, so that opposite directions do not cancel in the mean of
    // coincident points. The sign changes across a plane that contains few typical directions.
    const vec3 half(0.53f, 0.29f, 0.80f);
    vec3 direction = unitVector(SurfaceCorners::Load(tags + DIRECTION));
    direction *= dot(direction, half) < 0.0f ? -1.0f : 1.0f;
    store(direction, tags + DIRECTION);
  }
  return true;
}

void vtkScalarTaggedSurface::ComputeEdgeVectors(
  const Corner& from, const Corner& to, float* vectors)
{
  using namespace relevo;
  const vec3 a = SurfaceCorners::Load(from.Point);
  const vec3 b = SurfaceCorners::Load(to.Point);
  const vec3 normalA = SurfaceCorners::Load(from.Normal);
  const vec3 normalB = SurfaceCorners::Load(to.Normal);
  const vec3 edge = b - a;
  const EdgeEnd endA = leaveEnd(edge, normalA, normalB, from.Values);
  const EdgeEnd endB = leaveEnd(-edge, normalB, normalA, to.Values);
  store(a + endA.Tangent / 3.0f, vectors);
  store(b + endB.Tangent / 3.0f, vectors + 3);
  store(GetPNMiddleNormal(edge, endA.Normal, endB.Normal), vectors + 6);
}

void vtkScalarTaggedSurface::ComputeFaceVectors(
  const Face& face, float* vectors, float* edgeNormals[3])
{
  using namespace relevo;
  const SurfaceCorners corners{ face, VectorsPerEdge };
  store(GetPNCenter(corners), vectors);
  vec3 edgeEnds[3][2]; // normals at the lower and the higher end of each edge
  bool creased[3] = { false, false, false };
  for (int i = 0; i < 3; ++i)
  {
    const CornerEdges& at = EdgesOfCorners[i];
    EdgeEnd ends[2];
    for (int k = 0; k < 2; ++k)
    {
      const int other = at.Others[k];
      ends[k] = leaveEnd(corners.cornerPoint(other) - corners.cornerPoint(i),
        corners.cornerNormal(i), corners.cornerNormal(other), face.Values[i]);
    }
    for (int k = 0; k < 2; ++k)
    {
      const EdgeEnd& end = ends[k];
      vec3 normal = end.Normal;
      if (end.Along > 0.0f)
      {
        normal = unitVector(normal + (ends[1 - k].Normal - normal) * end.Along);
        creased[at.Edges[k]] = true;
      }
      edgeEnds[at.Edges[k]][i < at.Others[k] ? 0 : 1] = normal;
      store(normal, vectors + 3 * (1 + 2 * i + k));
    }
  }
  for (int e = 0; e < 3; ++e)
  {
    if (creased[e])
    {
      const vec3 edge = corners.cornerPoint(e == 0 ? 1 : 2) - corners.cornerPoint(e == 1 ? 1 : 0);
      store(GetPNMiddleNormal(edge, edgeEnds[e][0], edgeEnds[e][1]), edgeNormals[e]);
    }
  }
}

bool vtkScalarTaggedSurface::SplitsNormals(const Face& face)
{
  return std::any_of(face.Values, face.Values + 3, relevo::isBent);
}

void vtkScalarTaggedSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  using namespace relevo;
  const SurfaceCorners corners{ face, VectorsPerEdge };
  const vec3 w = SurfaceCorners::Load(weights);
  store(PNTriangle{ corners }.surfacePosition(w), position);
  store(TaggedNormals{ { corners } }.surfaceNormal(w), normal);
}

float vtkScalarTaggedSurface::ComputeNormalCone(const Face& face, float axis[3])
{
  return relevo::ComputePNNormalCone({ face, relevo::VectorsPerEdge }, axis);
}

std::string vtkScalarTaggedSurface::GetShaderSource()
{
  return relevo::GetPNTriangleSource() + relevoNormalQuadraticSum + relevoNormalTagged;
}

void vtkScalarTaggedSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SharpnessArrayName: " << this->SharpnessArrayName << "\n";
  os << indent << "TensionArrayName: " << this->TensionArrayName << "\n";
  os << indent << "BiasArrayName: " << this->BiasArrayName << "\n";
  os << indent << "DirectionArrayName: " << this->DirectionArrayName << "\n";
}
