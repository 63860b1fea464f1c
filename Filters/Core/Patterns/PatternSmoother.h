// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternSmoother
 * @brief   increases the smallest angles around the inner points of a triangulation
 *
 * Each point moves to the position where the worst triangle of its star is best (optimization-based
 * smoothing, Freitag and Ollivier-Gooch 1997). A pattern search on the grid of inner points finds
 * it.
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
  /// Vertices before the first inner one are on the border and do not move.
  PatternSmoother(PatternTriangulation& mesh, int firstInner);

  /// Move points until there is no improvement.
  void Move();

  /// Find inner points whose removal would improve the triangles around them. No two are
  /// neighbours.
  std::vector<bool> FindSuperfluousPoints();

private:
  double StarBadness(PatternPoint p, double limit) const;
  bool IsSuperfluous(int vertex) const;
  bool MoveVertex(int vertex);

  PatternTriangulation& Mesh;
  int FirstInner;
  std::vector<std::pair<int, int>> Star; // of the current vertex
};
}

#endif
