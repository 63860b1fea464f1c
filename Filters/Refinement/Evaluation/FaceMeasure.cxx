// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/FaceMeasure.h"

#include "Evaluation/HoleFinder.h"
#include "Evaluation/PatternWalk.h"
#include "Mesh/FaceDisplacement.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/FacePattern.h"
#include "Patterns/RefinementPattern.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkLinearSurface.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace relevo
{
namespace
{
constexpr int LatticeSize = 16; // parts of a face's side where second differences are measured
constexpr int MinimumParts = 4; // of the side of a triangle
constexpr double PartsOfFace = 32.0;
constexpr double SafetyFactor = 1.5; // second differences are those of samples

using Corners = std::array<const float*, 3>;

// Heights of a face, in the units of the height map.
struct HeightPlane
{
  HeightPlane(const FaceDisplacement& displaced, int face)
    : Heights(displaced)
  {
    const dvec2 size(displaced.heightSize());
    this->Last = size - 1.0;
    for (int i = 0; i < 3; ++i)
    {
      const int point = displaced.Mesh.Faces[face].Corners[i];
      this->Corners[i] = dvec2(displaced.pointTextureCoordinate(point)) * size - 0.5;
    }
  }

  dvec2 GetPlace(const dvec3& w) const
  {
    return this->Corners[0] * w.x + this->Corners[1] * w.y + this->Corners[2] * w.z;
  }

  double GetHeight(const dvec2& place) const
  {
    const dvec2 inside = clamp(place, dvec2(0.0), this->Last);
    const dvec2 corner = floor(inside);
    const dvec2 t = inside - corner;
    const ivec2 a(corner);
    const ivec2 b = min(a + ivec2(1), ivec2(this->Last));
    const auto get = [this](int x, int y) -> double
    { return this->Heights.heightTexel(ivec2(x, y)); };
    return mix(mix(get(a.x, a.y), get(b.x, a.y), t.x), mix(get(a.x, b.y), get(b.x, b.y), t.x), t.y);
  }

  const HeightSampler& Heights;
  dvec2 Last;
  dvec2 Corners[3];
};

// A flat face with one direction of displacement: deviations are differences of heights.
struct FlatSampler
{
  using Value = double;
  struct Vertex
  {
    dvec2 Place;
    double Height;

    Vertex operator*(double s) const { return { this->Place * s, this->Height * s }; }
    Vertex operator+(const Vertex& v) const
    {
      return { this->Place + v.Place, this->Height + v.Height };
    }
  };

  double Evaluate(const Vertex& vertex) const
  {
    return this->Scale * (vertex.Height - this->Plane.GetHeight(vertex.Place));
  }

  // Vertices have the heights of the shaders, which compute in floats.
  Vertex MakeVertex(const vec3& w)
  {
    const ivec3 corners(
      this->Displaced.cornerId(0), this->Displaced.cornerId(1), this->Displaced.cornerId(2));
    const vec2 position =
      this->Displaced.heightPosition(this->Displaced.heightCoordinate(corners, w));
    const vec2 corner = floor(position);
    return { this->Plane.GetPlace(dvec3(w)),
      this->Displaced.heightBetween(ivec2(corner), position - corner) };
  }

  int CountParts(const Vertex&, const Vertex&, const Vertex&) const { return 1; }
  double GetMargin(const Vertex&, const Vertex&, const Vertex&, int) const { return 0.0; }

  const HeightPlane& Plane;
  FaceDisplacement Displaced;
  double Scale;
};

// Any other face: deviations are vectors.
struct CurvedSampler
{
  using Value = dvec3;
  struct Vertex
  {
    dvec3 Weights;
    dvec2 Place;
    dvec3 Point;

    Vertex operator*(double s) const
    {
      return { this->Weights * s, this->Place * s, this->Point * s };
    }
    Vertex operator+(const Vertex& v) const
    {
      return { this->Weights + v.Weights, this->Place + v.Place, this->Point + v.Point };
    }
  };

  dvec3 GetPoint(const dvec3& weights, double height) const
  {
    const vec3 w(weights);
    vec3 position;
    vec3 normal;
    this->Surface->Evaluate(this->Corners, &w[0], &position[0], &normal[0]);
    const dvec3 direction(this->Displaced.displacementDirection(w, unitVector(normal)));
    return dvec3(position) +
      direction * (double{ this->Displaced.Offset } + this->Displaced.Scale * height);
  }

  dvec3 Evaluate(const Vertex& vertex) const
  {
    return vertex.Point - this->GetPoint(vertex.Weights, this->Plane.GetHeight(vertex.Place));
  }

  Vertex MakeVertex(const vec3& w)
  {
    const dvec2 place = this->Plane.GetPlace(dvec3(w));
    return { dvec3(w), place, this->GetPoint(dvec3(w), this->Plane.GetHeight(place)) };
  }

  static double GetRange(const Vertex& a, const Vertex& b, const Vertex& c)
  {
    const dvec3 range =
      max(max(a.Weights, b.Weights), c.Weights) - min(min(a.Weights, b.Weights), c.Weights);
    return std::max({ range.x, range.y, range.z });
  }

  int CountParts(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return std::max(MinimumParts, static_cast<int>(std::ceil(PartsOfFace * GetRange(a, b, c))));
  }

  double GetMargin(const Vertex& a, const Vertex& b, const Vertex& c, int parts) const
  {
    const double spacing = LatticeSize * GetRange(a, b, c) / parts;
    return SafetyFactor / 8.0 * this->Difference * spacing * spacing;
  }

  // Returns the largest second difference between samples of the face at one height.
  double MeasureDifference() const
  {
    double height = this->Plane.GetHeight(this->Plane.GetPlace(dvec3(1.0 / 3.0)));
    for (const dvec2& corner : this->Plane.Corners)
    {
      const double other = this->Plane.GetHeight(corner);
      height = std::abs(other) > std::abs(height) ? other : height;
    }
    constexpr int n = LatticeSize;
    std::vector<dvec3> points(static_cast<std::size_t>((n + 1) * (n + 1)));
    const auto get = [&](int i, int j) -> dvec3&
    { return points[static_cast<std::size_t>(j * (n + 1) + i)]; };
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i + j <= n; ++i)
      {
        get(i, j) = this->GetPoint(dvec3(n - i - j, i, j) / double{ n }, height);
      }
    }
    double largest = 0.0;
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i + j <= n; ++i)
      {
        const auto measure = [&](int di, int dj)
        {
          const dvec3 sum = get(i - di, j - dj) + get(i + di, j + dj);
          largest = std::max(largest, length(sum - 2.0 * get(i, j)));
        };
        if (i > 0 && i + j < n)
        {
          measure(1, 0);
        }
        if (j > 0 && i + j < n)
        {
          measure(0, 1);
        }
        if (i > 0 && j > 0)
        {
          measure(1, -1);
        }
      }
    }
    return largest;
  }

  const HeightPlane& Plane;
  FaceDisplacement Displaced;
  vtkRefinementSurface* Surface;
  vtkRefinementSurface::Face Corners;
  double Difference;
};

