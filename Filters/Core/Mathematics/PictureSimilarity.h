// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the structural similarity index of pictures
 *
 * Wang, Bovik, Sheikh and Simoncelli, Image Quality Assessment: From Error Visibility to Structural
 * Similarity, 2004, equation 13.
 */
#ifndef PictureSimilarity_h
#define PictureSimilarity_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <cstddef> // for size_t
#include <vector>  // for pictures

namespace relevo
{
/// Moments of two windows with grey values from 0 to 1.
class RELEVOFILTERSCORE_EXPORT WindowSimilarity
{
public:
  void Add(double a, double b);
  /// Returns 1 for equal windows.
  double Get() const;

private:
  std::size_t Count = 0;
  double SumA = 0.0;
  double SumB = 0.0;
  double SquaresA = 0.0;
  double SquaresB = 0.0;
  double Products = 0.0;
};

/// Mean over all windows of 7 x 7 pixels of two pictures, given as RGB bytes row by row. Grey
/// values follow ITU-R BT.601. Pictures without such a window are compared as one window.
RELEVOFILTERSCORE_EXPORT double GetPictureSimilarity(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int columns, int rows);
}

#endif
