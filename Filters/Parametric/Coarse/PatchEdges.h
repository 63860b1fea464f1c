// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the edges of patches: borders that are the same curve
 *
 * Private to the module's own sources.
 */
#ifndef PatchEdges_h
#define PatchEdges_h

#include "Cells/PatchEvaluation.h"

#include <array>
#include <vector>

namespace relevo
{
/// One for each curve, whichever way round its patches have it.
struct PatchEdge
{
  std::array<vtkIdType, 2> Ends; // places, the lower one first
  bool IsCollapsed;              // one place, all of it
  int Pieces;                    // that it has to be split in, so that no other joins its ends
  std::size_t Patch;             // one that has it
  int Border;                    // there
  bool IsReversed;               // this border starts at the edge's end
};

struct PatchBorder
{
  int Edge;
  bool IsReversed;
};

struct PatchEdges
{
  std::vector<PatchEdge> Edges; // by their ends
  std::vector<std::array<PatchBorder, 4>> Borders;

  /// Whether an edge joins these places.
  bool AreJoined(const std::array<vtkIdType, 2>& ends) const;
};

/// The places of a patch's corners, by number.
using CornerPoints = std::array<vtkIdType, 4>;

/// Control points are not multiplied with their weights. Edges are split in `minimumPieces` or
/// more.
PatchEdges FindPatchEdges(const std::vector<FacePatch>& patches, const ControlPoints& controlPoints,
  const std::vector<CornerPoints>& places, int minimumPieces);

/// From its first end to its second; of homogeneous points, if these are.
ControlPoints GetCurve(
  const PatchEdge& edge, const std::vector<FacePatch>& patches, const ControlPoints& controlPoints);
}

#endif
