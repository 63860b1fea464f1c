// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::PieceReduction
 * @brief   what the pieces of a surface have together, where several processes have one each
 *
 * Its functions are collective: all processes call the same ones in the same order, with as many
 * numbers, and all get the same result. This one knows of one piece, which is the whole.
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

  /// Become the sums over all pieces.
  virtual void Add(std::vector<double>& values) const { (void)values; }
  /// Become the largest of all pieces.
  virtual void TakeLargest(std::vector<double>& values) const { (void)values; }
  /// The values of all pieces, of any number each, those of the first process first.
  virtual std::vector<double> Collect(std::vector<double> values) const { return values; }
};
}

#endif
