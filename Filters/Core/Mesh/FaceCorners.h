// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  FaceCorners
 * @brief   the C++ version of the functions that the shared surface functions require
 */
#ifndef FaceCorners_h
#define FaceCorners_h

#include "Mathematics/RefinementMathematics.h"

#include <cstddef>

namespace relevo
{
#include "glsl/relevoWeights.glsl"

inline void store(const vec3& v, float* out)
{
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

/// `FaceType` is vtkRefinementSurface::Face.
template <typename FaceType>
struct FaceCorners
{
  static vec3 Load(const float* v) { return vec3(v[0], v[1], v[2]); }

  vec3 cornerPoint(int i) const { return Load(this->Face.Points[i]); }
  vec3 cornerNormal(int i) const { return Load(this->Face.Normals[i]); }
  vec3 cornerDirection(int i) const { return Load(this->Face.Directions[i]); }
  vec3 edgeVector(int edge, int k) const
  {
    return Load(this->Face.Vectors + 3 * (edge * this->VectorsPerEdge + k));
  }
  vec3 faceVector(int k) const
  {
    return Load(this->Face.Vectors + 3 * (3 * this->VectorsPerEdge + k));
  }

  int tableEntry() const { return this->Face.TableEntry; }
  int cornerOrder() const { return this->Face.CornerOrder; }
  vec4 tablePoint(int i) const
  {
    const float* p = &this->Face.MeshTables->Points[4 * static_cast<std::size_t>(i)];
    return vec4(p[0], p[1], p[2], p[3]);
  }
  ivec4 tableRecord(int i) const
  {
    const int* r = &this->Face.MeshTables->Records[4 * static_cast<std::size_t>(i)];
    return ivec4(r[0], r[1], r[2], r[3]);
  }

  vec3 surfaceScale() const { return vec3(1.0f); }

  const FaceType& Face;
  int VectorsPerEdge;
};
}

#endif
