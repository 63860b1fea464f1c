// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/NormalSplits.h"

#include "Mesh/RefinementMesh.h"
#include "Surfaces/SurfaceCorners.h"

#include <algorithm>
#include <array>

namespace relevo
{
namespace
{
template <size_t N>
using Normals = std::array<vec3, N>;

vec3 evaluateNormal(
  vtkRefinementSurface* surface, const vtkRefinementSurface::Face& face, const vec3& weights)
{
  const float w[3] = { weights.x, weights.y, weights.z };
  float position[3];
  float normal[3];
  surface->Evaluate(face, w, position, normal);
  return unitVector(SurfaceCorners::load(normal));
}

// The different normals seen at places, each with the number of its copy.
template <size_t N>
class SeenNormals
{
public:
  explicit SeenNormals(size_t places)
    : First(places, -1)
  {
  }
  // The copy where these normals were seen before; else `fresh`, which is remembered.
  template <typename GetFresh>
  vtkIdType Find(size_t place, const Normals<N>& normals, const GetFresh& getFresh)
  {
    int* next = &this->First[place];
    while (*next >= 0)
    {
      const Seen& seen = this->All[static_cast<size_t>(*next)];
      if (AreSame(seen.Vectors, normals))
      {
        return seen.Copy;
      }
      next = &this->All[static_cast<size_t>(*next)].Next;
    }
    const bool isFirst = next == &this->First[place];
    *next = static_cast<int>(this->All.size());
    this->All.push_back({ normals, getFresh(isFirst), -1 });
    return this->All.back().Copy;
  }

private:
  struct Seen
  {
    Normals<N> Vectors;
    vtkIdType Copy;
    int Next;
  };
  static bool AreSame(const Normals<N>& a, const Normals<N>& b)
  {
    constexpr float rounding = 1e-5f;
    return std::equal(a.begin(), a.end(), b.begin(),
      [](const vec3& l, const vec3& r) { return dot(l - r, l - r) <= rounding * rounding; });
  }

  std::vector<int> First;
  std::vector<Seen> All;
};
}

NormalSplits::NormalSplits(
  RefinementMesh& mesh, vtkRefinementSurface* surface, vtkIdType numberOfPoints)
{
  mesh.BuildEdges();
  this->FaceEdges = mesh.FaceEdges;
  this->EdgeOwners = mesh.EdgeOwners;
  this->FaceCorners.reserve(3 * mesh.Faces.size());
  for (const RefinementFace& face : mesh.Faces)
  {
    this->FaceCorners.insert(this->FaceCorners.end(), face.Corners, face.Corners + 3);
  }
  std::vector<char> isSplitPoint(static_cast<size_t>(numberOfPoints), 0);
  std::vector<char> isSplitEdge(mesh.EdgeOwners.size(), 0);
  bool any = false;
  for (size_t f = 0; surface && f < mesh.Faces.size(); ++f)
  {
    if (surface->SplitsNormals(mesh.GetSurfaceFace(static_cast<int>(f))))
    {
      any = true;
      for (size_t i = 0; i < 3; ++i)
      {
        isSplitPoint[static_cast<size_t>(mesh.Faces[f].Corners[i])] = 1;
        isSplitEdge[static_cast<size_t>(mesh.FaceEdges[3 * f + i])] = 1;
      }
    }
  }
  if (any)
  {
    this->SplitCorners(mesh, surface, isSplitPoint, numberOfPoints);
    this->SplitEdges(mesh, surface, isSplitEdge);
  }
}

void NormalSplits::SplitCorners(const RefinementMesh& mesh, vtkRefinementSurface* surface,
  const std::vector<char>& isSplit, vtkIdType numberOfPoints)
{
  SeenNormals<1> seen(isSplit.size());
  for (size_t k = 0; k < this->FaceCorners.size(); ++k)
  {
    const vtkIdType point = this->FaceCorners[k];
    if (!isSplit[static_cast<size_t>(point)])
    {
      continue;
    }
    vec3 weights(0.0f);
    weights[static_cast<int>(k % 3)] = 1.0f;
    const vec3 normal =
      evaluateNormal(surface, mesh.GetSurfaceFace(static_cast<int>(k / 3)), weights);
    this->FaceCorners[k] = seen.Find(static_cast<size_t>(point), { { normal } },
      [&](bool isFirst) { return isFirst ? point : numberOfPoints + this->NumberOfCopies++; });
  }
}

void NormalSplits::SplitEdges(
  const RefinementMesh& mesh, vtkRefinementSurface* surface, const std::vector<char>& isSplit)
{
  SeenNormals<3> seen(isSplit.size());
  for (size_t k = 0; k < this->FaceEdges.size(); ++k)
  {
    const int edge = this->FaceEdges[k];
    if (!isSplit[static_cast<size_t>(edge)])
    {
      continue;
    }
    // A quadratic is given by three of its values.
    Normals<3> normals;
    const vtkRefinementSurface::Face face = mesh.GetSurfaceFace(static_cast<int>(k / 3));
    for (int step = 1; step <= 3; ++step)
    {
      vec3 weights(0.0f);
      weights[EdgeCorners[k % 3][0]] = 1.0f - 0.25f * static_cast<float>(step);
      weights[EdgeCorners[k % 3][1]] = 0.25f * static_cast<float>(step);
      normals[static_cast<size_t>(step) - 1] = evaluateNormal(surface, face, weights);
    }
    this->FaceEdges[k] = static_cast<int>(seen.Find(static_cast<size_t>(edge), normals,
      [&](bool isFirst)
      {
        if (isFirst)
        {
          return edge;
        }
        this->EdgeOwners.push_back(static_cast<int>(k));
        return static_cast<int>(this->EdgeOwners.size()) - 1;
      }));
  }
}
}
