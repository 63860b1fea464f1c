// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkFractal
 * @brief   a fractal terrain of any size, in whole meters
 *
 * Diamonds and squares (A. Fournier, D. Fussell and L. Carpenter, "Computer rendering of stochastic
 * models", 1982) in a square that repeats, times amplitudes that vary over larger distances, on
 * hills.
 */
#ifndef BenchmarkFractal_h
#define BenchmarkFractal_h

#include <array>
#include <vector>

class BenchmarkFractal
{
public:
  static constexpr int Period = 4096;
  /// UTM zone 33 north, as WKT.
  static const char* const CoordinateSystem;

  BenchmarkFractal();

  /// The samples of a rectangle, row by row.
  std::vector<short> GetSamples(std::array<int, 2> first, int width, int height) const;

private:
  float& At(int column, int row)
  {
    return this
      ->Square[static_cast<std::size_t>(row & (Period - 1)) * Period + (column & (Period - 1))];
  }
  void Divide(int step, float amplitude);

  std::vector<float> Square;
  unsigned Random = 1;
};

#endif
