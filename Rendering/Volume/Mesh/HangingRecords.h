// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HangingRecords
 * @brief   lists of the cells behind a face, and of the points on the edges of a cell
 *
 * The lists follow the records of curved cells. Their addresses are numbers of blocks of four words
 * from the first record.
 *
 * Private to the modules' own sources.
 */
#ifndef HangingRecords_h
#define HangingRecords_h

#include "Mesh/HangingFaces.h"

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace relevo
{
class HangingRecords
{
public:
  /// Lists are appended to `words`. `places` has the first of the coincident points of each point;
  /// it is empty if no points coincide.
  HangingRecords(
    const HangingFaces& faces, const std::vector<int>& places, std::vector<std::uint32_t>& words);

  /// Return whether there are points on an edge of a tetrahedron.
  bool HasPoints(const std::array<std::uint32_t, 4>& tetrahedron) const;
  /// Add the list of a hexahedron's edges, and return its address; 0 if no edge has points. The
  /// list has the address of the list of each edge, or 0. The latter has the number of points, and
  /// the points in the direction of GetRecordEdge().
  std::uint32_t AddEdges(const std::array<std::uint32_t, 8>& corners);

  /// A smaller face behind a face. The corners are in order as seen from the larger cell.
  struct Part
  {
    std::uint32_t Neighbor; // as in RayCastMesh::Neighbors
    std::vector<int> Corners;
  };
  /// Add the list of the cells behind a face: the number of parts, and for each part the neighbour,
  /// the number of points of its border, and the points.
  std::uint32_t AddParts(const std::vector<Part>& parts);

private:
  int GetPlace(std::uint32_t point) const;
  std::vector<int> GetPoints(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t Append(const std::vector<std::uint32_t>& list);

  const HangingFaces& Faces;
  const std::vector<int>& Places;
  std::vector<std::uint32_t>& Words;
};
}

#endif
