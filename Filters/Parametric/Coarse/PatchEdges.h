// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   edges of patches: borders with the same curve
 *
 * Private to the module.
 */
#ifndef PatchEdges_h
#define PatchEdges_h

#include "Cells/PatchEvaluation.h"

#include <array>
#include <vector>

namespace relevo
{
/// An edge for each distinct curve, in whichever direction its patches traverse it.
struct PatchEdge
{
  std::array<vtkIdType, 2> Ends; // merged points, the lower one first
  bool IsCollapsed;              // degenerates to a point
  int Pieces;                    // number of pieces to split it into, so that no other edge
                                 // connects its ends
  std::size_t Patch;             // one of its patches
  int Border;                    // the border of that patch
  bool IsReversed;               // whether this border starts at the end of the edge
};

struct PatchBorder
{
  int Edge;
  bool IsReversed;
};

struct PatchEdges
{
  std::vector<PatchEdge> Edges; // sorted by ends
  std::vector<std::array<PatchBorder, 4>> Borders;

  /// Whether an edge connects these merged points.
  bool AreJoined(const std::array<vtkIdType, 2>& ends) const;
};

/// The merged points of the corners of a patch.
using CornerPoints = std::array<vtkIdType, 4>;

/// Finds the edges. Control points are not multiplied by their weights. Edges are split into at
/// least `minimumPieces`.
PatchEdges FindPatchEdges(const std::vector<FacePatch>& patches, const ControlPoints& controlPoints,
  const std::vector<CornerPoints>& places, int minimumPieces);

/// Returns the curve from the first end to the second, homogeneous if `controlPoints` are.
ControlPoints GetCurve(
  const PatchEdge& edge, const std::vector<FacePatch>& patches, const ControlPoints& controlPoints);
}

#endif
