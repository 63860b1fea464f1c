// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Which way the lines of a grey image run, by its structure tensor (Bigun and Granlund, 1987), and
// how far that is from where a field points.
#ifndef RelevoOrientation_h
#define RelevoOrientation_h

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <vector>

// An image of real numbers; (column, row) from the lower left corner, rows one after the other.
struct RelevoGrey
{
  RelevoGrey(int columns, int rows)
    : Columns(columns)
    , Rows(rows)
    , Values(static_cast<std::size_t>(columns) * rows)
  {
  }
  double& At(int column, int row)
  {
    return this->Values[static_cast<std::size_t>(row) * this->Columns + column];
  }
  double At(int column, int row) const
  {
    return this->Values[static_cast<std::size_t>(row) * this->Columns + column];
  }

  int Columns;
  int Rows;
  std::vector<double> Values;
};

class RelevoOrientation
{
public:
  // Scales, in pixels: standard deviations of the Gaussians whose derivatives are the gradients,
  // and of the one that smooths the tensor.
  explicit RelevoOrientation(
    const RelevoGrey& image, double gradientScale = 1.0, double tensorScale = 3.0)
    : XX(image.Columns, image.Rows)
    , YY(image.Columns, image.Rows)
    , XY(image.Columns, image.Rows)
  {
    const std::vector<double> smooth = Gaussian(gradientScale);
    const std::vector<double> derivative = GaussianDerivative(gradientScale);
    const RelevoGrey gx = FilterRows(FilterColumns(image, smooth), derivative);
    const RelevoGrey gy = FilterColumns(FilterRows(image, smooth), derivative);
    for (std::size_t i = 0; i < gx.Values.size(); ++i)
    {
      this->XX.Values[i] = gx.Values[i] * gx.Values[i];
      this->YY.Values[i] = gy.Values[i] * gy.Values[i];
      this->XY.Values[i] = gx.Values[i] * gy.Values[i];
    }
    const std::vector<double> window = Gaussian(tensorScale);
    for (RelevoGrey* part : { &this->XX, &this->YY, &this->XY })
    {
      *part = FilterRows(FilterColumns(*part, window), window);
    }
  }

  int GetColumns() const { return this->XX.Columns; }
  int GetRows() const { return this->XX.Rows; }

  // Along the lines, in radians from the x axis, modulo pi.
  double GetAngle(int column, int row) const
  {
    const double difference = this->XX.At(column, row) - this->YY.At(column, row);
    return 0.5 * std::atan2(2.0 * this->XY.At(column, row), difference) + 0.5 * vtkMath::Pi();
  }

  // 1 where all gradients are parallel, 0 where none is more frequent than another.
  double GetCoherence(int column, int row) const
  {
    const double sum = this->XX.At(column, row) + this->YY.At(column, row);
    const double difference = this->XX.At(column, row) - this->YY.At(column, row);
    const double length = std::hypot(difference, 2.0 * this->XY.At(column, row));
    return sum > 0.0 ? length / sum : 0.0;
  }

private:
  static std::vector<double> Gaussian(double scale)
  {
    const int reach = static_cast<int>(std::ceil(4.0 * scale));
    std::vector<double> weights;
    double sum = 0.0;
    for (int k = -reach; k <= reach; ++k)
    {
      weights.push_back(std::exp(-0.5 * k * k / (scale * scale)));
      sum += weights.back();
    }
    for (double& weight : weights)
    {
      weight /= sum;
    }
    return weights;
  }

  static std::vector<double> GaussianDerivative(double scale)
  {
    std::vector<double> weights = Gaussian(scale);
    const int reach = static_cast<int>(weights.size() / 2);
    for (int k = -reach; k <= reach; ++k)
    {
      weights[k + reach] *= k / (scale * scale);
    }
    return weights;
  }

  // Correlated with weights along (stepX, stepY); the border goes on as it is.
  static RelevoGrey Filter(
    const RelevoGrey& image, const std::vector<double>& weights, int stepX, int stepY)
  {
    RelevoGrey result(image.Columns, image.Rows);
    const int reach = static_cast<int>(weights.size() / 2);
    for (int row = 0; row < image.Rows; ++row)
    {
      for (int column = 0; column < image.Columns; ++column)
      {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k)
        {
          const int x = std::min(std::max(column + k * stepX, 0), image.Columns - 1);
          const int y = std::min(std::max(row + k * stepY, 0), image.Rows - 1);
          sum += weights[k + reach] * image.At(x, y);
        }
        result.At(column, row) = sum;
      }
    }
    return result;
  }
  static RelevoGrey FilterRows(const RelevoGrey& image, const std::vector<double>& weights)
  {
    return Filter(image, weights, 1, 0);
  }
  static RelevoGrey FilterColumns(const RelevoGrey& image, const std::vector<double>& weights)
  {
    return Filter(image, weights, 0, 1);
  }

  RelevoGrey XX;
  RelevoGrey YY;
  RelevoGrey XY;
};

// Angles between lines and vectors, in degrees, in [0, 90].
struct RelevoDeviations
{
  double Median = 90.0;
  double Percentile95 = 90.0;
  std::size_t Count = 0;
};

inline std::ostream& operator<<(std::ostream& os, const RelevoDeviations& deviations)
{
  return os << "median " << deviations.Median << ", 95th percentile " << deviations.Percentile95
            << " degrees of " << deviations.Count << " pixels";
}

// Of the pixels for which field(column, row, vector) is true; it sets the vector there, two
// doubles.
template <typename Field>
RelevoDeviations MeasureDeviations(const RelevoOrientation& orientation, Field&& field)
{
  std::vector<double> angles;
  for (int row = 0; row < orientation.GetRows(); ++row)
  {
    for (int column = 0; column < orientation.GetColumns(); ++column)
    {
      double vector[2];
      if (field(column, row, vector))
      {
        const double difference =
          orientation.GetAngle(column, row) - std::atan2(vector[1], vector[0]);
        angles.push_back(
          vtkMath::DegreesFromRadians(std::abs(std::remainder(difference, vtkMath::Pi()))));
      }
    }
  }
  RelevoDeviations deviations;
  deviations.Count = angles.size();
  if (!angles.empty())
  {
    std::sort(angles.begin(), angles.end());
    deviations.Median = angles[angles.size() / 2];
    deviations.Percentile95 = angles[angles.size() * 95 / 100];
  }
  return deviations;
}

#endif
