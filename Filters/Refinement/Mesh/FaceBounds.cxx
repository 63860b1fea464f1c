// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FaceBounds.h"

#include "Mesh/RefinementMesh.h"
#include "Surfaces/HeightRanges.h"
#include "vtkDisplacement.h"
#include "vtkMath.h"
#include "vtkRefinementSurface.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace relevo
{
namespace
{
void Reset(double low[3], double high[3])
{
  std::fill_n(low, 3, std::numeric_limits<double>::max());
  std::fill_n(high, 3, std::numeric_limits<double>::lowest());
}

void Extend(const float* v, double low[3], double high[3])
{
  for (int c = 0; c < 3; ++c)
  {
    low[c] = std::min<double>(low[c], v[c]);
    high[c] = std::max<double>(high[c], v[c]);
  }
}
}

FaceBounds::FaceBounds(const RefinementMesh& mesh, vtkRefinementSurface* surface,
  vtkDisplacement* displacement, const HeightRanges* heights)
  : Mesh(mesh)
  , Surface(surface)
  , Directions(mesh.Directions.empty() ? mesh.Normals : mesh.Directions)
  , Heights(mesh.TextureCoordinates.empty() ? nullptr : heights)
{
  if (displacement)
  {
    this->Scale = displacement->GetScale();
    this->Offset = displacement->GetOffset();
    displacement->GetReach(this->Reach);
    displacement->GetDirection(this->Fixed);
    this->AlongNormal = displacement->IsAlongNormal();
  }
  if (surface)
  {
    this->EdgePositions = surface->GetNumberOfEdgePositions();
    this->FacePositions = surface->GetNumberOfFacePositions();
    this->SurfaceReach = surface->GetReach();
    this->KnowsNormals =
      !surface->HasDirections() && (!mesh.Directions.empty() || surface->HasInterpolatedNormals());
  }
}

const float* FaceBounds::GetVectors(std::size_t face) const
{
  return this->Mesh.Vectors.empty()
    ? nullptr
    : &this->Mesh.Vectors[3 * static_cast<std::size_t>(this->Mesh.VectorsPerFace) * face];
}

// Gets the smallest and largest displacement of a face's points.
void FaceBounds::GetReach(std::size_t face, double reach[2]) const
{
  std::copy_n(this->Reach, 2, reach);
  if (!this->Heights)
  {
    return;
  }
  vec2 low(std::numeric_limits<float>::max());
  vec2 high(std::numeric_limits<float>::lowest());
  const auto extend = [&](int point)
  {
    const float* uv = &this->Mesh.TextureCoordinates[2 * static_cast<std::size_t>(point)];
    low = min(low, vec2(uv[0], uv[1]));
    high = max(high, vec2(uv[0], uv[1]));
  };
  std::for_each_n(this->Mesh.Faces[face].Corners, 3, extend);
  if (!this->Mesh.Seams.empty())
  {
    std::for_each_n(&this->Mesh.Seams[9 * face], 9, extend);
  }
  float range[2];
  this->Heights->GetRange(low, high, range);
  const double ends[2] = { this->Offset + this->Scale * range[0],
    this->Offset + this->Scale * range[1] };
  reach[0] = std::min(ends[0], ends[1]);
  reach[1] = std::max(ends[0], ends[1]);
}

// Gets the smallest and largest component of the directions in which a face's points can move.
void FaceBounds::GetMoves(std::size_t face, double moves[3][2]) const
{
  if (!this->AlongNormal)
  {
    for (int c = 0; c < 3; ++c)
    {
      moves[c][0] = moves[c][1] = this->Fixed[c];
    }
    return;
  }
  if (!this->KnowsNormals)
  {
    for (int c = 0; c < 3; ++c)
    {
      moves[c][0] = -1.0;
      moves[c][1] = 1.0;
    }
    return;
  }
  // Normals are normalised convex combinations of these vectors. Their components are at most those
  // of the vectors, divided by the smallest length of a combination.
  std::vector<const float*> normals;
  for (int corner : this->Mesh.Faces[face].Corners)
  {
    normals.push_back(&this->Directions[3 * static_cast<std::size_t>(corner)]);
  }
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int k = this->EdgePositions; k < this->Mesh.VectorsPerEdge; ++k)
    {
      normals.push_back(this->GetVectors(face) + 3 * (edge * this->Mesh.VectorsPerEdge + k));
    }
  }
  for (int k = 3 * this->Mesh.VectorsPerEdge + this->FacePositions; k < this->Mesh.VectorsPerFace;
       ++k)
  {
    normals.push_back(this->GetVectors(face) + 3 * k);
  }
  double low[3];
  double high[3];
  Reset(low, high);
  double mean[3] = { 0.0, 0.0, 0.0 };
  for (const float* normal : normals)
  {
    Extend(normal, low, high);
    std::transform(mean, mean + 3, normal, mean, std::plus<double>());
  }
  vtkMath::Normalize(mean);
  double least = 1.0;
  for (const float* normal : normals)
  {
    least = std::min(least, std::inner_product(mean, mean + 3, normal, 0.0));
  }
  for (int c = 0; c < 3; ++c)
  {
    const bool bounded = least > 0.0;
    moves[c][0] = bounded ? std::max(-1.0, low[c] / (low[c] < 0.0 ? least : 1.0)) : -1.0;
    moves[c][1] = bounded ? std::min(1.0, high[c] / (high[c] > 0.0 ? least : 1.0)) : 1.0;
  }
}

