// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/VisibleIntervals.h"

#include <limits>

namespace relevo
{
bool IsTransparent(const LinearPieces& pieces, size_t piece)
{
  const std::vector<double>& nodes = pieces.GetNodes();
  const double begin = nodes[piece == 0 ? 0 : piece - 1];
  const double end = nodes[piece == nodes.size() ? piece - 1 : piece];
  return !(pieces.Evaluate(piece, begin).w > 0.0) && !(pieces.Evaluate(piece, end).w > 0.0);
}

std::vector<ActiveCells::Interval> FindVisibleIntervals(
  const LinearPieces& pieces, double low, double size)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double>& nodes = pieces.GetNodes();
  std::vector<ActiveCells::Interval> intervals;
  bool wasVisible = false;
  for (size_t piece = 0; piece <= nodes.size() && !nodes.empty(); ++piece)
  {
    const bool isVisible = !IsTransparent(pieces, piece);
    const double begin = piece == 0 ? -infinity : (nodes[piece - 1] - low) / size;
    const double end = piece == nodes.size() ? infinity : (nodes[piece] - low) / size;
    if (isVisible && !wasVisible)
    {
      intervals.push_back({ { static_cast<float>(begin), static_cast<float>(end) } });
    }
    else if (isVisible)
    {
      intervals.back()[1] = static_cast<float>(end);
    }
    wasVisible = isVisible;
  }
  return intervals;
}
}
