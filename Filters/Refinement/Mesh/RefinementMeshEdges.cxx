// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Edges of a mesh to be refined, and what is computed per edge.
#include "Mesh/RefinementMesh.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <set>
#include <utility>

namespace relevo
{
namespace
{
// The numbers 0 to n - 1 in the order of their keys (arrays of ints); equal keys keep theirs.
// Counts by the keys' first elements, which are below `limit`: few share each.
template <typename GetKey>
std::vector<int> sortByKey(size_t n, int limit, const GetKey& getKey)
{
  std::vector<int> starts(static_cast<size_t>(limit) + 1, 0);
  for (size_t i = 0; i < n; ++i)
  {
    ++starts[getKey(static_cast<int>(i))[0] + 1];
  }
  for (int k = 0; k < limit; ++k)
  {
    starts[k + 1] += starts[k];
  }
  std::vector<int> sorted(n);
  std::vector<int> next(starts.begin(), starts.end() - 1);
  for (size_t i = 0; i < n; ++i)
  {
    sorted[next[getKey(static_cast<int>(i))[0]]++] = static_cast<int>(i);
  }
  vtkSMPTools::For(0, limit,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        std::sort(sorted.begin() + starts[k], sorted.begin() + starts[k + 1],
          [&getKey](int l, int r)
          { return std::make_pair(getKey(l), l) < std::make_pair(getKey(r), r); });
      }
    });
  return sorted;
}
}

void RefinementMesh::DropLoneFaces()
{
  const auto getPlaces = [this](const RefinementFace& face) -> std::array<int, 3>
  {
    return { this->GetPlace(face.Corners[0]), this->GetPlace(face.Corners[1]),
      this->GetPlace(face.Corners[2]) };
  };
  // Sorted: those at one place follow one another.
  const auto isCollapsed = [&](const RefinementFace& face)
  {
    const std::array<int, 3> places = getPlaces(face);
    return places[0] == places[1] || places[1] == places[2];
  };
  if (std::none_of(this->Faces.begin(), this->Faces.end(), isCollapsed))
  {
    return;
  }
  std::set<std::pair<int, int>> sides;
  for (const RefinementFace& face : this->Faces)
  {
    const std::array<int, 3> places = getPlaces(face);
    for (int e = 0; !isCollapsed(face) && e < 3; ++e)
    {
      sides.emplace(places[EdgeCorners[e][0]], places[EdgeCorners[e][1]]);
    }
  }
  const auto isLone = [&](const RefinementFace& face)
  {
    const std::array<int, 3> places = getPlaces(face);
    return isCollapsed(face) && sides.count({ places[0], places[2] }) == 0;
  };
  const auto kept = std::remove_if(this->Faces.begin(), this->Faces.end(), isLone);
  this->NumberOfDroppedTriangles += this->Faces.end() - kept;
  this->Faces.erase(kept, this->Faces.end());
}

void RefinementMesh::BuildPlaceEdges()
{
  using Key = std::array<int, 4>; // places, points
  const auto getKey = [this](int faceEdge)
  {
    const int* corners = this->Faces[faceEdge / 3].Corners;
    const int a = corners[EdgeCorners[faceEdge % 3][0]];
    const int b = corners[EdgeCorners[faceEdge % 3][1]];
    return Key{ { this->GetPlace(a), this->GetPlace(b), a, b } };
  };
  const std::vector<int> sorted = sortByKey(3 * this->Faces.size(), this->NumberOfPoints, getKey);
  this->FacePlaceEdges.resize(sorted.size());
  this->PlaceEdgeOffsets.clear();
  this->PlaceEdgePairs.clear();
  Key previous{ { -1, -1, -1, -1 } };
  for (int faceEdge : sorted)
  {
    const Key key = getKey(faceEdge);
    if (key[0] != previous[0] || key[1] != previous[1])
    {
      this->PlaceEdgeOffsets.push_back(static_cast<int>(this->PlaceEdgePairs.size()));
    }
    if (key != previous)
    {
      this->PlaceEdgePairs.push_back({ { key[2], key[3] } });
    }
    this->FacePlaceEdges[faceEdge] = static_cast<int>(this->PlaceEdgeOffsets.size()) - 1;
    previous = key;
  }
  this->PlaceEdgeOffsets.push_back(static_cast<int>(this->PlaceEdgePairs.size()));
}

