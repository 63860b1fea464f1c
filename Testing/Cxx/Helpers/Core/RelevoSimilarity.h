// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The structural similarity index of pictures (Wang, Bovik, Sheikh and Simoncelli, Image Quality
// Assessment: From Error Visibility to Structural Similarity, 2004, equation 13).
#ifndef RelevoSimilarity_h
#define RelevoSimilarity_h

#include <cstddef>
#include <vector>

// Two windows' moments; greys are from 0 to 1.
class RelevoSimilarity
{
public:
  void Add(double a, double b);
  // 1 for equal windows.
  double Get() const;

private:
  std::size_t Count = 0;
  double SumA = 0.0;
  double SumB = 0.0;
  double SquaresA = 0.0;
  double SquaresB = 0.0;
  double Products = 0.0;
};

// The mean over all windows of 7 x 7 pixels of two pictures, RGB bytes row by row. The grey is that
// of ITU-R BT.601.
double RelevoMeanSimilarity(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int columns, int rows);

#endif
