// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::PieceReduction
 * @brief   reductions over the pieces of a surface that is distributed over several processes
 *
 * The functions are collective: all processes call the same functions in the same order with the
 * same number of values, and all get the same result. This class is for a single piece, the whole
 * surface.
 */
#ifndef PieceReduction_h
#define PieceReduction_h

#include <vector> // for Collect()

namespace relevo
{
class PieceReduction
{
public:
  virtual ~PieceReduction() = default;

  virtual bool IsWhole() const { return true; }

  /// Replace the values by their sums over all pieces.
  virtual void Add(std::vector<double>& values) const { (void)values; }
  /// Replace the values by their maxima over all pieces.
  virtual void TakeLargest(std::vector<double>& values) const { (void)values; }
  /// Return the values of all pieces in the order of processes. Each piece may have any number.
  virtual std::vector<double> Collect(std::vector<double> values) const { return values; }
};
}

#endif
