// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceMatch
 * @brief   finds the faces of a coarse mesh that an earlier coarse mesh of the same input has
 */
#ifndef FaceMatch_h
#define FaceMatch_h

#include "Encoding/BaseMesh.h"

#include <algorithm> // for std::sort
#include <array>     // for members
#include <utility>   // for std::pair
#include <vector>    // for members

namespace relevo
{
class FaceMatch
{
public:
  explicit FaceMatch(const BaseMesh& base)
  {
    this->Faces.reserve(base.Mesh.Faces.size());
    for (const MicroMesh::Face& face : base.Mesh.Faces)
    {
      this->Faces.emplace_back(GetVertices(base, face), static_cast<int>(this->Faces.size()));
    }
    std::sort(this->Faces.begin(), this->Faces.end());
  }

  /// The face with the same vertices of the dense mesh in the same order, or -1.
  int Find(const BaseMesh& base, const MicroMesh::Face& face) const
  {
    const Vertices vertices = GetVertices(base, face);
    const auto found =
      std::lower_bound(this->Faces.begin(), this->Faces.end(), std::make_pair(vertices, -1));
    return found != this->Faces.end() && found->first == vertices ? found->second : -1;
  }

private:
  using Vertices = std::array<int, 3>;
  static Vertices GetVertices(const BaseMesh& base, const MicroMesh::Face& face)
  {
    Vertices vertices{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      vertices[c] = base.Vertices[static_cast<std::size_t>(face.Corners[c])];
    }
    return vertices;
  }

  std::vector<std::pair<Vertices, int>> Faces;
};
}

#endif
