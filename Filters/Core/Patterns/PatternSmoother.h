// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternSmoother
 * @brief   makes the smallest angles around the inner points of a triangulation larger
 *
 * A point moves to where the worst triangle of its star is best (optimization-based smoothing,
 * Freitag and Ollivier-Gooch 1997), found by a pattern search on the grid of the inner points.
 *
 * Private to the module's own sources.
 */
#ifndef PatternSmoother_h
#define PatternSmoother_h

#include "Patterns/PatternTriangulation.h"

#include <utility>
#include <vector>

namespace relevo
{
class PatternSmoother
{
public:
  /// Vertices before the first inner one are of the border and stay.
  PatternSmoother(PatternTriangulation& mesh, int firstInner);

  /// Move points for as long as it helps.
  void Move();

  /// Inner points without which the triangles around them would be better; no two are neighbours.
  std::vector<bool> FindErrors();

private:
  double StarBadness(PatternPoint p, double limit) const;
  bool IsError(int vertex) const;
  bool MoveVertex(int vertex);

  PatternTriangulation& Mesh;
  int FirstInner;
  std::vector<std::pair<int, int>> Star; // of the vertex at hand
};
}

#endif
