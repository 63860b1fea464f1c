// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   first pass of a warp: along rows, and the connections between two rows
 *
 * Private to the module.
 */
#ifndef WarpRow_h
#define WarpRow_h

#include <cmath>
#include <vector>

namespace relevo
{
class WarpSource;
struct WarpCoefficients;

/// Rounds up a number in the range of int.
inline int CeilToInt(double value)
{
  const int whole = static_cast<int>(value);
  return whole + (value > whole ? 1 : 0);
}

/// The integers in [lowest, highest) and [first, end).
struct WholeNumbers
{
  WholeNumbers(double lowest, double highest, int first, int end)
    : First(lowest > first ? (lowest < end ? CeilToInt(lowest) : end) : first)
    , End(highest < end ? (highest > first ? CeilToInt(highest) : first) : end)
  {
  }
  int First;
  int End;
};

/**
 * Returns the fraction of a point on a segment. `first` and `second` are its distances from both
 * ends in the plane of the relief, the weights are 1 + K3 h at the ends.
 */
inline double FindFraction(double first, double second, double firstWeight, double secondWeight)
{
  const double here = firstWeight * first;
  const double there = secondWeight * second;
  return here == 0.0 ? 0.0 : here / (here + there);
}

/// A row after the first pass.
struct WarpRow
{
  struct Sample
  {
    double Height;
    int Column; // of the source; -1 without surface
    float Fraction;

    bool IsValid() const { return this->Column >= 0; }
    bool IsAtColumn() const { return this->Fraction == 0.0f; }
    /// Returns the first column that is not left of the point.
    int GetNextColumn() const { return this->Column + (this->IsAtColumn() ? 0 : 1); }
  };

  std::vector<double> Columns;       // positions of the texels; NaN if not visible
  std::vector<Sample> Samples;       // nearest surface at each integer position
  std::vector<double> Rows;          // positions of the samples in the second pass
  std::vector<unsigned char> Folded; // whether the surface passes a position more than once

  void Allocate(int width);
  void Warp(const WarpSource& source, const WarpCoefficients& coefficients, int row);

private:
  void FindColumns(const double* heights, const WarpCoefficients& coefficients);
  void FindSamples(const WarpSource& source, const WarpCoefficients& coefficients, int row);
  void FindRows(const WarpCoefficients& coefficients, int row);
  void Join(const WarpSource& source, const WarpCoefficients& coefficients, const double* heights,
    int column);
  void End(const WarpSource& source, double height, int column, bool isJoined[2]);
  void Put(const WarpSource& source, int position, const Sample& sample);
};

/// The surface between a row and the next.
struct WarpStrip
{
  std::vector<unsigned char> Quads; // whether the surface between four texels is visible
  /// Positions where the surface passes a row more than once or has an open side. Here, connecting
  /// the samples of both rows is not sufficient.
  std::vector<unsigned char> Folded;
  int FirstFolded = 0;
  int EndFolded = 0;

  void Allocate(int width);
  void Compare(const WarpSource& source, int row, const WarpRow& lower, const WarpRow& upper);
  bool AreJoined(const WarpSource& source, int row, const WarpRow& lower, const WarpRow& upper,
    int position) const;

private:
  void Open(double first, double second);
};
}

#endif
