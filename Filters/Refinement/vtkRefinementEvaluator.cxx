// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementEvaluator.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkHeightSampler.h"
#include "vtkLinearSurface.h"
#include "vtkNew.h"
#include "vtkPatternSelection.h"
#include "vtkRefinementMesh.h"
#include "vtkRefinementPattern.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceCorners.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
// The displacement of one face: what relevoDisplacement.glsl asks of its including side.
struct FaceDisplacement : HeightSampler
{
  FaceDisplacement(const RefinementMesh& mesh, vtkDisplacement* displacement)
    : HeightSampler(displacement->GetHeightMap())
    , Mesh(mesh)
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
    if (this->Mesh.Directions.empty())
    {
      return unitNormal;
    }
    auto direction = [this](int i)
    { return SurfaceCorners::load(&this->Mesh.Directions[3 * static_cast<size_t>(cornerId(i))]); };
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
  float Scale;
  float Offset;
  bool AlongNormal;
  vec3 Fixed;
  int Face = 0;
};
}

struct RefinementEvaluator::Internals
{
  const RefinementMesh& Mesh;
  vtkRefinementSurface* Surface;
  vtkDisplacement* Displacement;
  vtkNew<vtkLinearSurface> Linear;
  std::unique_ptr<FaceDisplacement> Displaced;
  bool HasHoles = false;
  // Sums of samples without data below and left of each texel: whether a box holds any.
  std::vector<int> HoleSums;

  int CountHoleTexels(ivec2 low, ivec2 high) const
  {
    const int width = this->Displaced->heightSize().x + 1;
    auto sum = [this, width](int x, int y)
    { return this->HoleSums[static_cast<size_t>(y) * width + x]; };
    return sum(high.x + 1, high.y + 1) - sum(low.x, high.y + 1) - sum(high.x + 1, low.y) +
      sum(low.x, low.y);
  }

  // Whether the texels around a box of texture coordinates may include one without data.
  bool BoxHasHoles(vec2 low, vec2 high) const
  {
    const ivec2 last = this->Displaced->heightSize() - ivec2(1);
    const ivec2 from = clamp(ivec2(floor(this->Displaced->heightPosition(low))), ivec2(0), last);
    const ivec2 to = clamp(ivec2(ceil(this->Displaced->heightPosition(high))), ivec2(0), last);
    return this->CountHoleTexels(from, to) > 0;
  }
};

