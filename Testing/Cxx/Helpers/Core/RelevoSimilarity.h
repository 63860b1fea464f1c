// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The structural similarity index of pictures (Wang, Bovik, Sheikh and Simoncelli, Image Quality
// Assessment: From Error Visibility to Structural Similarity, 2004, equation 13).
#ifndef RelevoSimilarity_h
#define RelevoSimilarity_h

#include <cstddef>
#include <vector>

// Moments of two windows with grey values from 0 to 1.
class RelevoSimilarity
{
public:
  void Add(double a, double b);
  // Returns 1 for equal windows.
  double Get() const;

private:
  std::size_t Count = 0;
  double SumA = 0.0;
  double SumB = 0.0;
  double SquaresA = 0.0;
  double SquaresB = 0.0;
  double Products = 0.0;
};

// Mean over all windows of 7 x 7 pixels of two pictures, given as RGB bytes row by row. Grey values
// follow ITU-R BT.601.
double RelevoMeanSimilarity(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int columns, int rows);

#endif