// The sorted edge on which both vertices lie, or 3.
int FindEdge(const float* a, const float* b)
{
  constexpr int opposite[3] = { 2, 0, 1 };
  for (int e = 0; e < 3; ++e)
  {
    if (a[opposite[e]] == 0.0f && b[opposite[e]] == 0.0f)
    {
      return e;
    }
  }
  return 3;
}

// Measures a pattern with one of the samplers.
template <typename Sampler>
class PatternMeasure
{
public:
  PatternMeasure(Sampler& sampler, const FacePattern& pattern)
    : Samples(sampler)
    , Pattern(*pattern.Pattern)
    , Walk(sampler, sampler.Displaced)
  {
    const int number = this->Pattern.GetNumberOfVertices();
    this->Weights.resize(3 * static_cast<std::size_t>(number));
    this->Vertices.reserve(static_cast<std::size_t>(number));
    for (int i = 0; i < number; ++i)
    {
      float* w = &this->Weights[3 * static_cast<std::size_t>(i)];
      pattern.GetWeights(i, w);
      this->Vertices.push_back(sampler.MakeVertex(SurfaceCorners::Load(w)));
    }
  }

  FaceDeviations MeasureAll()
  {
    for (std::size_t i = 0; i < this->Pattern.Lines.size(); i += 2)
    {
      this->MeasureLine(this->Pattern.Lines[i], this->Pattern.Lines[i + 1]);
    }
    for (int t = 0; t < this->Pattern.GetNumberOfTriangles(); ++t)
    {
      this->MeasureTriangle(t);
    }
    return this->Get();
  }

