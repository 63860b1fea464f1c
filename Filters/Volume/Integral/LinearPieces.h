// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LinearPieces
 * @brief   a piecewise linear function of one variable, possibly discontinuous
 *
 * The function is constant below the first node and above the last. At a node, it has the value of
 * the piece below it, as in VTK's functions.
 *
 * Private to the module.
 */
#ifndef LinearPieces_h
#define LinearPieces_h

#include "Integral/LinearSegment.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <functional> // for the function
#include <vector>     // for members

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT LinearPieces
{
public:
  using Function = std::function<dvec4(double)>;

  LinearPieces() = default;
  /**
   * Approximates a function. `kinks` contains the positions where it may have kinks or jumps, in
   * any order. Intervals between them are halved until the error is within the tolerance.
   */
  LinearPieces(const Function& function, std::vector<double> kinks, double tolerance);

  /// Returns the positions where pieces meet, in ascending order.
  const std::vector<double>& GetNodes() const { return this->Nodes; }

  /// Returns the index of the piece at x: 0 up to the first node, 1 up to the second, and so on.
  size_t FindPiece(double x) const;

  /// Evaluates a piece at x, which may be at an end of the piece or outside of it.
  dvec4 Evaluate(size_t piece, double x) const;

private:
  struct Ends
  {
    dvec4 First;
    dvec4 Last;
  };
  void Split(const Function& function, double begin, double end, const Ends& ends, double tolerance,
    int depth);

  std::vector<double> Nodes;
  std::vector<Ends> Pieces; // one more than nodes, if there are nodes
};
}

#endif
