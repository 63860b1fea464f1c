// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the displacement of one face: the functions that relevoDisplacement.glsl requires
 */
#ifndef FaceDisplacement_h
#define FaceDisplacement_h

#include "Mesh/RefinementMesh.h"
#include "Surfaces/HeightSampler.h"
#include "Surfaces/SurfaceCorners.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"

namespace relevo
{
struct FaceDisplacement : HeightSampler
{
  /// For heights only.
  FaceDisplacement(const RefinementMesh& mesh, const HeightSampler& heights)
    : HeightSampler(heights)
    , Mesh(mesh)
  {
  }
  /// For a surface with directions, or nullptr.
  FaceDisplacement(
    const RefinementMesh& mesh, vtkDisplacement* displacement, vtkRefinementSurface* surface)
    : HeightSampler(displacement->GetHeightMap())
    , Mesh(mesh)
    , Surface(surface)
    , Scale(static_cast<float>(displacement->GetScale()))
    , Offset(static_cast<float>(displacement->GetOffset()))
    , AlongNormal(displacement->IsAlongNormal())
    , Fixed(displacement->GetDirection()[0], displacement->GetDirection()[1],
        displacement->GetDirection()[2])
  {
  }

  float displacementScale() const { return this->Scale; }
  float displacementOffset() const { return this->Offset; }
  bool displacementAlongNormal() const { return this->AlongNormal; }
  vec3 displacementDirection(vec3 w, vec3 unitNormal) const
  {
    if (!this->AlongNormal)
    {
      return this->Fixed;
    }
    if (this->Surface)
    {
      vec3 direction;
      this->Surface->EvaluateDirection(this->Mesh.GetSurfaceFace(this->Face), &w[0], &direction[0]);
      return unitVector(direction);
    }
    if (this->Mesh.Directions.empty())
    {
      return unitNormal;
    }
    auto direction = [this](int i)
    { return SurfaceCorners::Load(&this->Mesh.Directions[3 * static_cast<size_t>(cornerId(i))]); };
    return unitVector(weightedSum(direction(0), direction(1), direction(2), w));
  }
  int cornerId(int i) const { return this->Mesh.Faces[this->Face].Corners[i]; }
  bool hasSeams() const { return !this->Mesh.Seams.empty(); }
  int seamPoint(int k) const { return this->Mesh.Seams[9 * static_cast<size_t>(this->Face) + k]; }
  vec2 pointTextureCoordinate(int id) const
  {
    if (this->Mesh.TextureCoordinates.empty())
    {
      return vec2(0.0f);
    }
    const float* uv = &this->Mesh.TextureCoordinates[2 * static_cast<size_t>(id)];
    return vec2(uv[0], uv[1]);
  }
  vec4 pointFrame(int id, int k) const
  {
    const float* frame = &this->Mesh.Frames[8 * static_cast<size_t>(id) + 4 * k];
    return vec4(frame[0], frame[1], frame[2], frame[3]);
  }

#include "glsl/relevoDisplacedNormal.glsl"
#include "glsl/relevoDisplacement.glsl"

  const RefinementMesh& Mesh;
  vtkRefinementSurface* Surface = nullptr;
  float Scale = 1.0f;
  float Offset = 0.0f;
  bool AlongNormal = true;
  vec3 Fixed = vec3(0.0f);
  int Face = 0;
};
}

#endif
