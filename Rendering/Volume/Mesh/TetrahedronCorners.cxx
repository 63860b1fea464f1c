// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedronCorners.h"

#include "Mesh/CurvedRecords.h"
#include "Mesh/RayCastMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace relevo
{
namespace
{
// Spreads from faces whose points are known.
class CornerSearch
{
public:
  explicit CornerSearch(RayCastMesh& mesh)
    : Mesh(mesh)
    , IsKnown(mesh.GetNumberOfTetrahedra(), false)
  {
    mesh.Corners.resize(4 * mesh.GetNumberOfTetrahedra());
  }

  void AddFace(std::uint32_t cell, const std::array<std::uint32_t, 3>& face)
  {
    if (cell >= this->IsKnown.size() || this->IsKnown[cell])
    {
      return;
    }
    const std::uint32_t last = this->Mesh.PointSums[cell] ^ face[0] ^ face[1] ^ face[2];
    std::array<std::uint32_t, 4> corners = { { face[0], face[1], face[2], last } };
    std::sort(corners.begin(), corners.end());
    std::copy(
      corners.begin(), corners.end(), this->Mesh.Corners.begin() + 4 * static_cast<size_t>(cell));
    this->IsKnown[cell] = true;
    this->Open.push_back(cell);
    ++this->Count;
  }

  void Spread()
  {
    while (!this->Open.empty())
    {
      const size_t first = 4 * static_cast<size_t>(this->Open.back());
      this->Open.pop_back();
      const std::uint32_t* corners = &this->Mesh.Corners[first];
      for (size_t i = 0; i < 4; ++i)
      {
        this->AddFace(this->Mesh.Neighbors[first + i],
          { { corners[i == 0 ? 1 : 0], corners[i <= 1 ? 2 : 1], corners[i <= 2 ? 3 : 2] } });
      }
    }
  }

  bool IsComplete() const { return this->Count == this->IsKnown.size(); }

private:
  RayCastMesh& Mesh;
  std::vector<bool> IsKnown;
  std::vector<std::uint32_t> Open;
  size_t Count = 0;
};

void AddCurvedCells(const RayCastMesh& mesh, CornerSearch& search)
{
  for (size_t cell = 0; cell < mesh.GetNumberOfCurvedCells(); ++cell)
  {
    const std::uint32_t* words = &mesh.CurvedCells[RayCastMesh::WordsOfCurvedCell * cell];
    const bool isQuadratic = words[RayCastMesh::WordsOfCurvedCell - 1] == RayCastMesh::Quadratic;
    size_t behind = RayCastMesh::FirstNeighborWord;
    for (const std::array<int, 4>& face : GetRecordFaces(isQuadratic))
    {
      std::array<std::uint32_t, 4> corners;
      std::transform(
        face.begin(), face.end(), corners.begin(), [words](int i) { return words[i]; });
      std::sort(corners.begin(), corners.end());
      const auto end = std::unique(corners.begin(), corners.end());
      if (end - corners.begin() == 3)
      {
        search.AddFace(words[behind], { { corners[0], corners[1], corners[2] } });
      }
      ++behind;
    }
  }
}
}

bool FindTetrahedronCorners(RayCastMesh& mesh)
{
  CornerSearch search(mesh);
  for (size_t i = 0; i < mesh.BorderFaces.size(); i += 4)
  {
    const std::uint32_t* words = &mesh.BorderFaces[i];
    search.AddFace(words[3], { { words[0], words[1], words[2] } });
  }
  AddCurvedCells(mesh, search);
  search.Spread();
  if (!search.IsComplete())
  {
    mesh.Corners.clear();
  }
  return search.IsComplete();
}
}
