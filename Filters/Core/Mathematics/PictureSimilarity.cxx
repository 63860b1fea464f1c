// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mathematics/PictureSimilarity.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr int LargestWindow = 7;

std::vector<double> GetGreys(const std::vector<unsigned char>& picture)
{
  std::vector<double> greys;
  for (std::size_t i = 0; i + 2 < picture.size(); i += 3)
  {
    greys.push_back((0.299 * picture[i] + 0.587 * picture[i + 1] + 0.114 * picture[i + 2]) / 255.0);
  }
  return greys;
}
}

void WindowSimilarity::Add(double a, double b)
{
  ++this->Count;
  this->SumA += a;
  this->SumB += b;
  this->SquaresA += a * a;
  this->SquaresB += b * b;
  this->Products += a * b;
}

double WindowSimilarity::Get() const
{
  const double count = static_cast<double>(this->Count);
  const double meanA = this->SumA / count;
  const double meanB = this->SumB / count;
  const double varianceA = this->SquaresA / count - meanA * meanA;
  const double varianceB = this->SquaresB / count - meanB * meanB;
  const double covariance = this->Products / count - meanA * meanB;
  const double c1 = 1e-4;
  const double c2 = 9e-4;
  return (2.0 * meanA * meanB + c1) * (2.0 * covariance + c2) /
    ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

double GetPictureSimilarity(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int columns, int rows)
{
  const std::vector<double> greysA = GetGreys(a);
  const std::vector<double> greysB = GetGreys(b);
  const int width = std::min(columns, LargestWindow);
  const int height = std::min(rows, LargestWindow);
  double sum = 0.0;
  std::size_t count = 0;
  for (int row = 0; row + height <= rows; ++row)
  {
    for (int column = 0; column + width <= columns; ++column)
    {
      WindowSimilarity window;
      for (int i = 0; i < width * height; ++i)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(row + i / width) * columns + column + i % width;
        window.Add(greysA[pixel], greysB[pixel]);
      }
      sum += window.Get();
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}
}
