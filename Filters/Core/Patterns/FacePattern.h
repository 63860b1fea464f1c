// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  FacePattern
 * @brief   the pattern of a face and its orientation
 */
#ifndef FacePattern_h
#define FacePattern_h

#include "RelevoFiltersCoreModule.h" // for export macro

namespace relevo
{
struct RefinementPattern;
struct RELEVOFILTERSCORE_EXPORT FacePattern
{
  const RefinementPattern* Pattern;
  /// The permutation from the pattern's vertices to the face's sorted corners (relevoWeights.glsl).
  int Code;
  /// Whether the pattern's triangles are reversed.
  bool Mirrored;
  /// Tags of the sorted edges (0,1), (1,2), (0,2) for morphing vertices, or nullptr.
  const float* MorphTags;

  /// Get the weights of the face's sorted corners at a vertex of the pattern.
  void GetWeights(int vertex, float weights[3]) const;

  /// Get the segments of the face's sorted edges (0,1), (1,2), (0,2).
  void GetEdgeSegments(int segments[3]) const;
};
}

#endif