  // Measures a face with missing samples. A removed triangle deviates by its longest side, if it
  // contains data.
  FaceDeviations MeasureRest(int face, const HoleFinder& holes, const dvec3 points[3])
  {
    std::vector<unsigned char> out(static_cast<std::size_t>(this->Pattern.GetNumberOfTriangles()));
    holes.Find(face, *this->Source, out.data());
    for (int t = 0; t < this->Pattern.GetNumberOfTriangles(); ++t)
    {
      const unsigned int* v = &this->Pattern.Triangles[3 * static_cast<std::size_t>(t)];
      if (out[t] == 0)
      {
        this->MeasureTriangle(t);
        for (int i = 0; i < 3; ++i)
        {
          this->MeasureLine(v[i], v[(i + 1) % 3]);
        }
      }
      else if (this->IsLargerThanTexel(v) && this->HasData(face, v, holes))
      {
        this->Largest[3] = std::max(this->Largest[3], this->GetLongestSide(v, points));
      }
    }
    return this->Get();
  }

  const FacePattern* Source = nullptr;

private:
  FaceDeviations Get() const
  {
    FaceDeviations deviations;
    for (int e = 0; e < 3; ++e)
    {
      deviations.Edges[e] = Narrow(this->Largest[e]);
    }
    deviations.Inside = Narrow(this->Largest[3]);
    return deviations;
  }

  static float Narrow(double value)
  {
    return std::isfinite(value) ? static_cast<float>(std::min(value, double{ VTK_FLOAT_MAX }))
                                : 0.0f;
  }

  void MeasureLine(unsigned int i, unsigned int j)
  {
    const int edge = FindEdge(&this->Weights[3 * i], &this->Weights[3 * j]);
    const auto& a = this->Vertices[i];
    const auto& b = this->Vertices[j];
    const int parts = this->Samples.CountParts(a, b, b);
    this->Largest[edge] = std::max(this->Largest[edge],
      this->Walk.MeasureLine(a, b, parts) + this->Samples.GetMargin(a, b, b, parts));
  }

  void MeasureTriangle(int triangle)
  {
    const unsigned int* v = &this->Pattern.Triangles[3 * static_cast<std::size_t>(triangle)];
    const auto& a = this->Vertices[v[0]];
    const auto& b = this->Vertices[v[1]];
    const auto& c = this->Vertices[v[2]];
    double largest = this->Walk.MeasureTexels(a, b, c);
    const int parts = this->Samples.CountParts(a, b, c);
    if (parts > 1)
    {
      largest = std::max(largest, this->Walk.MeasureLattice(a, b, c, parts)) +
        this->Samples.GetMargin(a, b, c, parts);
    }
    this->Largest[3] = std::max(this->Largest[3], largest);
  }

  // Smaller removed triangles do not change the rim of a hole.
  bool IsLargerThanTexel(const unsigned int* v) const
  {
    const dvec2& a = this->Vertices[v[0]].Place;
    const dvec2& b = this->Vertices[v[1]].Place;
    const dvec2& c = this->Vertices[v[2]].Place;
    const dvec2 size = max(max(a, b), c) - min(min(a, b), c);
    return std::max(size.x, size.y) > 1.0;
  }

