// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightReduction
 * @brief   means of a raster's heights on a smaller grid over the same footprint
 *
 * Private to the module's own sources.
 */
#ifndef HeightReduction_h
#define HeightReduction_h

#include <functional>
#include <vector>

namespace relevo
{
/**
 * The size, in the same proportions, whose longer side is `maximum` texels; the size itself where
 * it is not larger, or where `maximum` is 0.
 */
void GetReducedSize(const int size[2], int maximum, int reduced[2]);

/**
 * Each height of the smaller grid is the mean of those with data that it covers, by the area that
 * it covers of each: nothing is shifted, raised or lowered. It has no data where it covers none.
 *
 * Rows come one after the other, so that memory is that of two rows of the result.
 */
class HeightReduction
{
public:
  /// `to` must not be larger than `from` along any side.
  HeightReduction(const int from[2], const int to[2]);

  /**
   * Along one row: to[0] sums of heights times widths, and these widths. `validity` may be nullptr;
   * heights without data must be 0. May be called for several rows at once.
   */
  void ReduceRow(
    const float* heights, const unsigned char* validity, double* sums, double* widths) const;

  /// Told each finished row of the result, from 0: to[0] sums and the areas to divide them by.
  using Sink = std::function<void(int row, const double* sums, const double* areas)>;

  /**
   * Takes what ReduceRow made of the next row.
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
