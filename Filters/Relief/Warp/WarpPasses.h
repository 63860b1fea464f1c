// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpPasses
 * @brief   both passes of a warp, with one or several threads and bitwise identical results
 *
 * Private to the module.
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
    /// Each thread warps a band of rows to a separate image. The images are merged.
    Bands,
    /// Threads share the rows of the first pass, and then the columns of the second.
    RowsAndColumns
  };

  /// Allocates the memory for warps of a source. Warp() needs no other memory.
  void Allocate(const WarpSource& source, Policy way, int numberOfThreads);
  /// Warps the source. Does not throw.
  void Warp(const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture);

private:
  // The temporary data of a thread for consecutive rows.
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
