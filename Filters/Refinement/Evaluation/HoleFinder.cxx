// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/HoleFinder.h"

#include "Mesh/FaceDisplacement.h"
#include "Patterns/FacePattern.h"
#include "Patterns/RefinementPattern.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
HeightSampler MakeSampler(const HeightValidity& validity)
{
  HeightSampler sampler;
  sampler.Size = ivec2(validity.Dimensions[0], validity.Dimensions[1]);
  sampler.Validity = validity.Samples.get();
  return sampler;
}
}

HeightValidity GetHoles(vtkDisplacement* displacement)
{
  HeightValidity validity;
  if (displacement && displacement->HasHoles())
  {
    displacement->GetHeightMap()->GetDimensions(validity.Dimensions);
    validity.Samples = displacement->GetHeightMap()->ShareValidity();
  }
  return validity;
}

struct HoleFinder::Internals
{
  HeightValidity Validity;          // Heights refers to it
  mutable FaceDisplacement Heights; // the shared functions are not const, but change nothing
  // The number of missing samples below and left of each texel, to find out whether a box contains
  // any.
  std::vector<int> Sums;

  int CountTexels(ivec2 low, ivec2 high) const
  {
    const int width = this->Heights.heightSize().x + 1;
    auto sum = [this, width](int x, int y)
    { return this->Sums[static_cast<size_t>(y) * width + x]; };
    return sum(high.x + 1, high.y + 1) - sum(low.x, high.y + 1) - sum(high.x + 1, low.y) +
      sum(low.x, low.y);
  }

  // Whether the texels around a box of texture coordinates may include a missing one.
  bool HasAny(vec2 low, vec2 high) const
  {
    const ivec2 last = this->Heights.heightSize() - ivec2(1);
    const ivec2 from = clamp(ivec2(floor(this->Heights.heightPosition(low))), ivec2(0), last);
    const ivec2 to = clamp(ivec2(ceil(this->Heights.heightPosition(high))), ivec2(0), last);
    return this->CountTexels(from, to) > 0;
  }
};

HoleFinder::HoleFinder(const RefinementMesh& mesh, const HeightValidity& validity)
  : Data(new Internals{ validity, FaceDisplacement(mesh, MakeSampler(validity)), {} })
{
  const FaceDisplacement& heights = this->Data->Heights;
  std::vector<int>& sums = this->Data->Sums;
  const ivec2 size = heights.heightSize();
  const size_t width = static_cast<size_t>(size.x) + 1;
  sums.assign(width * (static_cast<size_t>(size.y) + 1), 0);
  for (int y = 0; y < size.y; ++y)
  {
    int row = 0;
    for (int x = 0; x < size.x; ++x)
    {
      row += heights.validTexel(ivec2(x, y)) > 0.0f ? 0 : 1;
      sums[(y + 1) * width + x + 1] = sums[y * width + x + 1] + row;
    }
  }
}

HoleFinder::~HoleFinder() = default;

bool HoleFinder::MayHave(int face) const
{
  const Internals& data = *this->Data;
  FaceDisplacement displaced = data.Heights;
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
  return data.HasAny(low, high);
}

bool HoleFinder::HasData(int face, const float weights[3]) const
{
  FaceDisplacement displaced = this->Data->Heights;
  displaced.Face = face;
  const vec3 w = SurfaceCorners::Load(weights);
  return displaced.heightValid(displaced.heightCoordinate(displaced.heightPoints(w), w));
}

int HoleFinder::Find(int face, const FacePattern& facePattern, unsigned char* out) const
{
  const Internals& data = *this->Data;
  const RefinementPattern& pattern = *facePattern.Pattern;
  const int numberOfTriangles = pattern.GetNumberOfTriangles();
  std::fill_n(out, numberOfTriangles, static_cast<unsigned char>(0));
  if (!this->MayHave(face))
  {
    return 0;
  }
  FaceDisplacement displaced = data.Heights;
  displaced.Face = face;
  std::vector<vec2> uvs(static_cast<size_t>(pattern.GetNumberOfVertices()));
  std::vector<bool> valid(uvs.size());
  for (size_t i = 0; i < uvs.size(); ++i)
  {
    float weights[3];
    facePattern.GetWeights(static_cast<int>(i), weights);
    const vec3 w = SurfaceCorners::Load(weights);
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
      hole = data.HasAny(
        min(min(uvs[v[0]], uvs[v[1]]), uvs[v[2]]), max(max(uvs[v[0]], uvs[v[1]]), uvs[v[2]]));
      // The box is larger than the triangle, so check the samples inside.
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
}
