// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoOrientation.h"

RelevoGrey::RelevoGrey(int columns, int rows)
  : Columns(columns)
  , Rows(rows)
  , Values(static_cast<std::size_t>(columns) * rows)
{
}

double& RelevoGrey::At(int column, int row)
{
  return this->Values[static_cast<std::size_t>(row) * this->Columns + column];
}

double RelevoGrey::At(int column, int row) const
{
  return this->Values[static_cast<std::size_t>(row) * this->Columns + column];
}

RelevoOrientation::RelevoOrientation(
  const RelevoGrey& image, double gradientScale, double tensorScale)
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

double RelevoOrientation::GetAngle(int column, int row) const
{
  const double difference = this->XX.At(column, row) - this->YY.At(column, row);
  return 0.5 * std::atan2(2.0 * this->XY.At(column, row), difference) + 0.5 * vtkMath::Pi();
}

double RelevoOrientation::GetCoherence(int column, int row) const
{
  const double sum = this->XX.At(column, row) + this->YY.At(column, row);
  const double difference = this->XX.At(column, row) - this->YY.At(column, row);
  const double length = std::hypot(difference, 2.0 * this->XY.At(column, row));
  return sum > 0.0 ? length / sum : 0.0;
}

std::vector<double> RelevoOrientation::Gaussian(double scale)
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

std::vector<double> RelevoOrientation::GaussianDerivative(double scale)
{
  std::vector<double> weights = Gaussian(scale);
  const int reach = static_cast<int>(weights.size() / 2);
  for (int k = -reach; k <= reach; ++k)
  {
    weights[k + reach] *= k / (scale * scale);
  }
  return weights;
}

RelevoGrey RelevoOrientation::Filter(
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

RelevoGrey RelevoOrientation::FilterRows(
  const RelevoGrey& image, const std::vector<double>& weights)
{
  return Filter(image, weights, 1, 0);
}

RelevoGrey RelevoOrientation::FilterColumns(
  const RelevoGrey& image, const std::vector<double>& weights)
{
  return Filter(image, weights, 0, 1);
}

std::ostream& operator<<(std::ostream& os, const RelevoDeviations& deviations)
{
  return os << "median " << deviations.Median << ", 95th percentile " << deviations.Percentile95
            << " degrees of " << deviations.Count << " pixels";
}
