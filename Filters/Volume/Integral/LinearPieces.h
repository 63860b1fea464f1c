// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LinearPieces
 * @brief   a function of one variable in linear pieces, which may jump where they meet
 *
 * Below its first node and above the last the function is constant. At a node holds the piece
 * before it, as in VTK's functions.
 *
 * Private to the module's own sources.
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
   * `kinks`: where the function may bend or jump, in any order. Between them it is cut in halves
   * until the pieces are nowhere farther from it than the tolerance.
   */
  LinearPieces(const Function& function, std::vector<double> kinks, double tolerance);

  /// Where pieces meet, in ascending order.
  const std::vector<double>& GetNodes() const { return this->Nodes; }

  /// 0 up to the first node, 1 up to the second, and so on.
  size_t FindPiece(double x) const;

  /// At x, by a piece that x need not be in, but may be at an end of.
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
