// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpColumns
 * @brief   second pass of a warp: along columns, for one row of the source after the other
 *
 * Private to the module.
 */
#ifndef WarpColumns_h
#define WarpColumns_h

#include "Warp/WarpCoefficients.h"
#include "Warp/WarpPicture.h"
#include "Warp/WarpRow.h"

#include <vector>

namespace relevo
{
class WarpSource;

class WarpColumns
{
public:
  WarpColumns(const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture);

  /// Warps the columns [first, end). For each position, `isJoined` is whether the surface continues
  /// from the previous row, and returns whether it continues to the next.
  void Warp(int row, const WarpRow& lower, const WarpRow& upper, const WarpStrip& strip,
    unsigned char* isJoined, int first, int end);
  /// Warps the last row.
  void WarpLast(int row, const WarpRow& lower, const unsigned char* isJoined, int first, int end);

private:
  // The intersection of the surface with a side of a quad, or a sample.
  struct End
  {
    double Height;
    double Place;      // position in the column
    float Fraction[2]; // between columns, and between rows
  };

  void Join(int row, int position, const WarpRow& lower, const WarpRow& upper);
  void DrawEnd(int row, int position, const WarpRow& lower, double other);
  void WarpFolds(int row, const WarpRow& lower, const WarpRow& upper, const WarpStrip& strip,
    int first, int end);
  void Cut(int row, int column, int position, const double corners[4]);
  End Cross(int row, int column, int position, const double corners[4], int from, int to) const;
  void Fill(int row, int column, int position, const End& first, const End& second);
  double GetWeight(double height) const;

  const WarpSource& Source;
  const WarpCoefficients Coefficients;
  WarpPicture& Picture;
};
}

#endif
