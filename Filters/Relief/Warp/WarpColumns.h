// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpColumns
 * @brief   the second pass of a warp: along columns, one row of the source after the other
 *
 * Private to the module's own sources.
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

  /// Columns from `first` to before `end`; `isJoined` tells of each position whether the surface
  /// there comes from the row before, and then from this row.
  void Warp(int row, const WarpRow& lower, const WarpRow& upper, const WarpStrip& strip,
    unsigned char* isJoined, int first, int end);
  /// The same for the last row.
  void WarpLast(int row, const WarpRow& lower, const unsigned char* isJoined, int first, int end);

private:
  // Where the surface crosses a side of a quad, or a sample.
  struct End
  {
    double Height;
    double Place;      // in the column
    float Fraction[2]; // of the column, of the row
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
