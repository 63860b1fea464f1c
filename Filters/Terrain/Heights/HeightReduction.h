// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightReduction
 * @brief   reduction of heights to a smaller grid of the same footprint
 *
 * Private to the module.
 */
#ifndef HeightReduction_h
#define HeightReduction_h

#include <functional>
#include <vector>

namespace relevo
{
/**
 * Computes the size of the same aspect ratio whose longer side has `maximum` texels. A size that is
 * not larger than `maximum` is unchanged, as is every size if `maximum` is 0.
 */
void GetReducedSize(const int size[2], int maximum, int reduced[2]);

/**
 * Each reduced height is the area-weighted mean of the valid heights that it covers. This neither
 * shifts the terrain nor changes its mean. A reduced height without valid heights has no data.
 *
 * Rows are processed in order, so that only two rows of the result are in memory.
 */
class HeightReduction
{
public:
  /// `to` must not be larger than `from` in either direction.
  HeightReduction(const int from[2], const int to[2]);

  /**
   * Reduces along one row: computes to[0] sums of heights times widths, and the sums of the widths.
   * `validity` may be nullptr. Heights without data must be 0. Can be called from several threads.
   */
  void ReduceRow(
    const float* heights, const unsigned char* validity, double* sums, double* widths) const;

  /// Receives each finished row of the result, starting at 0: to[0] sums, and the areas to divide
  /// them by.
  using Sink = std::function<void(int row, const double* sums, const double* areas)>;

  /**
   * Adds the result of ReduceRow() for the next row.
   */
  void AddRow(const double* sums, const double* widths, const Sink& sink);

private:
  void Accumulate(const double* sums, const double* widths, long long overlap);

  int From[2];
  int To[2];
  int NextRow = 0;
  std::vector<double> Sums;
  std::vector<double> Areas;
};
}

#endif