void FaceBounds::GetBox(std::size_t face, double low[3], double high[3]) const
{
  const float* vectors = this->GetVectors(face);
  Reset(low, high);
  for (int corner : this->Mesh.Faces[face].Corners)
  {
    Extend(&this->Mesh.Points[3 * static_cast<std::size_t>(corner)], low, high);
  }
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int k = 0; k < this->EdgePositions; ++k)
    {
      Extend(vectors + 3 * (edge * this->Mesh.VectorsPerEdge + k), low, high);
    }
  }
  for (int k = 0; k < this->FacePositions; ++k)
  {
    Extend(vectors + 3 * (3 * this->Mesh.VectorsPerEdge + k), low, high);
  }
  if (this->Surface)
  {
    this->Surface->ExtendBox(this->Mesh.GetSurfaceFace(static_cast<int>(face)), low, high);
  }
  for (int c = 0; c < 3; ++c)
  {
    low[c] -= this->SurfaceReach;
    high[c] += this->SurfaceReach;
  }
  double reach[2];
  this->GetReach(face, reach);
  if (reach[0] == 0.0 && reach[1] == 0.0)
  {
    return;
  }
  double moves[3][2];
  this->GetMoves(face, moves);
  for (int c = 0; c < 3; ++c)
  {
    const double products[4] = { reach[0] * moves[c][0], reach[0] * moves[c][1],
      reach[1] * moves[c][0], reach[1] * moves[c][1] };
    low[c] += *std::min_element(products, products + 4);
    high[c] += *std::max_element(products, products + 4);
  }
}

void ComputeBounds(const RefinementMesh& mesh, vtkRefinementSurface* surface,
  vtkDisplacement* displacement, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  const FaceBounds faceBounds(mesh, surface, displacement);
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    double low[3];
    double high[3];
    faceBounds.GetBox(f, low, high);
    for (int c = 0; c < 3; ++c)
    {
      bounds[2 * c] = f == 0 ? low[c] : std::min(bounds[2 * c], low[c]);
      bounds[2 * c + 1] = f == 0 ? high[c] : std::max(bounds[2 * c + 1], high[c]);
    }
  }
  for (int c = 0; c < 3 && !mesh.Faces.empty(); ++c)
  {
    bounds[2 * c] += mesh.Origin[c];
    bounds[2 * c + 1] += mesh.Origin[c];
  }
}
}
