// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpPasses
 * @brief   both passes of a warp, in one thread or several, with the same result to the bit
 *
 * Private to the module's own sources.
 */
#ifndef WarpPasses_h
#define WarpPasses_h

#include "Warp/WarpCoefficients.h"
#include "Warp/WarpPicture.h"
#include "Warp/WarpRow.h"

#include <functional>
#include <vector>

namespace relevo
{
class WarpSource;

class WarpPasses
{
public:
  enum class Policy
  {
    OneThread,
    /// Each thread has a band of the source's rows and a picture, which are then merged.
    Bands,
    /// Threads share the rows of the first pass, then the columns of the second.
    RowsAndColumns
  };

  /// Memory for warps of a source; the only one to need some.
  void Allocate(const WarpSource& source, Policy way, int numberOfThreads);
  /// Does not wait, and throws nothing.
  void Warp(const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture);

private:
  // What a thread needs for rows one after the other.
  struct Band
  {
    WarpRow Rows[2];
    WarpStrip Strip;
    std::vector<unsigned char> IsJoined;
    WarpPicture Picture;
  };

  void WarpRows(const WarpSource& source, const WarpCoefficients& coefficients,
    WarpPicture& picture, Band& band, int first, int end);
  void WarpBands(
    const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture);
  void WarpRowsAndColumns(
    const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture);
  void RunAll(int number, int step, const std::function<void(int first, int end)>& work) const;

  Policy ThePolicy = Policy::OneThread;
  int NumberOfThreads = 1;
  std::vector<Band> Bands;
  std::vector<WarpRow> Rows;
  std::vector<WarpStrip> Strips;
  std::vector<unsigned char> IsJoined;
};
}

#endif