RefinementEvaluator::RefinementEvaluator(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
  : Data(new Internals{
      mesh, recipe->GetSurface(), recipe->GetDisplacement(), {}, nullptr, false, {} })
{
  Internals& data = *this->Data;
  if (!data.Surface)
  {
    data.Surface = data.Linear;
  }
  if (!data.Displacement || mesh.Faces.empty())
  {
    return;
  }
  data.Displaced.reset(new FaceDisplacement(mesh, data.Displacement));
  data.HasHoles = data.Displacement->HasHoles() && data.Displaced->Validity;
  if (data.HasHoles)
  {
    const ivec2 size = data.Displaced->heightSize();
    const size_t width = static_cast<size_t>(size.x) + 1;
    data.HoleSums.assign(width * (static_cast<size_t>(size.y) + 1), 0);
    for (int y = 0; y < size.y; ++y)
    {
      int row = 0;
      for (int x = 0; x < size.x; ++x)
      {
        row += data.Displaced->validTexel(ivec2(x, y)) > 0.0f ? 0 : 1;
        data.HoleSums[(y + 1) * width + x + 1] = data.HoleSums[y * width + x + 1] + row;
      }
    }
  }
}

RefinementEvaluator::~RefinementEvaluator() = default;

void RefinementEvaluator::Evaluate(
  int face, const float weights[3], float position[3], float normal[3]) const
{
  const Internals& data = *this->Data;
  const vtkRefinementSurface::Face corners = data.Mesh.GetSurfaceFace(face);
  data.Surface->Evaluate(corners, weights, position, normal);

  vec3 n = SurfaceCorners::load(normal);
  if (data.Displaced)
  {
    FaceDisplacement displaced = *data.Displaced;
    displaced.Face = face;
    const FaceDisplacement::DisplacedPoint point =
      displaced.displace(SurfaceCorners::load(weights), n);
    for (int c = 0; c < 3; ++c)
    {
      position[c] += point.Vector[c];
    }
    n = point.Normal;
  }
  n = unitVector(n);
  for (int c = 0; c < 3; ++c)
  {
    // -0 would be other bits for the same place or normal.
    position[c] += 0.0f;
    normal[c] = n[c] + 0.0f;
  }
}

bool RefinementEvaluator::MayHaveHoles(int face) const
{
  const Internals& data = *this->Data;
  if (!data.HasHoles)
  {
    return false;
  }
  FaceDisplacement displaced = *data.Displaced;
  displaced.Face = face;
  vec2 low(1.0f);
  vec2 high(0.0f);
  auto extend = [&](int point)
  {
    const vec2 uv = displaced.pointTextureCoordinate(point);
    low = min(low, uv);
    high = max(high, uv);
  };
  for (int i = 0; i < 3; ++i)
  {
    extend(displaced.cornerId(i));
  }
  for (int k = 0; displaced.hasSeams() && k < 9; ++k)
  {
    extend(displaced.seamPoint(k));
  }
  return data.BoxHasHoles(low, high);
}

int RefinementEvaluator::FindHoles(
  int face, const FacePattern& facePattern, unsigned char* out) const
{
  const Internals& data = *this->Data;
  const vtkRefinementPattern& pattern = *facePattern.Pattern;
  const int numberOfTriangles = pattern.GetNumberOfTriangles();
  std::fill_n(out, numberOfTriangles, static_cast<unsigned char>(0));
  if (!this->MayHaveHoles(face))
  {
    return 0;
  }
  FaceDisplacement displaced = *data.Displaced;
  displaced.Face = face;
  std::vector<vec2> uvs(static_cast<size_t>(pattern.GetNumberOfVertices()));
  std::vector<bool> valid(uvs.size());
  for (size_t i = 0; i < uvs.size(); ++i)
  {
    float weights[3];
    facePattern.GetWeights(static_cast<int>(i), weights);
    const vec3 w = SurfaceCorners::load(weights);
    uvs[i] = displaced.heightCoordinate(displaced.heightPoints(w), w);
    valid[i] = displaced.heightValid(uvs[i]);
  }
  int count = 0;
  for (int t = 0; t < numberOfTriangles; ++t)
  {
    const unsigned int* v = &pattern.Triangles[3 * t];
    bool hole = !valid[v[0]] || !valid[v[1]] || !valid[v[2]];
    if (!hole)
    {
      hole = data.BoxHasHoles(
        min(min(uvs[v[0]], uvs[v[1]]), uvs[v[2]]), max(max(uvs[v[0]], uvs[v[1]]), uvs[v[2]]));
      // The box is no smaller than the triangle: look at the samples inside.
      if (hole)
      {
        const vec2 a = displaced.heightPosition(uvs[v[0]]);
        const vec2 b = displaced.heightPosition(uvs[v[1]]);
        const vec2 c = displaced.heightPosition(uvs[v[2]]);
        hole = false;
        auto side = [](vec2 p, vec2 q, vec2 r)
        { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
        const float area = side(a, b, c);
        const ivec2 last = displaced.heightSize() - ivec2(1);
        const ivec2 low = clamp(ivec2(ceil(min(min(a, b), c))), ivec2(0), last);
        const ivec2 high = clamp(ivec2(floor(max(max(a, b), c))), ivec2(0), last);
        for (int y = low.y; y <= high.y && !hole; ++y)
        {
          for (int x = low.x; x <= high.x && !hole; ++x)
          {
            const vec2 p(static_cast<float>(x), static_cast<float>(y));
            hole = displaced.validTexel(ivec2(x, y)) == 0.0f && side(a, b, p) * area >= 0.0f &&
              side(b, c, p) * area >= 0.0f && side(c, a, p) * area >= 0.0f;
          }
        }
      }
    }
    out[t] = hole ? 1 : 0;
    count += hole ? 1 : 0;
  }
  return count;
}

vtkIdType CountHoles(
  const RefinementMesh& mesh, const PatternSelection& selection, vtkAdaptiveRefinement* recipe)
{
  vtkDisplacement* displacement = recipe->GetDisplacement();
  if (!displacement || !displacement->HasHoles())
  {
    return 0;
  }
  const RefinementEvaluator evaluator(mesh, recipe);
  std::atomic<vtkIdType> count(0);
  vtkSMPTools::For(0, selection.GetNumberOfFaces(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<unsigned char> out;
      vtkIdType holes = 0;
      for (int face = static_cast<int>(begin); face < end; ++face)
      {
        const FacePattern pattern = selection.GetFacePattern(face);
        out.resize(static_cast<size_t>(pattern.Pattern->GetNumberOfTriangles()));
        holes += evaluator.FindHoles(face, pattern, out.data());
      }
      count += holes;
    });
  return count;
}
}
