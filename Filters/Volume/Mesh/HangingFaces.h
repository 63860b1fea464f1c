// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HangingFaces
 * @brief   faces that smaller faces of other cells cover, as next to refined cells
 *
 * Points of the smaller faces hang: they lie inside of edges and faces of the larger cells, up to
 * rounding errors of floats. All cells around an edge with hanging points must use its pieces, so
 * that rays next to it get into exactly one of them. Faces of which only a part is covered do not
 * count.
 *
 * Private to the modules.
 */
#ifndef HangingFaces_h
#define HangingFaces_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT HangingFaces
{
public:
  struct Cover
  {
    size_t Face;
    std::vector<size_t> Parts; // smaller faces
  };

  struct Mesh
  {
    /// Coincident points have the same id. The last corner of a triangle is -1.
    std::function<std::array<int, 4>(size_t)> GetFace;
    std::function<dvec3(int)> GetPoint;
    /// Returns a point inside the cell of a face.
    std::function<dvec3(size_t)> GetInside;
  };

  /// Searches faces that have no match, see MatchFaces().
  void Find(const Mesh& mesh, const std::vector<size_t>& border);

  bool IsEmpty() const { return this->Covers.empty(); }
  const std::vector<Cover>& GetCovers() const { return this->Covers; }
  /// Returns the points inside of an edge, from a to b.
  std::vector<int> GetPoints(int a, int b) const;

private:
  struct Surface;
  using Chain = std::vector<int>;

  void FindParts(const std::vector<Surface>& surfaces);
  void FindEdges(const Mesh& mesh, const std::vector<Surface>& surfaces);
  void AddPieces(const Chain& whole);
  Chain Expand(int a, int b, int level) const;

  std::vector<Cover> Covers;
  std::unordered_map<std::uint64_t, Chain> Edges; // from the lower to the higher id of the ends
};
}

#endif