void RefinementMesh::BuildSeams()
{
  // The lowest point of each place that a face uses.
  std::vector<int> first(static_cast<size_t>(this->NumberOfPoints), this->NumberOfPoints);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      int& lowest = first[static_cast<size_t>(this->GetPlace(corner))];
      lowest = std::min(lowest, corner);
    }
  }
  this->Seams.resize(9 * this->Faces.size());
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int edge = this->FacePlaceEdges[3 * f + i];
      const auto& pair = this->PlaceEdgePairs[this->PlaceEdgeOffsets[edge]];
      this->Seams[9 * f + i] =
        first[static_cast<size_t>(this->GetPlace(this->Faces[f].Corners[i]))];
      this->Seams[9 * f + 3 + i] = pair[0];
      this->Seams[9 * f + 6 + i] = pair[1];
    }
  }
}

void RefinementMesh::BuildVectors(vtkRefinementSurface* surface)
{
  const int positions = surface->GetNumberOfEdgePositions();
  this->VectorsPerEdge = positions + surface->GetNumberOfEdgeNormals();
  this->VectorsPerFace = 3 * this->VectorsPerEdge + surface->GetNumberOfFacePositions() +
    surface->GetNumberOfFaceNormals();
  this->Vectors.assign(3 * static_cast<size_t>(this->VectorsPerFace) * this->Faces.size(), 0.0f);
  if (this->Vectors.empty())
  {
    return;
  }
  auto getCorner = [this](int point)
  {
    const size_t id = static_cast<size_t>(point);
    return vtkRefinementSurface::Corner{ &this->Points[3 * id],
      this->Normals.empty() ? nullptr : &this->Normals[3 * id], this->GetValues(point) };
  };
  auto computeEdge = [&](int a, int b, float* vectors)
  { surface->ComputeEdgeVectors(getCorner(a), getCorner(b), vectors); };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> other(3 * static_cast<size_t>(this->VectorsPerEdge));
      for (vtkIdType f = begin; f < end; ++f)
      {
        const RefinementFace& face = this->Faces[f];
        float* vectors = &this->Vectors[3 * static_cast<size_t>(this->VectorsPerFace) * f];
        float* edgeNormals[3];
        for (int i = 0; i < 3; ++i)
        {
          float* edge = vectors + 3 * i * this->VectorsPerEdge;
          edgeNormals[i] = edge + 3 * positions;
          computeEdge(face.Corners[EdgeCorners[i][0]], face.Corners[EdgeCorners[i][1]], edge);
          if (this->FacePlaceEdges.empty())
          {
            continue;
          }
          const int id = this->FacePlaceEdges[3 * f + i];
          const int pairs = this->PlaceEdgeOffsets[id + 1] - this->PlaceEdgeOffsets[id];
          if (pairs > 1)
          {
            // The mean over all sides, summed in the same order by each of them.
            std::fill_n(edge, 3 * positions, 0.0f);
            for (int k = 0; k < pairs; ++k)
            {
              const auto& pair = this->PlaceEdgePairs[this->PlaceEdgeOffsets[id] + k];
              computeEdge(pair[0], pair[1], other.data());
              for (int c = 0; c < 3 * positions; ++c)
              {
                edge[c] += other[c] / static_cast<float>(pairs);
              }
            }
          }
        }
        surface->ComputeFaceVectors(this->GetSurfaceFace(static_cast<int>(f)),
          vectors + 9 * this->VectorsPerEdge, edgeNormals);
      }
    });
}

void RefinementMesh::BuildEdges()
{
  using Key = std::array<int, 2>;
  const auto getKey = [this](int faceEdge)
  {
    const int* corners = this->Faces[faceEdge / 3].Corners;
    const int a = corners[EdgeCorners[faceEdge % 3][0]];
    const int b = corners[EdgeCorners[faceEdge % 3][1]];
    return Key{ { std::min(a, b), std::max(a, b) } };
  };
  const std::vector<int> sorted = sortByKey(3 * this->Faces.size(), this->NumberOfPoints, getKey);
  this->FaceEdges.resize(sorted.size());
  this->EdgeOwners.clear();
  Key previous{ { -1, -1 } };
  for (int faceEdge : sorted)
  {
    const Key key = getKey(faceEdge);
    if (key != previous)
    {
      this->EdgeOwners.push_back(faceEdge);
      previous = key;
    }
    this->FaceEdges[faceEdge] = static_cast<int>(this->EdgeOwners.size()) - 1;
  }
}
}