  bool HasData(int face, const unsigned int* v, const HoleFinder& holes) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (holes.HasData(face, &this->Weights[3 * v[i]]))
      {
        return true;
      }
    }
    bool found = false;
    this->Walk.ForEachTexel(this->Vertices[v[0]], this->Vertices[v[1]], this->Vertices[v[2]],
      [&found](const dvec3&) { found = true; });
    return found;
  }

  double GetLongestSide(const unsigned int* v, const dvec3 points[3]) const
  {
    dvec3 x[3];
    for (int i = 0; i < 3; ++i)
    {
      const float* w = &this->Weights[3 * v[i]];
      x[i] = points[0] * double{ w[0] } + points[1] * double{ w[1] } + points[2] * double{ w[2] };
    }
    return std::max({ length(x[1] - x[0]), length(x[2] - x[1]), length(x[0] - x[2]) });
  }

  Sampler& Samples;
  const RefinementPattern& Pattern;
  PatternWalk<Sampler> Walk;
  std::vector<float> Weights;
  std::vector<typename Sampler::Vertex> Vertices;
  double Largest[4] = { 0.0, 0.0, 0.0, 0.0 }; // on the edges and inside
};
}

struct FaceMeasure::Internals
{
  const RefinementMesh& Mesh;
  const HoleFinder* Holes;
  vtkSmartPointer<vtkRefinementSurface> Surface;
  FaceDisplacement Displaced;
  bool IsLinear;
  std::vector<float> Differences; // per face; negative if not measured

  template <typename Sampler>
  FaceDeviations Measure(int face, const FacePattern& pattern, Sampler& sampler) const
  {
    PatternMeasure<Sampler> measure(sampler, pattern);
    if (!this->Holes || !this->Holes->MayHave(face))
    {
      return measure.MeasureAll();
    }
    measure.Source = &pattern;
    dvec3 points[3];
    for (int i = 0; i < 3; ++i)
    {
      points[i] = dvec3(SurfaceCorners::Load(
        &this->Mesh.Points[3 * static_cast<std::size_t>(this->Mesh.Faces[face].Corners[i])]));
    }
    return measure.MeasureRest(face, *this->Holes, points);
  }

  bool IsFlat(int face) const
  {
    if (!this->IsLinear || !this->Displaced.AlongNormal)
    {
      return this->IsLinear;
    }
    const auto isConstant = [this, face](const std::vector<float>& vectors)
    {
      const int* corners = this->Mesh.Faces[face].Corners;
      const auto get = [&](int i) { return &vectors[3 * static_cast<std::size_t>(corners[i])]; };
      return std::equal(get(0), get(0) + 3, get(1)) && std::equal(get(0), get(0) + 3, get(2));
    };
    return isConstant(this->Mesh.Directions.empty() ? this->Mesh.Normals : this->Mesh.Directions);
  }
};

FaceMeasure::FaceMeasure(
  const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe, const HoleFinder* holes)
{
  vtkSmartPointer<vtkRefinementSurface> surface = recipe->GetSurface();
  if (!surface)
  {
    surface = vtkSmartPointer<vtkLinearSurface>::New();
  }
  const bool isLinear = std::strcmp(surface->GetClassName(), "vtkLinearSurface") == 0;
  this->Data.reset(new Internals{ mesh, holes, surface,
    FaceDisplacement(
      mesh, recipe->GetDisplacement(), surface->HasDirections() ? surface.Get() : nullptr),
    isLinear, std::vector<float>(mesh.Faces.size(), -1.0f) });
}

FaceMeasure::~FaceMeasure() = default;

FaceDeviations FaceMeasure::Measure(int face, const FacePattern& pattern)
{
  Internals& data = *this->Data;
  FaceDisplacement displaced = data.Displaced;
  displaced.Face = face;
  const HeightPlane plane(displaced, face);
  for (const dvec2& corner : plane.Corners)
  {
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y))
    {
      return FaceDeviations();
    }
  }
  if (data.IsFlat(face))
  {
    FlatSampler sampler{ plane, displaced, displaced.Scale };
    return data.Measure(face, pattern, sampler);
  }
  CurvedSampler sampler{ plane, displaced, data.Surface, data.Mesh.GetSurfaceFace(face), 0.0 };
  float& difference = data.Differences[face];
  if (difference < 0.0f)
  {
    difference = static_cast<float>(sampler.MeasureDifference());
  }
  sampler.Difference = difference;
  return data.Measure(face, pattern, sampler);
}
}
